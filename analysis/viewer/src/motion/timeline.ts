// SPDX-License-Identifier: BSD-3-Clause
// A path as something that can be played: progress 0 to 1, even in joint space, straight between waypoints.

import type { Vector } from "../model";
import { mix, norm, subtract } from "./vectors";

export class Timeline {
  private readonly along: number[] = [0];

  /** \param path at least one waypoint */
  constructor(private readonly path: Vector[]) {
    for (let i = 1; i < path.length; ++i) this.along.push(this.along[i - 1] + norm(subtract(path[i], path[i - 1])));
  }

  /** In joint space. */
  get length(): number {
    return this.along[this.along.length - 1];
  }

  /** The configuration at a share of the way; 0 and 1 are the path's own ends. */
  at(progress: number): Vector {
    const last = this.path.length - 1;
    if (progress <= 0 || last === 0) return this.path[0];
    if (progress >= 1) return this.path[last];
    const wanted = progress * this.length;
    let [low, high] = [0, last];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.along[middle] <= wanted) low = middle;
      else high = middle;
    }
    const step = this.along[high] - this.along[low];
    return mix(this.path[low], this.path[high], step > 0 ? (wanted - this.along[low]) / step : 0);
  }

  /** `count` configurations evenly over the way, both ends among them. */
  poses(count: number): Vector[] {
    return Array.from({ length: count }, (_, i) => this.at(i / (count - 1)));
  }
}

export interface Playback {
  progress: number;
  playing: boolean;
  loop: boolean;
  speed: number;
}

const SECONDS = 5; // for a motion at speed 1
const REST = 0.12; // how long a loop waits at its end, over the motion's own duration

/** What is played `seconds` later. A loop rests at the goal (progress beyond 1) before it begins anew. */
export function advance(state: Playback, seconds: number): Playback {
  if (!state.playing) return state;
  const progress = state.progress + (seconds * state.speed) / SECONDS;
  if (state.loop) return { ...state, progress: progress > 1 + REST ? 0 : progress };
  return progress >= 1 ? { ...state, progress: 1, playing: false } : { ...state, progress };
}

/** Play or pause; at the end, play begins anew. */
export function toggled(state: Playback): Playback {
  return { ...state, playing: !state.playing, progress: !state.playing && state.progress >= 1 ? 0 : state.progress };
}
