// SPDX-License-Identifier: BSD-3-Clause
// Clearance over the way, with the place that the player is at; a click goes there.

import { picture, text, xAxis, yAxis } from "../charts/frame";
import { linear } from "../charts/scale";
import { h, svg } from "../dom";
import { percent } from "../format";
import type { Curve } from "./clearance";

const HEIGHT = 190;

export class ClearanceChart {
  readonly element = h("div", { class: "clearance" });
  private readonly observer: ResizeObserver;
  private readonly cursor = svg("line", { stroke: "var(--arm)", "stroke-width": 2 });
  private progress = 0;
  private width = 0;
  private at: (progress: number) => number = () => 0;

  /**
   * \param curve over the way
   * \param verified the verifier's least clearance, null if it gave none
   */
  constructor(
    private readonly curve: Curve,
    private readonly verified: number | null,
    private readonly seek: (progress: number) => void,
  ) {
    this.observer = new ResizeObserver(([entry]) => {
      const width = Math.max(280, Math.floor(entry.contentRect.width));
      if (width !== this.width) this.draw((this.width = width));
    });
    this.observer.observe(this.element);
  }

  dispose(): void {
    this.observer.disconnect();
  }

  show(progress: number): void {
    this.progress = Math.min(1, progress);
    const x = this.at(this.progress);
    this.cursor.setAttribute("x1", String(x));
    this.cursor.setAttribute("x2", String(x));
  }

  private draw(width: number): void {
    const values = this.curve.map(([, value]) => value);
    const box = { left: 62, right: width - 24, top: 8, bottom: HEIGHT - 40 };
    const chart = picture(width, HEIGHT, "clearance over the way");
    if (!values.every(Number.isFinite)) {
      chart.append(text(width / 2, HEIGHT / 2, "there is nothing to keep away from", { "text-anchor": "middle" }));
      this.element.replaceChildren(chart);
      return;
    }
    const x = linear(0, 1, box.left, box.right);
    const high = Math.max(...values, this.verified ?? 0);
    const y = linear(Math.min(0, ...values), high > 0 ? 1.05 * high : 1, box.bottom, box.top, 4);
    this.at = x;
    const points = this.curve.map(([progress, value]) => `${x(progress).toFixed(1)},${y(value).toFixed(1)}`).join(" ");
    chart.append(
      xAxis(box, x, "share of the way", (value) => percent(value, 0)),
      yAxis(box, y, "clearance"),
      svg("line", { x1: box.left, x2: box.right, y1: y(0), y2: y(0), stroke: "currentColor", "stroke-opacity": 0.6 }),
      svg("polyline", { points, fill: "none", stroke: "var(--accent)", "stroke-width": 1.8 }),
    );
    if (this.verified !== null && this.verified < high) {
      const at = y(this.verified);
      chart.append(
        svg("line", { x1: box.left, x2: box.right, y1: at, y2: at, stroke: "var(--goal)", "stroke-dasharray": "4 3" }),
      );
    }
    this.cursor.setAttribute("y1", String(box.top));
    this.cursor.setAttribute("y2", String(box.bottom));
    chart.append(this.cursor);
    chart.addEventListener("click", (event) => {
      const place = (event.offsetX * width) / chart.clientWidth;
      this.seek(Math.min(1, Math.max(0, (place - box.left) / (box.right - box.left))));
    });
    this.element.replaceChildren(chart);
    this.show(this.progress);
  }
}
