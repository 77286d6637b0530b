// SPDX-License-Identifier: BSD-3-Clause
// Shares with their confidence intervals, one line per planner.

import { svg } from "../dom";
import { percent } from "../format";
import type { IntervalsPanel } from "../model";
import type { Style } from "./colours";
import { fitted, picture, text, title, xAxis } from "./frame";
import { linear } from "./scale";

const ROW = 24;

export function intervalsChart(
  panel: IntervalsPanel,
  xLabel: string,
  styles: Map<string, Style>,
  width: number,
): SVGSVGElement {
  const rows = [...panel.rows].sort((a, b) => b.share - a.share || Number(b.ours) - Number(a.ours));
  const names = Math.min(210, 0.42 * width);
  const box = { left: names, right: width - 80, top: 8, bottom: 12 + ROW * rows.length };
  const chart = picture(width, box.bottom + 42, `${xLabel} by planner`);
  const x = linear(0, 1, box.left, box.right, width < 500 ? 2 : 5);
  chart.append(xAxis(box, x, xLabel, (value) => percent(value, 0)));
  rows.forEach((row, index) => {
    const y = box.top + ROW * (index + 0.5);
    const stroke = styles.get(row.planner)?.stroke ?? "currentColor";
    chart.append(
      text(names - 8, y + 4, fitted(row.planner, names - 8), {
        "text-anchor": "end",
        "font-weight": row.ours ? 700 : 400,
      }),
      svg(
        "g",
        {},
        title(`${row.planner}: ${row.solved} of ${row.runs} (${percent(row.low)} to ${percent(row.high)})`),
        svg("line", {
          x1: x(row.low),
          x2: x(row.high),
          y1: y,
          y2: y,
          stroke,
          "stroke-width": 5,
          "stroke-opacity": 0.45,
          "stroke-linecap": "round",
        }),
        svg("circle", { cx: x(row.share), cy: y, r: 5, fill: stroke }),
      ),
      text(width - 62, y + 4, `${row.solved}/${row.runs}`),
    );
  });
  return chart;
}
