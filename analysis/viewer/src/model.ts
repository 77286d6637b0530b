// SPDX-License-Identifier: BSD-3-Clause
// What the page is told: the JSON that analysis/report.py embeds. null is "not measured".

import type { Value } from "./table";

export type Vector = number[];

export interface PlanarRobot {
  kind: "planar";
  base: Vector;
  slide?: Vector;
  lengths: number[];
  parents: number[]; // 0-based, -1 is the base
  relative: boolean; // angles are counted from the parent
  radii: number[];
}

export interface UniversalRobot {
  kind: "universal"; // pitch about y, then yaw about z, then the link along x
  base: Vector;
  slide?: Vector;
  lengths: number[];
  radii: number[];
}

export interface DenavitHartenbergRobot {
  kind: "dh";
  base: Vector;
  frame: number[][];
  rows: [theta: number, d: number, a: number, alpha: number][];
  radii: number[]; // one per link that has a length
}

export type Robot = PlanarRobot | UniversalRobot | DenavitHartenbergRobot;

export interface Obstacle {
  name: string;
  circle?: [x: number, y: number, radius: number];
  outline?: Vector[];
  vertices?: Vector[];
  triangles?: [number, number, number][];
}

export interface Scene {
  name: string;
  dimension: number; // of a configuration
  robot: Robot;
  obstacles: Obstacle[];
  leftOut: number; // obstacles with too many triangles for a page
  rail?: Vector[];
  target?: { point: Vector; tolerance: number };
  tipPath?: Vector[];
}

/** The plane of joint space that HPPM followed a curve in; places are (lambda, s). */
export interface Slice {
  status: string;
  joins: boolean;
  bottleneck: number;
  spacing: number;
  lambda: [number, number];
  deviation: number; // s goes from -deviation to deviation
  tracedFrom: string;
  columns: number;
  rows: number; // from the lowest s up
  obstacles: { name: string; bits: string }[];
  curve: Vector[];
  rejected: Vector[];
  path: Vector[];
  middle: Vector[]; // configurations at s = 0, evenly from lambda[0] to lambda[1]
  direction: Vector; // what s adds, per radian
}

export interface Motion {
  scene: number;
  run: number; // the run's id
  why: string;
  path: Vector[];
  stored: number; // waypoints before thinning
  slice: Slice | null;
}

export interface Contest {
  group: string;
  ours: string;
  theirs: string;
  ours_solved: number;
  theirs_solved: number;
  ours_cpu: number | null;
  theirs_cpu: number | null;
  pairs: number;
  p: number;
  adjusted: number;
  winner: "ours" | "theirs" | "undecided";
  lead: number | null;
}

export interface SummaryRow {
  group: string;
  planner: string;
  ours: boolean;
  prescribed: boolean;
  instances: number;
  runs: number;
  solved: number;
  share: number;
  low: number;
  high: number;
  cpu: number | null;
  cpu_lower: number | null;
  cpu_upper: number | null;
  evaluations: number | null;
  checks: number | null;
  length: number | null;
  clearance: number | null;
}

export interface Coded {
  texts: string[];
  codes: number[];
}

export interface RunColumns {
  id: number[];
  run: number[];
  seed: number[];
  instance: Coded;
  planner: Coded;
  outcome: Coded;
  reason: Coded;
  cpu: (number | null)[];
  evaluations: (number | null)[];
  checks: (number | null)[];
  length: (number | null)[];
  clearance: (number | null)[];
  limit: number[];
  solved: number[];
}

export interface IntervalRow {
  planner: string;
  ours: boolean;
  share: number;
  low: number;
  high: number;
  solved: number;
  runs: number;
}

export interface Series {
  name: string;
  ours: boolean;
  x: number[];
  y: number[];
}

export interface StackRow {
  planner: string;
  counts: Record<string, number>;
}

export interface IntervalsPanel {
  name: string;
  rows: IntervalRow[];
}

export interface StepsPanel {
  name: string;
  series: Series[];
  end: number; // where curves stop
}

export interface TrendPanel {
  name: string;
  series: Series[]; // rising in x; both axes logarithmic
}

export interface HeatPanel {
  name: string;
  rows: string[];
  columns: string[];
  shares: (number | null)[][];
  values: (number | null)[][];
}

export interface StackedPanel {
  name: string;
  rows: StackRow[];
}

export interface PhasePanel {
  name: string;
  rows: number[]; // links
  columns: number[]; // half widths, rising
  shares: (number | null)[][];
  runs: number[][];
  line: [half: number, low: number, high: number][]; // per row; empty if there is none
  failure: string; // why there is no line
}

interface FigureHead {
  id: string;
  title: string;
  note: string;
  x: string;
  y: string;
}

export type Figure =
  | (FigureHead & { kind: "intervals"; panels: IntervalsPanel[] })
  | (FigureHead & { kind: "steps"; panels: StepsPanel[] })
  | (FigureHead & { kind: "trend"; panels: TrendPanel[] })
  | (FigureHead & { kind: "heat"; panels: HeatPanel[] })
  | (FigureHead & { kind: "phase"; panels: PhasePanel[] })
  | (FigureHead & { kind: "stacked"; panels: StackedPanel[] });

export interface NamedTable {
  id: string;
  title: string;
  note: string;
  columns: { title: string; hint?: string }[];
  rows: Value[][];
}

export interface Report {
  tables: NamedTable[]; // hypotheses, slopes, quality: whatever the campaign has
  campaign: { name: string; seed: number; engine: string; file: string };
  sessions: Record<string, string | number | null>[];
  verdict: { headline: string; sentences: string[]; notes: string[] };
  contests: Contest[];
  entries: { name: string; ours: boolean; settings: string }[];
  groups: SummaryRow[];
  totals: SummaryRow[];
  runs: RunColumns;
  figures: Figure[];
  scenes: Scene[];
  motions: Motion[];
  leftOut: { paths: number; instances: number; shown: number; runs: number; slices: number; panels: number };
}
