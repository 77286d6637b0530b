// SPDX-License-Identifier: BSD-3-Clause
// Which motions there are, by scene and planner, and what the rows say of their runs.

import type { Motion, Report } from "../model";

export interface RunFacts {
  instance: string;
  planner: string;
  run: number;
  seed: number;
  outcome: string;
  reason: string;
  solved: boolean;
  cpu: number | null;
  evaluations: number | null;
  length: number | null;
  clearance: number | null;
  limit: number;
}

export class Catalogue {
  private readonly rowOf = new Map<number, number>();
  private readonly motionOf = new Map<number, number>();

  constructor(readonly report: Report) {
    report.runs.id.forEach((id, row) => this.rowOf.set(id, row));
    report.motions.forEach((motion, index) => this.motionOf.set(motion.run, index));
  }

  /** What is known of a run, by its id. \throws Error if the page does not list it */
  facts(id: number): RunFacts {
    const row = this.rowOf.get(id);
    if (row === undefined) throw new Error(`run ${id} is not on this page`);
    return factsOf(this.report, row);
  }

  /** The number of a run's motion, undefined if it has none here. */
  motion(run: number): number | undefined {
    return this.motionOf.get(run);
  }

  /** Planners with a motion in a scene, in the order of the report. */
  planners(scene: number): string[] {
    return [...new Set(this.of(scene).map(({ run }) => this.facts(run).planner))];
  }

  /** A planner's motions in a scene, with their numbers. */
  motions(scene: number, planner: string): { index: number; motion: Motion }[] {
    return this.report.motions
      .map((motion, index) => ({ index, motion }))
      .filter(({ motion }) => motion.scene === scene && this.facts(motion.run).planner === planner);
  }

  private of(scene: number): Motion[] {
    return this.report.motions.filter((motion) => motion.scene === scene);
  }
}

/** One row of the columns. */
export function factsOf(report: Report, row: number): RunFacts {
  const { runs } = report;
  return {
    instance: runs.instance.texts[runs.instance.codes[row]],
    planner: runs.planner.texts[runs.planner.codes[row]],
    run: runs.run[row],
    seed: runs.seed[row],
    outcome: runs.outcome.texts[runs.outcome.codes[row]],
    reason: runs.reason.texts[runs.reason.codes[row]],
    solved: runs.solved[row] === 1,
    cpu: runs.cpu[row],
    evaluations: runs.evaluations[row],
    length: runs.length[row],
    clearance: runs.clearance[row],
    limit: runs.limit[row],
  };
}
