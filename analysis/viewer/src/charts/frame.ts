// SPDX-License-Identifier: BSD-3-Clause
// What figures have in common: axes, grid and labels.

import { svg } from "../dom";
import { brief } from "../format";
import type { Scale } from "./scale";

export interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** An empty picture that scales with the page. */
export function picture(width: number, height: number, label: string): SVGSVGElement {
  return svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: "img",
    "aria-label": label,
    class: "chart",
  });
}

export function text(
  x: number,
  y: number,
  content: string,
  attributes: Record<string, string | number> = {},
): SVGTextElement {
  return svg("text", { x, y, fill: "currentColor", "font-size": 12, ...attributes }, content);
}

/** A name, cut if it does not fit into so many pixels. */
export function fitted(name: string, pixels: number): string {
  const most = Math.max(4, Math.floor(pixels / 6.7));
  return name.length <= most ? name : `${name.slice(0, most - 1)}…`;
}

/** A tooltip. */
export function title(content: string): SVGTitleElement {
  return svg("title", {}, content);
}

function rule(x1: number, y1: number, x2: number, y2: number): SVGLineElement {
  return svg("line", { x1, y1, x2, y2, stroke: "currentColor", "stroke-opacity": 0.14 });
}

export function xAxis(box: Box, scale: Scale, label: string, name: (value: number) => string = brief): SVGGElement {
  const group = svg("g", { class: "axis" });
  for (const tick of scale.ticks) {
    const x = scale(tick);
    group.append(rule(x, box.top, x, box.bottom), text(x, box.bottom + 16, name(tick), { "text-anchor": "middle" }));
  }
  group.append(text((box.left + box.right) / 2, box.bottom + 34, label, { "text-anchor": "middle" }));
  return group;
}

export function yAxis(box: Box, scale: Scale, label: string, name: (value: number) => string = brief): SVGGElement {
  const group = svg("g", { class: "axis" });
  for (const tick of scale.ticks) {
    const y = scale(tick);
    group.append(rule(box.left, y, box.right, y), text(box.left - 6, y + 4, name(tick), { "text-anchor": "end" }));
  }
  const [x, y] = [box.left - 42, (box.top + box.bottom) / 2];
  group.append(text(x, y, label, { "text-anchor": "middle", transform: `rotate(-90 ${x} ${y})` }));
  return group;
}
