// SPDX-License-Identifier: BSD-3-Clause
// HPPM's plane: obstacles' shadows, the traced curve, the arm's place. Pointing anywhere poses a second arm there.

import { h } from "../dom";
import { brief } from "../format";
import type { Slice, Vector } from "../model";
import { colour } from "../theme";
import { configuration, placeOf, unpack } from "./slicePlane";

const SHADOWS = ["#e69f00", "#56b4e9", "#cc79a7", "#009e73", "#7b6fd0", "#d55e00", "#8c6d31", "#0072b2"];
const MARGIN = { left: 46, right: 10, top: 8, bottom: 34 };

type Place = [lambda: number, s: number];

export class SliceView {
  readonly element: HTMLElement;
  private readonly canvas = h("canvas", { class: "stage slice", tabindex: 0 });
  private readonly context = this.canvas.getContext("2d")!;
  private readonly shadow: HTMLCanvasElement;
  private readonly observer: ResizeObserver;
  private row: Vector | null = null;
  private pointed: Place | null = null;

  /** \param probe is told the configuration that the reader points at, null when it is none any more */
  constructor(
    private readonly slice: Slice,
    private readonly probe: (row: Vector | null) => void,
  ) {
    this.shadow = shadows(slice);
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The slice of joint space in which the curve was traced");
    this.canvas.addEventListener("pointermove", (event) => this.point(this.placeAt(event.offsetX, event.offsetY)));
    this.canvas.addEventListener("pointerdown", (event) => this.point(this.placeAt(event.offsetX, event.offsetY)));
    this.canvas.addEventListener("pointerleave", () => this.point(null));
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.canvas);
    this.element = h(
      "div",
      { class: "slice-card" },
      h("h3", {}, "The slice of joint space"),
      this.canvas,
      this.caption(),
    );
  }

  /** The arm's configuration has changed. */
  draw(row: Vector): void {
    this.row = row;
    this.render();
  }

  dispose(): void {
    this.observer.disconnect();
  }

  private caption(): HTMLElement {
    const { slice } = this;
    const names = slice.obstacles.map(({ name }, i) =>
      h("li", {}, h("i", { style: `border-top: 8px solid ${SHADOWS[i % SHADOWS.length]}` }), name),
    );
    const way = slice.joins
      ? `Its free part joins start and goal (bottleneck ${brief(slice.bottleneck)}).`
      : `No way in it was found at a spacing of ${brief(slice.spacing, 2)} rad.`;
    return h(
      "div",
      {},
      h(
        "ul",
        { class: "legend" },
        ...names,
        h("li", {}, h("i", { style: "border-top: 3px solid var(--curve)" }), "traced curve"),
        ...(slice.path.length
          ? [h("li", {}, h("i", { style: "border-top: 3px dashed var(--start)" }), "widest way")]
          : []),
      ),
      h(
        "p",
        { class: "note" },
        `λ goes from ${slice.tracedFrom === "goal" ? "goal to start" : "start to goal"}, s (radians) along the plane's other direction; the curve ended with ${slice.status}. ${way} Point anywhere to pose a second arm there.`,
      ),
    );
  }

  private point(place: Place | null): void {
    this.pointed = place;
    this.probe(place && configuration(this.slice, ...place));
    this.render();
  }

  private area(): { left: number; top: number; width: number; height: number } {
    const { clientWidth, clientHeight } = this.canvas;
    return {
      left: MARGIN.left,
      top: MARGIN.top,
      width: clientWidth - MARGIN.left - MARGIN.right,
      height: clientHeight - MARGIN.top - MARGIN.bottom,
    };
  }

  private pixelAt([lambda, s]: Vector): [number, number] {
    const { left, top, width, height } = this.area();
    const [low, high] = this.slice.lambda;
    return [left + (width * (lambda - low)) / (high - low), top + (height * (1 - s / this.slice.deviation)) / 2];
  }

  private placeAt(x: number, y: number): Place | null {
    const { left, top, width, height } = this.area();
    const [u, v] = [(x - left) / width, (y - top) / height];
    if (u < 0 || u > 1 || v < 0 || v > 1) return null;
    const [low, high] = this.slice.lambda;
    return [low + u * (high - low), this.slice.deviation * (1 - 2 * v)];
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0) return;
    this.canvas.width = Math.round(clientWidth * window.devicePixelRatio);
    this.canvas.height = Math.round(clientHeight * window.devicePixelRatio);
    this.render();
  }

  private render(): void {
    const { context } = this;
    const { left, top, width, height } = this.area();
    if (width <= 0) return;
    const ratio = window.devicePixelRatio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.shadow, left, top, width, height);
    context.strokeStyle = colour("obstacle-edge");
    context.lineWidth = 1;
    context.strokeRect(left, top, width, height);
    this.axes(left, top, width, height);
    context.save();
    context.beginPath();
    context.rect(left, top, width, height);
    context.clip();
    this.line(this.slice.path, colour("start"), [5, 4]);
    this.line(this.slice.curve, colour("curve"), []);
    this.slice.rejected.forEach((place) => this.mark(place, 1.5, colour("ink")));
    const first = this.slice.tracedFrom === "goal" ? "goal" : "start";
    this.end([0, 0], first);
    this.end([1, 0], first === "goal" ? "start" : "goal");
    const here = this.row && placeOf(this.slice, this.row);
    if (here) this.mark(here, 7, colour("arm"), true);
    if (this.pointed) this.mark(this.pointed, 5, colour("probe"), true);
    context.restore();
  }

  private axes(left: number, top: number, width: number, height: number): void {
    const { context, slice } = this;
    context.fillStyle = colour("ink");
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "center";
    for (const lambda of [0, 0.5, 1]) context.fillText(String(lambda), this.pixelAt([lambda, 0])[0], top + height + 15);
    context.fillText("λ", left + width / 2, top + height + 29);
    context.textAlign = "right";
    for (const s of [-slice.deviation, 0, slice.deviation])
      context.fillText(brief(s, 2), left - 5, Math.min(top + height, Math.max(top + 9, this.pixelAt([0, s])[1] + 4)));
    context.fillText("s", left - 30, top + height / 2 - 14);
  }

  private line(places: Vector[], style: string, dash: number[]): void {
    const { context } = this;
    context.beginPath();
    places.forEach((place, i) => (i ? context.lineTo(...this.pixelAt(place)) : context.moveTo(...this.pixelAt(place))));
    context.setLineDash(dash);
    context.strokeStyle = style;
    context.lineWidth = 2;
    context.stroke();
    context.setLineDash([]);
  }

  private mark(place: Vector, radius: number, style: string, ringed = false): void {
    const { context } = this;
    context.beginPath();
    context.arc(...this.pixelAt(place), radius, 0, 2 * Math.PI);
    context.fillStyle = style;
    context.fill();
    if (!ringed) return;
    context.strokeStyle = colour("card");
    context.lineWidth = 2;
    context.stroke();
  }

  private end(place: Place, name: "start" | "goal"): void {
    this.mark(place, 5, colour(name), true);
    const [x, y] = this.pixelAt(place);
    this.context.fillStyle = colour("ink");
    this.context.textAlign = "left";
    this.context.fillText(name, x + 8, y - 7);
  }
}

/** One picture of all obstacles, pixel by pixel, the highest s on top. */
function shadows(slice: Slice): HTMLCanvasElement {
  const canvas = h("canvas", { width: slice.columns, height: slice.rows });
  const context = canvas.getContext("2d")!;
  const image = context.createImageData(slice.columns, slice.rows);
  slice.obstacles.forEach(({ bits }, index) => {
    const shade = SHADOWS[index % SHADOWS.length];
    const rgb = [1, 3, 5].map((at) => parseInt(shade.slice(at, at + 2), 16));
    unpack(bits, slice.columns * slice.rows).forEach((bit, at) => {
      if (!bit) return;
      const row = slice.rows - 1 - Math.floor(at / slice.columns);
      image.data.set([...rgb, 150], 4 * (row * slice.columns + (at % slice.columns)));
    });
  });
  context.putImageData(image, 0, 0);
  return canvas;
}
