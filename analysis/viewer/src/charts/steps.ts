// SPDX-License-Identifier: BSD-3-Clause
// Shares that rise in steps, over a logarithmic axis.

import { brief, percent } from "../format";
import type { Series, StepsPanel } from "../model";
import { curvesChart, type CurvesView } from "./curves";
import { xAxis, yAxis } from "./frame";
import { linear, log, type Scale } from "./scale";

/** The path of a curve that is 0 before its first step and level after its last. */
export function stepPath(series: Series, x: Scale, y: Scale, low: number, end: number): string {
  const parts = [`M${at(x(low))},${at(y(0))}`];
  series.x.forEach((value, index) => parts.push(`H${at(x(Math.max(value, low)))}V${at(y(series.y[index]))}`));
  parts.push(`H${at(x(Math.max(end, series.x[series.x.length - 1] ?? low)))}`);
  return parts.join("");
}

function at(value: number): string {
  return value.toFixed(1);
}

export function stepsChart(panel: StepsPanel, view: CurvesView): SVGSVGElement {
  return curvesChart(panel.series, view, 58, (chart, box) => {
    const all = panel.series.flatMap((series) => series.x);
    const low = 0.8 * Math.min(...all);
    const end = 1.1 * Math.max(panel.end, ...all);
    const x = log(low, end, box.left, box.right, view.width < 500 ? 4 : 7);
    const y = linear(0, 1, box.bottom, box.top);
    chart.append(
      xAxis(box, x, view.labels.x),
      yAxis(box, y, view.labels.y, (value) => percent(value, 0)),
    );
    return (series) => {
      const last = percent(series.y[series.y.length - 1] ?? 0);
      return {
        path: stepPath(series, x, y, low, end),
        tooltip: `${series.name}: first at ${brief(series.x[0] ?? null)}, ${last} in the end`,
      };
    };
  });
}
