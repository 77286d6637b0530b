// SPDX-License-Identifier: BSD-3-Clause
// Lines through points on two logarithmic axes.

import { svg } from "../dom";
import { brief } from "../format";
import type { Series, TrendPanel } from "../model";
import { curvesChart, type CurvesView } from "./curves";
import { title, xAxis, yAxis } from "./frame";
import { log, type Scale } from "./scale";

const MARGIN = 1.3; // of the axes beyond the points, as a factor

export function linePath(series: Series, x: Scale, y: Scale): string {
  return series.x
    .map((value, index) => `${index ? "L" : "M"}${x(value).toFixed(1)},${y(series.y[index]).toFixed(1)}`)
    .join("");
}

function points(series: Series, x: Scale, y: Scale, stroke: string): SVGCircleElement[] {
  return series.x.map((value, index) =>
    svg(
      "circle",
      { cx: x(value).toFixed(1), cy: y(series.y[index]).toFixed(1), r: series.ours ? 4 : 3, fill: stroke },
      title(`${series.name}: ${brief(series.y[index])} at ${brief(value)}`),
    ),
  );
}

export function trendChart(panel: TrendPanel, view: CurvesView): SVGSVGElement {
  return curvesChart(panel.series, view, 64, (chart, box) => {
    const scale = (values: number[], from: number, to: number, count: number): Scale =>
      log(Math.min(...values) / MARGIN, Math.max(...values) * MARGIN, from, to, count);
    const [across, up] = [panel.series.flatMap((series) => series.x), panel.series.flatMap((series) => series.y)];
    const x = scale(across, box.left, box.right, view.width < 500 ? 4 : 7);
    const y = scale(up, box.bottom, box.top, 6);
    chart.append(xAxis(box, x, view.labels.x), yAxis(box, y, view.labels.y));
    return (series, stroke) => ({
      path: linePath(series, x, y),
      tooltip: series.name,
      marks: points(series, x, y, stroke),
    });
  });
}
