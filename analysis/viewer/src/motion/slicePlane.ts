// SPDX-License-Identifier: BSD-3-Clause
// The plane (lambda, s) that HPPM followed a curve in: configurations from places, and places from configurations.

import type { Slice, Vector } from "../model";
import { add, clamp, dot, mix, norm, subtract } from "./vectors";

/** The configuration at a place. */
export function configuration(slice: Slice, lambda: number, s: number): Vector {
  const last = slice.middle.length - 1;
  const at = clamp(((lambda - slice.lambda[0]) / (slice.lambda[1] - slice.lambda[0])) * last, 0, last);
  const i = Math.min(Math.floor(at), last - 1);
  return add(mix(slice.middle[i], slice.middle[i + 1], at - i), slice.direction, s);
}

const NEAR = 0.02; // radians that a configuration may be off the plane and still be shown in it

/** The place of a configuration, null if it is off the plane. */
export function placeOf(slice: Slice, row: Vector): [lambda: number, s: number] | null {
  const { middle, direction } = slice;
  const square = dot(direction, direction);
  // Orthogonal to the direction, a configuration depends on lambda alone.
  const across = (a: Vector): Vector => add(a, direction, -dot(a, direction) / square);
  const wanted = across(row);
  let [best, at] = [Infinity, 0];
  for (let i = 0; i + 1 < middle.length; ++i) {
    const [from, to] = [across(middle[i]), across(middle[i + 1])];
    const along = subtract(to, from);
    const length = dot(along, along);
    const share = length > 0 ? clamp(dot(subtract(wanted, from), along) / length, 0, 1) : 0;
    const distance = norm(subtract(wanted, add(from, along, share)));
    if (distance < best) [best, at] = [distance, i + share];
  }
  if (best > NEAR) return null;
  const lambda = slice.lambda[0] + ((slice.lambda[1] - slice.lambda[0]) * at) / (middle.length - 1);
  return [lambda, dot(subtract(row, configuration(slice, lambda, 0)), direction) / square];
}

/** A picture's bits, row after row from the lowest s up. */
export function unpack(bits: string, count: number): Uint8Array {
  const bytes = atob(bits);
  return Uint8Array.from({ length: count }, (_, i) => (bytes.charCodeAt(i >> 3) >> (7 - (i & 7))) & 1);
}
