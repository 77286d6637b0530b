// SPDX-License-Identifier: BSD-3-Clause
// Success over the width of a passage and the number of links, with the line where half of the runs are solved.

import { svg } from "../dom";
import { brief, percent } from "../format";
import type { PhasePanel } from "../model";
import { picture, text, title } from "./frame";
import { log, type Scale } from "./scale";

const ROW = 46;

const WHY: Record<string, string> = {
  all_alike: "no line: all runs ended alike",
  separated: "no line: solved and unsolved are fully apart, so its place is open",
  no_trend: "no line: success does not grow with the width",
  one_row: "no line: only one number of links",
};

/** From rust (none) to teal (all). */
export function shareColour(share: number): string {
  const [none, all] = [
    [178, 58, 30],
    [0, 125, 120],
  ];
  return `rgb(${none.map((value, i) => Math.round(value + share * (all[i] - value))).join(",")})`;
}

/** Where cells begin and end on a logarithmic axis: halfway between neighbours. */
export function edges(widths: number[]): number[] {
  const logs = widths.map(Math.log);
  const between = logs.slice(1).map((value, i) => (value + logs[i]) / 2);
  const last = logs.length - 1;
  return [2 * logs[0] - between[0], ...between, 2 * logs[last] - between[last - 1]].map(Math.exp);
}

function cells(panel: PhasePanel, x: Scale, top: number): SVGElement[] {
  const borders = edges(panel.columns);
  return panel.rows.flatMap((links, row) =>
    panel.columns.flatMap((width, column) => {
      const share = panel.shares[row][column];
      if (share === null) return [];
      const [left, right, y] = [x(borders[column]), x(borders[column + 1]), top + ROW * row];
      const name = `${links || "any"} links, half width ${brief(width)}: ${percent(share)} of ${panel.runs[row][column]} runs`;
      return [
        svg(
          "rect",
          {
            x: left + 1,
            y: y + 1,
            width: right - left - 2,
            height: ROW - 2,
            rx: 3,
            fill: shareColour(share),
            "fill-opacity": 0.75,
          },
          title(name),
        ),
        text((left + right) / 2, y + ROW / 2 + 4, percent(share, 0), {
          "text-anchor": "middle",
          fill: "#fff",
          "pointer-events": "none",
        }),
      ];
    }),
  );
}

/** The line and its band, as far as they are on the picture. */
function boundary(panel: PhasePanel, x: Scale, top: number, low: number, high: number): SVGElement[] {
  if (panel.line.length === 0) return [];
  const at = (width: number): number => x(Math.min(high, Math.max(low, width)));
  const y = (row: number): number => top + ROW * (row + 0.5);
  const places = (k: 0 | 1 | 2): string[] => panel.line.map((point, row) => `${at(point[k]).toFixed(1)},${y(row)}`);
  return [
    svg("polygon", {
      points: [...places(1), ...places(2).reverse()].join(" "),
      fill: "currentColor",
      "fill-opacity": 0.25,
    }),
    svg("polyline", { points: places(0).join(" "), fill: "none", stroke: "currentColor", "stroke-width": 2.5 }),
  ];
}

export function phaseChart(panel: PhasePanel, labels: { x: string; y: string }, width: number): SVGSVGElement {
  const borders = edges(panel.columns);
  const [low, high] = [borders[0], borders[borders.length - 1]];
  const [left, top] = [58, 8];
  const bottom = top + ROW * panel.rows.length;
  const x = log(low, high, left, width - 14);
  const chart = picture(width, bottom + (panel.failure ? 62 : 42), `success over ${labels.x} and ${labels.y}`);
  chart.append(...cells(panel, x, top), ...boundary(panel, x, top, low, high));
  panel.rows.forEach((links, row) =>
    chart.append(text(left - 8, top + ROW * (row + 0.5) + 4, links ? String(links) : "any", { "text-anchor": "end" })),
  );
  panel.columns.forEach((value) =>
    chart.append(text(x(value), bottom + 16, brief(value, 2), { "text-anchor": "middle" })),
  );
  chart.append(text((left + width) / 2, bottom + 34, labels.x, { "text-anchor": "middle" }));
  const [lx, ly] = [14, (top + bottom) / 2];
  chart.append(text(lx, ly, labels.y, { "text-anchor": "middle", transform: `rotate(-90 ${lx} ${ly})` }));
  if (panel.failure)
    chart.append(text(left, bottom + 54, WHY[panel.failure] ?? panel.failure, { "fill-opacity": 0.7 }));
  return chart;
}
