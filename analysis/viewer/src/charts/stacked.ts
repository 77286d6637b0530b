// SPDX-License-Identifier: BSD-3-Clause
// How runs ended: a bar per planner, split by outcome.

import { svg } from "../dom";
import { percent } from "../format";
import type { StackedPanel } from "../model";
import { fitted, picture, text, title, xAxis } from "./frame";
import { linear } from "./scale";

const ROW = 24;
const COLOURS = ["#e69f00", "#cc79a7", "#56b4e9", "#d55e00", "#7b6fd0", "#8c6d31", "#6b8e23", "#0072b2"];

/** Outcomes in the order of how often they were, solved first, with a colour each. */
export function outcomeColours(panel: StackedPanel): Map<string, string> {
  const totals = new Map<string, number>();
  for (const row of panel.rows)
    for (const [name, count] of Object.entries(row.counts)) totals.set(name, (totals.get(name) ?? 0) + count);
  const names = [...totals.keys()].sort(
    (a, b) => Number(b === "solved") - Number(a === "solved") || totals.get(b)! - totals.get(a)!,
  );
  return new Map(
    names.map((name, index) => [
      name,
      name === "solved" ? "#009e73" : COLOURS[(index - Number(totals.has("solved"))) % COLOURS.length],
    ]),
  );
}

export function stackedChart(panel: StackedPanel, xLabel: string, width: number): SVGSVGElement {
  const colours = outcomeColours(panel);
  const names = Math.min(210, 0.42 * width);
  const box = { left: names, right: width - 24, top: 8, bottom: 12 + ROW * panel.rows.length };
  const chart = picture(width, box.bottom + 42, "how runs ended, by planner");
  const x = linear(0, 1, box.left, box.right, width < 500 ? 2 : 5);
  chart.append(xAxis(box, x, xLabel, (value) => percent(value, 0)));
  panel.rows.forEach((row, index) => {
    const y = box.top + ROW * index;
    const total = Object.values(row.counts).reduce((sum, count) => sum + count, 0);
    chart.append(text(names - 8, y + ROW / 2 + 4, fitted(row.planner, names - 8), { "text-anchor": "end" }));
    let before = 0;
    for (const [name, fill] of colours) {
      const count = row.counts[name] ?? 0;
      if (count === 0) continue;
      chart.append(
        svg(
          "rect",
          {
            x: x(before / total),
            y: y + 4,
            width: x((before + count) / total) - x(before / total),
            height: ROW - 8,
            fill,
          },
          title(`${row.planner}: ${count} of ${total} ${name}`),
        ),
      );
      before += count;
    }
  });
  return chart;
}
