// SPDX-License-Identifier: BSD-3-Clause
// Shares that rise in steps, over a logarithmic axis.

import { svg } from "../dom";
import { brief, percent } from "../format";
import type { Series, StepsPanel } from "../model";
import type { Style } from "./colours";
import { picture, text, title, xAxis, yAxis } from "./frame";
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

/** \param hidden names of series that are left out; the axes stay as they are */
export function stepsChart(
  panel: StepsPanel,
  labels: { x: string; y: string },
  styles: Map<string, Style>,
  width: number,
  hidden: Set<string>,
): SVGSVGElement {
  const height = Math.min(400, Math.max(280, 0.55 * width));
  const box = { left: 58, right: width - 22, top: 10, bottom: height - 44 };
  const all = panel.series.flatMap((series) => series.x);
  const chart = picture(width, height, `${labels.y} over ${labels.x}`);
  if (all.length === 0) {
    chart.append(text(width / 2, height / 2, "nothing was solved here", { "text-anchor": "middle" }));
    return chart;
  }
  const low = 0.8 * Math.min(...all);
  const end = 1.1 * Math.max(panel.end, ...all);
  const x = log(low, end, box.left, box.right, width < 500 ? 4 : 7);
  const y = linear(0, 1, box.bottom, box.top);
  chart.append(
    xAxis(box, x, labels.x),
    yAxis(box, y, labels.y, (value) => percent(value, 0)),
  );
  for (const series of panel.series
    .filter(({ name }) => !hidden.has(name))
    .sort((a, b) => Number(a.ours) - Number(b.ours))) {
    const style = styles.get(series.name) ?? { stroke: "currentColor", dash: "" };
    const last = series.y[series.y.length - 1] ?? 0;
    chart.append(
      svg(
        "path",
        {
          d: stepPath(series, x, y, low, end),
          fill: "none",
          stroke: style.stroke,
          "stroke-width": series.ours ? 2.6 : 1.6,
          "stroke-dasharray": style.dash || "none",
          class: "curve",
        },
        title(`${series.name}: first at ${brief(series.x[0] ?? null)}, ${percent(last)} in the end`),
      ),
    );
  }
  return chart;
}
