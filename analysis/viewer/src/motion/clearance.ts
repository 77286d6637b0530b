// SPDX-License-Identifier: BSD-3-Clause
// Distances of links to obstacles as they are drawn. The verdict on a path is the verifier's, not this one's.

import type { Obstacle, Vector } from "../model";
import type { Link } from "./kinematics";
import { add, clamp, cross, dot, norm, subtract } from "./vectors";

/** Distance of a point to the segment from a to b. */
export function pointToSegment(point: Vector, a: Vector, b: Vector): number {
  const along = subtract(b, a);
  const square = dot(along, along);
  const share = square > 0 ? clamp(dot(subtract(point, a), along) / square, 0, 1) : 0;
  return norm(subtract(point, add(a, along, share)));
}

/** Distance of two segments, in the plane or in space. */
export function segmentToSegment(a: Vector, b: Vector, c: Vector, d: Vector): number {
  const [u, v, w] = [subtract(b, a), subtract(d, c), subtract(a, c)];
  const [uu, uv, vv, uw, vw] = [dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)];
  const determinant = uu * vv - uv * uv;
  if (determinant > 1e-14 * uu * vv) {
    const s = (uv * vw - vv * uw) / determinant;
    const t = (uu * vw - uv * uw) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return norm(subtract(add(a, u, s), add(c, v, t)));
  }
  // Nearest with an end of one of them (or parallel, where an end is as near as any).
  return Math.min(pointToSegment(a, c, d), pointToSegment(b, c, d), pointToSegment(c, a, b), pointToSegment(d, a, b));
}

/** Is a point of the plane within a closed outline? */
export function inside(point: Vector, outline: Vector[]): boolean {
  let result = false;
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length];
    if (a[1] > point[1] !== b[1] > point[1] && point[0] < a[0] + ((point[1] - a[1]) / (b[1] - a[1])) * (b[0] - a[0]))
      result = !result;
  });
  return result;
}

function toOutline(link: Link, outline: Vector[]): number {
  if (inside(link.from, outline)) return 0;
  let least = Infinity;
  outline.forEach(
    (a, i) => (least = Math.min(least, segmentToSegment(link.from, link.to, a, outline[(i + 1) % outline.length]))),
  );
  return least;
}

/** Does the foot of a point on a triangle's plane lie within it? \return its distance to the plane, else infinity */
function pointOverTriangle(point: Vector, corners: Vector[], normal: Vector): number {
  for (let i = 0; i < 3; ++i) {
    const edge = subtract(corners[(i + 1) % 3], corners[i]);
    if (dot(cross(edge, subtract(point, corners[i])), normal) < 0) return Infinity;
  }
  return Math.abs(dot(subtract(point, corners[0]), normal));
}

/** Distance of a segment to a triangle in space. */
export function segmentToTriangle(a: Vector, b: Vector, corners: Vector[]): number {
  const raw = cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0]));
  const size = norm(raw);
  let least = Infinity;
  for (let i = 0; i < 3; ++i) least = Math.min(least, segmentToSegment(a, b, corners[i], corners[(i + 1) % 3]));
  if (!(size > 0)) return least;
  const normal = raw.map((value) => value / size);
  const [before, after] = [dot(subtract(a, corners[0]), normal), dot(subtract(b, corners[0]), normal)];
  if (before * after < 0) {
    const through = add(a, subtract(b, a), before / (before - after));
    if (pointOverTriangle(through, corners, normal) < Infinity) return 0;
  }
  return Math.min(least, pointOverTriangle(a, corners, normal), pointOverTriangle(b, corners, normal));
}

function toMesh(link: Link, obstacle: Obstacle, best: number): number {
  let least = best;
  for (const triangle of obstacle.triangles ?? []) {
    const corners = triangle.map((i) => obstacle.vertices![i]);
    const reach = Math.max(norm(subtract(corners[1], corners[0])), norm(subtract(corners[2], corners[0])));
    if (pointToSegment(corners[0], link.from, link.to) - reach >= least) continue; // too far to matter
    least = Math.min(least, segmentToTriangle(link.from, link.to, corners));
  }
  return least;
}

/** Least distance of an arm's surface to any obstacle; not positive where they touch, infinite without obstacles. */
export function clearance(links: Link[], obstacles: Obstacle[]): number {
  let least = Infinity;
  for (const link of links)
    for (const obstacle of obstacles) {
      let axis: number;
      if (obstacle.circle) axis = pointToSegment(obstacle.circle.slice(0, 2), link.from, link.to) - obstacle.circle[2];
      else if (obstacle.outline) axis = toOutline(link, obstacle.outline);
      else axis = toMesh(link, obstacle, least + link.radius);
      least = Math.min(least, axis - link.radius);
    }
  return least;
}

const WORK = 3e6; // pairs of a link and an edge or triangle that one motion may cost

/** How many poses of a motion can be looked at without keeping the reader waiting. */
export function affordable(links: number, obstacles: Obstacle[]): number {
  const parts = obstacles.reduce((sum, { outline, triangles }) => sum + (outline?.length ?? triangles?.length ?? 1), 0);
  return clamp(Math.round(WORK / Math.max(1, parts * links)), 24, 300);
}

export type Curve = [progress: number, value: number][];

const REFINED = 3; // valleys that are looked into
const HALVINGS = 14; // of a valley's width

/** A function over [0, 1]: `count` values evenly, and the deepest valleys between them as deep as they are. */
export function curve(value: (progress: number) => number, count: number): Curve {
  const points: Curve = Array.from({ length: count }, (_, i) => [i / (count - 1), value(i / (count - 1))]);
  const valleys = points
    .map((_, i) => i)
    .filter((i) => [i - 1, i + 1].every((k) => points[k] === undefined || points[k][1] >= points[i][1]))
    .sort((a, b) => points[a][1] - points[b][1])
    .slice(0, REFINED);
  const found = valleys.map((i): Curve => descend(value, points[i], 1 / (count - 1)));
  return [...points, ...found.flat()].sort((a, b) => a[0] - b[0]);
}

/** From the middle of a valley on, by halving steps. \return what was tried */
function descend(value: (progress: number) => number, [progress, least]: [number, number], width: number): Curve {
  const tried: Curve = [];
  let [best, lowest] = [progress, least];
  for (let k = 0, step = width / 2; k < HALVINGS; ++k, step /= 2)
    for (const at of [best - step, best + step]) {
      if (at < 0 || at > 1) continue;
      const now = value(at);
      tried.push([at, now]);
      if (now < lowest) [best, lowest] = [at, now];
    }
  return tried;
}
