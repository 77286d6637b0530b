// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";

import fixture from "./kinematics.json";
import type { Obstacle, Robot, Slice, Vector } from "../src/model";
import { fit, zoomed } from "../src/motion/camera";
import {
  affordable,
  clearance,
  curve,
  inside,
  pointToSegment,
  segmentToSegment,
  segmentToTriangle,
} from "../src/motion/clearance";
import { place } from "../src/motion/kinematics";
import { configuration, placeOf, unpack } from "../src/motion/slicePlane";
import { advance, Timeline, toggled } from "../src/motion/timeline";
import { add, norm, subtract } from "../src/motion/vectors";

/** Numbers between -1 and 1, the same in every run. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => (state = (1103515245 * state + 12345) % 2147483648) / 1073741824 - 1;
}

describe("kinematics", () => {
  // Made by scene.py and spatial_scene.py; tests/python/test_report.py sees to it that they still say so.
  const cases = fixture as unknown as { name: string; robot: Robot; row: Vector; segments: [Vector, Vector][] }[];

  it.each(cases.map((c) => [c.name, c] as const))("%s stands where Python puts it", (_, { robot, row, segments }) => {
    const links = place(robot, row);
    expect(links.length).toBe(segments.length);
    links.forEach((link, i) => {
      expect(norm(subtract(link.from, segments[i][0]))).toBeLessThan(1e-12);
      expect(norm(subtract(link.to, segments[i][1]))).toBeLessThan(1e-12);
    });
  });
});

describe("timelines", () => {
  const path = [
    [0, 0],
    [3, 0],
    [3, 1],
  ];
  const timeline = new Timeline(path);

  it("move evenly in joint space and end where the path ends", () => {
    expect(timeline.length).toBe(4);
    expect([0, 0.375, 0.75, 0.875, 1].map((t) => timeline.at(t))).toEqual([
      [0, 0],
      [1.5, 0],
      [3, 0],
      [3, 0.5],
      [3, 1],
    ]);
    expect(timeline.at(1)).toBe(path[2]);
    expect(timeline.poses(5).map(([x]) => x)).toEqual([0, 1, 2, 3, 3]);
  });

  it("stay where a path does not move", () => expect(new Timeline([[1], [1]]).at(0.5)).toEqual([1]));

  it("stop at the end, or begin anew after a rest", () => {
    const state = { progress: 0.9, playing: true, loop: false, speed: 1 };
    expect(advance(state, 1)).toEqual({ ...state, progress: 1, playing: false });
    const looped = advance({ ...state, loop: true }, 0.6);
    expect(looped).toMatchObject({ playing: true });
    expect(looped.progress).toBeCloseTo(1.02, 12);
    expect(advance(looped, 1).progress).toBe(0);
    expect(advance({ ...state, playing: false }, 1).progress).toBe(0.9);
  });

  it("play begins anew at the end", () => {
    const state = { progress: 1, playing: false, loop: false, speed: 1 };
    expect(toggled(state)).toEqual({ ...state, playing: true, progress: 0 });
    expect(toggled({ ...state, progress: 0.4 }).progress).toBe(0.4);
  });
});

describe("distances", () => {
  const random = numbers(7);
  const point = (n: number): Vector => Array.from({ length: n }, random);

  it("of segments are what a search over both finds", () => {
    for (const n of [2, 3])
      for (let k = 0; k < 40; ++k) {
        const [a, b, c, d] = [point(n), point(n), point(n), point(n)];
        let least = Infinity;
        for (let i = 0; i <= 400; ++i) least = Math.min(least, pointToSegment(add(a, subtract(b, a), i / 400), c, d));
        const exact = segmentToSegment(a, b, c, d);
        expect(exact).toBeLessThanOrEqual(least + 1e-12);
        expect(least - exact).toBeLessThan(norm(subtract(b, a)) / 400);
      }
  });

  it("of parallel segments are those of their ends", () =>
    expect(segmentToSegment([0, 0], [4, 0], [1, 2], [2, 2])).toBe(2));

  it("of a segment to a triangle are what a search over the triangle finds", () => {
    for (let k = 0; k < 40; ++k) {
      const [a, b, ...corners] = [point(3), point(3), point(3), point(3), point(3)];
      const exact = segmentToTriangle(a, b, corners);
      let least = Infinity;
      for (let i = 0; i <= 60; ++i)
        for (let j = 0; i + j <= 60; ++j) {
          const p = add(
            add(corners[0], subtract(corners[1], corners[0]), i / 60),
            subtract(corners[2], corners[0]),
            j / 60,
          );
          least = Math.min(least, pointToSegment(p, a, b));
        }
      expect(exact).toBeLessThanOrEqual(least + 1e-12);
      expect(least - exact).toBeLessThan(0.08);
    }
  });

  it("are 0 where a segment pierces a triangle", () =>
    expect(
      segmentToTriangle(
        [0.2, 0.2, -1],
        [0.2, 0.2, 1],
        [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
        ],
      ),
    ).toBe(0));

  it("tell inside from outside", () => {
    const square = [
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
    ];
    expect(
      [
        [1, 1],
        [3, 1],
        [-1, 1],
        [1, 3],
      ].map((p) => inside(p, square)),
    ).toEqual([true, false, false, false]);
  });

  it("of an arm are from surface to surface", () => {
    const links = [{ from: [0, 0], to: [1, 0], radius: 0.1 }];
    const circle: Obstacle = { name: "c", circle: [0.5, 2, 0.5] };
    const wall: Obstacle = {
      name: "w",
      outline: [
        [3, -1],
        [4, -1],
        [4, 1],
        [3, 1],
      ],
    };
    expect(clearance(links, [circle])).toBeCloseTo(1.4, 12);
    expect(clearance(links, [circle, wall])).toBeCloseTo(1.4, 12);
    expect(
      clearance(links, [
        {
          name: "around",
          outline: [
            [-1, -1],
            [2, -1],
            [2, 1],
            [-1, 1],
          ],
        },
      ]),
    ).toBe(-0.1);
    expect(clearance(links, [])).toBe(Infinity);
    expect(affordable(3, [circle])).toBe(300);
    expect(affordable(100, [{ name: "mesh", triangles: Array(20000).fill([0, 1, 2]) }])).toBe(24);
  });

  it("to meshes look at every triangle that may matter", () => {
    const vertices = [
      [0, 0, 1],
      [1, 0, 1],
      [0, 1, 1],
      [0, 0, 9],
      [1, 0, 9],
      [0, 1, 9],
    ];
    const mesh: Obstacle = {
      name: "m",
      vertices,
      triangles: [
        [3, 4, 5],
        [0, 1, 2],
      ],
    };
    expect(clearance([{ from: [0.2, 0.2, 0], to: [0.3, 0.3, 0], radius: 0.25 }], [mesh])).toBeCloseTo(0.75, 12);
  });
});

describe("curves", () => {
  const valley = (x: number): number => Math.min(Math.abs(x - 0.43217), 0.1 + Math.abs(x - 0.9));

  it("reach the bottom of a valley between their samples", () => {
    const points = curve(valley, 11);
    expect(Math.min(...points.map(([, value]) => value))).toBeLessThan(1e-4);
    expect(points.every(([x, value]) => value === valley(x))).toBe(true);
    expect(points.map(([x]) => x)).toEqual([...points.map(([x]) => x)].sort((a, b) => a - b));
    expect([points[0][0], points[points.length - 1][0]]).toEqual([0, 1]);
  });

  it("of nothing to keep away from are infinite", () =>
    expect(curve(() => Infinity, 5).every(([, v]) => v === Infinity)).toBe(true));
});

describe("the slice", () => {
  // Configurations bend with lambda, as under a schedule.
  const middle = Array.from({ length: 11 }, (_, i) => [i / 10, (i / 10) ** 2, 1]);
  const slice = { lambda: [-0.5, 1.5], deviation: 2, middle, direction: [0, 0, 1] } as unknown as Slice;

  it("gives configurations, and their places back", () => {
    for (const [lambda, s] of [
      [-0.5, 0],
      [0.33, 1.2],
      [1.5, -2],
      [0.9, 0.01],
    ]) {
      const found = placeOf(slice, configuration(slice, lambda, s))!;
      expect(found[0]).toBeCloseTo(lambda, 10);
      expect(found[1]).toBeCloseTo(s, 10);
    }
    expect(configuration(slice, 0.5, 0.25)).toEqual([0.5, 0.25, 1.25]);
  });

  it("has no place for what is off the plane", () => expect(placeOf(slice, [0.5, 0.9, 1])).toBeNull());

  it("unpacks bits from the highest of each byte on", () =>
    expect([...unpack(btoa(String.fromCharCode(0b10110000, 0b01000000)), 11)]).toEqual([
      1, 0, 1, 1, 0, 0, 0, 0, 0, 1, 0,
    ]));
});

describe("cameras", () => {
  it("fit what they are given", () => {
    const { center, scale } = fit(
      [
        [0, 0],
        [4, 2],
      ],
      448,
      448,
      0,
    );
    expect(center).toEqual([2, 1]);
    expect(scale).toBeCloseTo(100, 10);
  });

  it("keep what is under the pointer when they zoom", () => {
    const [before, pixel] = [{ center: [1, 2], scale: 50 }, [30, -20]];
    const after = zoomed(before, 3, pixel);
    const under = (c: typeof before): Vector => [c.center[0] + pixel[0] / c.scale, c.center[1] + pixel[1] / c.scale];
    expect(norm(subtract(under(before), under(after)))).toBeLessThan(1e-12);
    expect(after.scale).toBe(150);
  });
});
