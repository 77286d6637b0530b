// SPDX-License-Identifier: BSD-3-Clause
// Which planner has which colour: planners that see the model in warm ones with solid lines, the others in cool ones, dashed.

const WARM = ["#d55e00", "#cc79a7", "#e69f00", "#a52a2a"];
const COOL = ["#0072b2", "#009e73", "#56b4e9", "#7b6fd0", "#6b8e23", "#4f7f8f"];
const DASHES = ["5 3", "2 2", "8 3 2 3", "1 3"];

export interface Style {
  stroke: string;
  dash: string; // of the line, "" for a solid one
}

/** \param entries in the order of the report, the same for all figures */
export function styles(entries: { name: string; ours: boolean }[]): Map<string, Style> {
  const result = new Map<string, Style>();
  let warm = 0;
  let cool = 0;
  for (const { name, ours } of entries) {
    if (ours) {
      result.set(name, { stroke: WARM[warm % WARM.length], dash: warm < WARM.length ? "" : "10 2" });
      ++warm;
    } else {
      result.set(name, {
        stroke: COOL[cool % COOL.length],
        dash: DASHES[Math.floor(cool / COOL.length) % DASHES.length],
      });
      ++cool;
    }
  }
  return result;
}
