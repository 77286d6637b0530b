// SPDX-License-Identifier: BSD-3-Clause
// Where links are: the kinematics of docs/scenarios.md, as analysis/scene.py and spatial_scene.py have it.

import type { DenavitHartenbergRobot, PlanarRobot, Robot, UniversalRobot, Vector } from "../model";
import { add } from "./vectors";

export interface Link {
  from: Vector;
  to: Vector;
  radius: number;
}

type Frame = number[][]; // rows of a rotation matrix

/** All links of a robot in a configuration, as its scenario's file counts joints. */
export function place(robot: Robot, row: Vector): Link[] {
  switch (robot.kind) {
    case "planar":
      return placePlanar(robot, row);
    case "universal":
      return placeUniversal(robot, row);
    case "dh":
      return placeDenavitHartenberg(robot, row);
  }
}

/** The base, moved along its rail, and the joints that are left. */
function split(robot: PlanarRobot | UniversalRobot, row: Vector): [Vector, Vector] {
  return robot.slide ? [add(robot.base, robot.slide, row[0]), row.slice(1)] : [robot.base, row];
}

function placePlanar(robot: PlanarRobot, row: Vector): Link[] {
  const [base, joints] = split(robot, row);
  const angles: number[] = [];
  const links: Link[] = [];
  robot.lengths.forEach((length, i) => {
    const parent = robot.parents[i];
    angles.push(joints[i] + (robot.relative && parent >= 0 ? angles[parent] : 0));
    const from = parent >= 0 ? links[parent].to : base;
    const to = [from[0] + length * Math.cos(angles[i]), from[1] + length * Math.sin(angles[i])];
    links.push({ from, to, radius: robot.radii[i] });
  });
  return links;
}

/** frame times a turn about its own axis 0, 1 or 2 */
export function turned(frame: Frame, axis: number, angle: number): Frame {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
  return frame.map((row) => {
    const result = [...row];
    result[j] = c * row[j] + s * row[k];
    result[k] = c * row[k] - s * row[j];
    return result;
  });
}

function column(frame: Frame, axis: number): Vector {
  return frame.map((row) => row[axis]);
}

const LEVEL: Frame = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function placeUniversal(robot: UniversalRobot, row: Vector): Link[] {
  let [from, joints] = split(robot, row);
  let frame = LEVEL;
  return robot.lengths.map((length, i) => {
    frame = turned(turned(frame, 1, joints[2 * i]), 2, joints[2 * i + 1]);
    const link = { from, to: add(from, column(frame, 0), length), radius: robot.radii[i] };
    from = link.to;
    return link;
  });
}

function placeDenavitHartenberg(robot: DenavitHartenbergRobot, row: Vector): Link[] {
  let from = robot.base;
  let frame: Frame = robot.frame;
  const links: Link[] = [];
  robot.rows.forEach(([theta, d, a, alpha], i) => {
    frame = turned(frame, 2, row[i] + theta);
    for (const [length, axis] of [
      [d, 2],
      [a, 0],
    ]) {
      if (length === 0) continue;
      const to = add(from, column(frame, axis), length);
      links.push({ from, to, radius: robot.radii[links.length] });
      from = to;
    }
    frame = turned(frame, 0, alpha);
  });
  return links;
}
