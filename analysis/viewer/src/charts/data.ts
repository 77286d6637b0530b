// SPDX-License-Identifier: BSD-3-Clause
// The numbers behind a figure, for downloads.

import { csv } from "../format";
import type { Figure } from "../model";

type Row = (string | number | null)[];

function content(figure: Figure): [string[], Row[]] {
  switch (figure.kind) {
    case "intervals":
      return [
        ["panel", "planner", "solved", "runs", "share", "low", "high"],
        figure.panels.flatMap((panel) =>
          panel.rows.map((row): Row => [panel.name, row.planner, row.solved, row.runs, row.share, row.low, row.high]),
        ),
      ];
    case "steps":
    case "trend":
      return [
        ["panel", "planner", figure.x, figure.y],
        figure.panels.flatMap((panel) =>
          panel.series.flatMap((series) =>
            series.x.map((x, index): Row => [panel.name, series.name, x, series.y[index]]),
          ),
        ),
      ];
    case "heat":
      return [
        ["group", "planner", "median CPU ms", "share solved"],
        figure.panels.flatMap((panel) =>
          panel.rows.flatMap((group, i) =>
            panel.columns.map((planner, j): Row => [group, planner, panel.values[i][j], panel.shares[i][j]]),
          ),
        ),
      ];
    case "phase":
      return [
        ["panel", "links", "half width", "share solved", "runs"],
        figure.panels.flatMap((panel) =>
          panel.rows.flatMap((links, i) =>
            panel.columns.map((width, j): Row => [panel.name, links, width, panel.shares[i][j], panel.runs[i][j]]),
          ),
        ),
      ];
    case "stacked":
      return [
        ["planner", "end", "runs"],
        figure.panels.flatMap((panel) =>
          panel.rows.flatMap((row) => Object.entries(row.counts).map(([end, count]): Row => [row.planner, end, count])),
        ),
      ];
  }
}

/** All panels of a figure as one CSV file. */
export function figureCsv(figure: Figure): string {
  const [header, rows] = content(figure);
  return csv(header, rows);
}
