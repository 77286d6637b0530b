// SPDX-License-Identifier: BSD-3-Clause
// Points and directions in the plane (2 numbers) or in space (3), without surprises: nothing is changed in place.

import type { Vector } from "../model";

export function add(a: Vector, b: Vector, factor = 1): Vector {
  return a.map((value, i) => value + factor * b[i]);
}

export function subtract(a: Vector, b: Vector): Vector {
  return a.map((value, i) => value - b[i]);
}

export function dot(a: Vector, b: Vector): number {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += a[i] * b[i];
  return sum;
}

export function norm(a: Vector): number {
  return Math.sqrt(dot(a, a));
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function mix(a: Vector, b: Vector, share: number): Vector {
  return a.map((value, i) => value + share * (b[i] - value));
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}
