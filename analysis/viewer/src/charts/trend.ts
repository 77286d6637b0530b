// SPDX-License-Identifier: BSD-3-Clause
// Lines through points on two logarithmic axes.

import { svg } from "../dom";
import { brief } from "../format";
import type { Series, TrendPanel } from "../model";
import type { Style } from "./colours";
import { picture, text, title, xAxis, yAxis } from "./frame";
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

/** \param hidden names of series that are left out; the axes stay as they are */
export function trendChart(
  panel: TrendPanel,
  labels: { x: string; y: string },
  styles: Map<string, Style>,
  width: number,
  hidden: Set<string>,
): SVGSVGElement {
  const height = Math.min(400, Math.max(280, 0.55 * width));
  const box = { left: 64, right: width - 22, top: 10, bottom: height - 44 };
  const chart = picture(width, height, `${labels.y} over ${labels.x}`);
  const [across, up] = [panel.series.flatMap((series) => series.x), panel.series.flatMap((series) => series.y)];
  if (across.length === 0) {
    chart.append(text(width / 2, height / 2, "nothing was solved here", { "text-anchor": "middle" }));
    return chart;
  }
  const scale = (values: number[], from: number, to: number, count: number): Scale =>
    log(Math.min(...values) / MARGIN, Math.max(...values) * MARGIN, from, to, count);
  const x = scale(across, box.left, box.right, width < 500 ? 4 : 7);
  const y = scale(up, box.bottom, box.top, 6);
  chart.append(xAxis(box, x, labels.x), yAxis(box, y, labels.y));
  for (const series of panel.series
    .filter(({ name }) => !hidden.has(name))
    .sort((a, b) => Number(a.ours) - Number(b.ours))) {
    const { stroke, dash } = styles.get(series.name) ?? { stroke: "currentColor", dash: "" };
    const line = { d: linePath(series, x, y), fill: "none", stroke, "stroke-width": series.ours ? 2.6 : 1.6 };
    chart.append(svg("path", { ...line, "stroke-dasharray": dash || "none", class: "curve" }, title(series.name)));
    chart.append(...points(series, x, y, stroke));
  }
  return chart;
}
