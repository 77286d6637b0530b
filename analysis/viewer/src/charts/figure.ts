// SPDX-License-Identifier: BSD-3-Clause
// One figure of the report: its panel list, its picture, its legend and its downloads.

import { h, save, select } from "../dom";
import type { Figure } from "../model";
import type { Style } from "./colours";
import { figureCsv } from "./data";
import { heatChart } from "./heat";
import { intervalsChart } from "./intervals";
import { phaseChart } from "./phase";
import { outcomeColours, stackedChart } from "./stacked";
import { stepsChart } from "./steps";
import { trendChart } from "./trend";

const WIDTH = 760;

function draw(
  figure: Figure,
  panel: number,
  styles: Map<string, Style>,
  width: number,
  hidden: Set<string>,
): SVGSVGElement {
  switch (figure.kind) {
    case "intervals":
      return intervalsChart(figure.panels[panel], figure.x, styles, width);
    case "steps":
      return stepsChart(figure.panels[panel], { labels: figure, styles, width, hidden });
    case "trend":
      return trendChart(figure.panels[panel], { labels: figure, styles, width, hidden });
    case "stacked":
      return stackedChart(figure.panels[panel], figure.x, width);
    case "phase":
      return phaseChart(figure.panels[panel], figure, width);
    case "heat":
      return heatChart(figure.panels[panel]);
  }
}

/** Names and how they are drawn. */
function legend(figure: Figure, panel: number, styles: Map<string, Style>): [string, Style][] {
  if (figure.kind === "steps" || figure.kind === "trend")
    return figure.panels[panel].series.map(({ name }) => [
      name,
      styles.get(name) ?? { stroke: "currentColor", dash: "" },
    ]);
  if (figure.kind === "stacked")
    return [...outcomeColours(figure.panels[panel])].map(([name, stroke]) => [name, { stroke, dash: "" }]);
  return [];
}

/** \param toggle called by a click on the name, if it can be hidden */
function swatch(name: string, style: Style, shown: boolean, toggle?: () => void): HTMLElement {
  const line = h("i", { style: `border-top: 3px ${style.dash ? "dashed" : "solid"} ${style.stroke}` });
  if (!toggle) return h("li", {}, line, name);
  return h(
    "li",
    {},
    h("button", { type: "button", "aria-pressed": String(shown), title: "Show or hide", click: toggle }, line, name),
  );
}

/** The picture as a file of its own: with a font and the colour that the page gave it. */
function standalone(chart: SVGSVGElement): string {
  const copy = chart.cloneNode(true) as SVGSVGElement;
  copy.setAttribute("style", "color: #222; background: #fff; font-family: sans-serif");
  return new XMLSerializer().serializeToString(copy); // outerHTML is no XML
}

/** A figure on a card that draws itself anew when its width, its panel or what is hidden changes. */
class Card {
  readonly element: HTMLElement;
  private panel = 0;
  private width = 0;
  private chart: SVGSVGElement | undefined;
  private readonly hidden = new Set<string>();
  private readonly place: HTMLElement;
  private readonly names = h("ul", { class: "legend" });

  constructor(
    private readonly figure: Figure,
    private readonly styles: Map<string, Style>,
  ) {
    const { id, title, note } = figure;
    this.place = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": title });
    const parts = [h("h3", {}, title), this.bar(), this.place, this.names, h("figcaption", {}, note)];
    this.element = h("figure", { class: "card", id: `figure-${id}` }, ...parts);
    new ResizeObserver(([entry]) => this.resize(entry.contentRect.width)).observe(this.place);
  }

  private bar(): HTMLElement {
    const { id, title, panels } = this.figure;
    const names = panels.map(({ name }) => name);
    const choose = (index: number): void => {
      this.panel = index;
      this.update();
    };
    const drawing = (): void => this.chart && save(`${id}.svg`, "image/svg+xml", standalone(this.chart));
    const numbers = (): void => save(`${id}.csv`, "text/csv", figureCsv(this.figure));
    return h(
      "div",
      { class: "bar" },
      ...(names.length > 1 ? [select(`${title}: group`, names, 0, choose)] : []),
      h("span", { class: "gap" }),
      h("button", { type: "button", click: drawing }, "SVG"),
      h("button", { type: "button", click: numbers }, "CSV"),
    );
  }

  private resize(room: number): void {
    const width = Math.max(300, Math.min(WIDTH, Math.floor(room)));
    if (width === this.width) return;
    this.width = width;
    this.update();
  }

  private update(): void {
    const { figure, panel, styles, hidden } = this;
    this.chart = draw(figure, panel, styles, this.width, hidden);
    this.place.replaceChildren(this.chart);
    const curves = figure.kind === "steps" || figure.kind === "trend";
    const toggle = curves ? (name: string) => () => this.toggle(name) : () => undefined;
    const names = legend(figure, panel, styles);
    this.names.replaceChildren(...names.map(([name, style]) => swatch(name, style, !hidden.has(name), toggle(name))));
  }

  private toggle(name: string): void {
    if (!this.hidden.delete(name)) this.hidden.add(name);
    this.update();
  }
}

export function figureCard(figure: Figure, styles: Map<string, Style>): HTMLElement {
  return new Card(figure, styles).element;
}
