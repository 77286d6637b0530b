// SPDX-License-Identifier: BSD-3-Clause
// What charts of one curve per planner have in common.

import { svg } from "../dom";
import type { Series } from "../model";
import type { Style } from "./colours";
import { type Box, picture, text, title } from "./frame";

/** How curves are shown. */
export interface CurvesView {
  labels: { x: string; y: string };
  styles: Map<string, Style>;
  width: number;
  hidden: Set<string>; // names of series that are left out; the axes stay as they are
}

/** A series as it is drawn. */
export interface Curve {
  path: string;
  tooltip: string;
  marks?: SVGElement[];
}

/**
 * \param left where the y axis is
 * \param draw called if there are points: adds the axes, and says how a series is drawn
 */
export function curvesChart(
  all: Series[],
  view: CurvesView,
  left: number,
  draw: (chart: SVGSVGElement, box: Box) => (series: Series, stroke: string) => Curve,
): SVGSVGElement {
  const { labels, styles, width, hidden } = view;
  const height = Math.min(400, Math.max(280, 0.55 * width));
  const chart = picture(width, height, `${labels.y} over ${labels.x}`);
  if (all.every((series) => series.x.length === 0)) {
    chart.append(text(width / 2, height / 2, "nothing was solved here", { "text-anchor": "middle" }));
    return chart;
  }
  const curveOf = draw(chart, { left, right: width - 22, top: 10, bottom: height - 44 });
  // Ours on top.
  const shown = all.filter(({ name }) => !hidden.has(name)).sort((a, b) => Number(a.ours) - Number(b.ours));
  for (const series of shown) {
    const { stroke, dash } = styles.get(series.name) ?? { stroke: "currentColor", dash: "" };
    const { path, tooltip, marks } = curveOf(series, stroke);
    const line = { d: path, fill: "none", stroke, "stroke-width": series.ours ? 2.6 : 1.6 };
    chart.append(svg("path", { ...line, "stroke-dasharray": dash || "none", class: "curve" }, title(tooltip)));
    chart.append(...(marks ?? []));
  }
  return chart;
}
