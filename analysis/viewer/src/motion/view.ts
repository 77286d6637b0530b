// SPDX-License-Identifier: BSD-3-Clause
// What views of a moving arm have in common.

import type { Scene, Vector } from "../model";
import type { Timeline } from "./timeline";

export interface Shown {
  row: Vector; // the configuration on show
  probe: Vector | null; // another one that the reader points at in the slice
  sweep: boolean; // all poses of the way
}

export interface ArmView {
  readonly element: HTMLElement;
  draw(shown: Shown): void;
  zoom(factor: number): void; // above 1: nearer
  reset(): void;
  dispose(): void;
}

export type MakeView = (scene: Scene, timeline: Timeline) => ArmView;

export const SWEPT = 48; // poses of a sweep

const VIRIDIS = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [220, 215, 50],
];

/** From dark (the start) to bright (the goal), each channel 0 to 255. */
export function sweepColour(progress: number): [number, number, number] {
  const at = Math.min(0.9999, Math.max(0, progress)) * (VIRIDIS.length - 1);
  const i = Math.floor(at);
  const [a, b] = [VIRIDIS[i], VIRIDIS[i + 1]];
  return [0, 1, 2].map((k) => Math.round(a[k] + (at - i) * (b[k] - a[k]))) as [number, number, number];
}
