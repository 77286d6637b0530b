// SPDX-License-Identifier: BSD-3-Clause
// Which part of the plane a canvas shows.

import type { Vector } from "../model";

export interface Camera {
  center: Vector;
  scale: number; // pixels per unit of length
}

/** All of some points, with a margin. */
export function fit(points: Vector[], width: number, height: number, margin: number): Camera {
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const pad = 0.06 * Math.max(right - left, top - bottom) + margin;
  const scale = Math.min(
    width / Math.max(right - left + 2 * pad, 1e-9),
    height / Math.max(top - bottom + 2 * pad, 1e-9),
  );
  return { center: [(left + right) / 2, (bottom + top) / 2], scale };
}

/** Zooms so that what is under a pixel stays there. \param pixel from the middle of the canvas, y up */
export function zoomed(camera: Camera, factor: number, pixel: Vector = [0, 0]): Camera {
  const scale = camera.scale * factor;
  const shift = 1 / camera.scale - 1 / scale;
  return { center: [camera.center[0] + pixel[0] * shift, camera.center[1] + pixel[1] * shift], scale };
}

export function panned(camera: Camera, dx: number, dy: number): Camera {
  return { ...camera, center: [camera.center[0] - dx / camera.scale, camera.center[1] - dy / camera.scale] };
}
