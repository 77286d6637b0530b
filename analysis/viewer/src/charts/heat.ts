// SPDX-License-Identifier: BSD-3-Clause
// Median times, a cell per group and planner: dark is slow, pale is seldom solved.

import { svg } from "../dom";
import { brief, percent } from "../format";
import type { HeatPanel } from "../model";
import { picture, text, title } from "./frame";

const ROW = 22;
const COLUMN = 66;

/** A place between 0 (least) and 1 (most) on a logarithmic scale. */
export function shade(value: number, low: number, high: number): number {
  return high > low ? Math.log(value / low) / Math.log(high / low) : 0;
}

/** From teal over sand to rust. */
export function heatColour(share: number): string {
  const stops = [
    [0, 125, 120],
    [238, 214, 160],
    [178, 58, 30],
  ];
  const at = Math.min(1, Math.max(0, share)) * 2;
  const [a, b] = at < 1 ? [stops[0], stops[1]] : [stops[1], stops[2]];
  const part = at < 1 ? at : at - 1;
  return `rgb(${a.map((value, i) => Math.round(value + part * (b[i] - value))).join(",")})`;
}

function cell(
  panel: HeatPanel,
  row: number,
  column: number,
  low: number,
  high: number,
  x: number,
  y: number,
): SVGElement[] {
  const [value, share] = [panel.values[row][column], panel.shares[row][column]];
  const where = `${panel.columns[column]} on ${panel.rows[row]}`;
  if (share === null) return [];
  if (value === null)
    return [
      svg(
        "g",
        {},
        title(`${where}: not solved`),
        text(x + COLUMN / 2, y + 15, "none", { "text-anchor": "middle", "fill-opacity": 0.6 }),
      ),
    ];
  const at = shade(value, low, high);
  const ink = share < 0.6 ? "currentColor" : at < 0.25 || at > 0.8 ? "#fff" : "#222";
  return [
    svg(
      "rect",
      {
        x: x + 1,
        y: y + 1,
        width: COLUMN - 2,
        height: ROW - 2,
        rx: 3,
        fill: heatColour(at),
        "fill-opacity": 0.2 + 0.8 * share,
      },
      title(`${where}: ${brief(value)} ms, ${percent(share)} solved`),
    ),
    text(x + COLUMN / 2, y + 15, brief(value, 2), { "text-anchor": "middle", fill: ink, "pointer-events": "none" }),
  ];
}

export function heatChart(panel: HeatPanel): SVGSVGElement {
  const longest = Math.max(...panel.rows.map((name) => name.length));
  const left = Math.min(330, 7 * longest + 12);
  const top = Math.min(190, 12 + 5 * Math.max(...panel.columns.map((name) => name.length)));
  const chart = picture(
    left + COLUMN * panel.columns.length + 70,
    top + ROW * panel.rows.length + 6,
    "median CPU milliseconds",
  );
  const values = panel.values.flat().filter((value): value is number => value !== null);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  panel.columns.forEach((name, column) => {
    const [x, y] = [left + COLUMN * (column + 0.5), top - 6];
    chart.append(text(x, y, name, { transform: `rotate(-35 ${x} ${y})` }));
  });
  panel.rows.forEach((name, row) => {
    const y = top + ROW * row;
    chart.append(text(left - 8, y + 15, name, { "text-anchor": "end" }));
    panel.columns.forEach((_, column) =>
      chart.append(...cell(panel, row, column, low, high, left + COLUMN * column, y)),
    );
  });
  return chart;
}
