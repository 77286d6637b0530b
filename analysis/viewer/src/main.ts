// SPDX-License-Identifier: BSD-3-Clause
// The page: reads the data that stand in it and puts the parts together.

import "./style.css";

import { h } from "./dom";
import type { Report } from "./model";
import { Catalogue } from "./motion/catalogue";
import { MotionPanel } from "./motion/panel";
import { aboutSection, figuresSection, runsSection, tablesSection, verdictSection } from "./sections";
import { themeButton, toggle } from "./theme";

function header(report: Report, parts: [id: string, name: string][]): HTMLElement {
  return h(
    "header",
    { class: "top" },
    h("strong", {}, report.campaign.name),
    h("nav", { "aria-label": "Parts of the page" }, ...parts.map(([id, name]) => h("a", { href: `#${id}` }, name))),
    themeButton(),
  );
}

/** Is the reader typing, or moving something that has keys of its own? */
function busy(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.matches("input[type=search], select, textarea")) return true;
  if (key === " ") return target.matches("button, input, summary, a");
  return target.matches("input[type=range]") && key.startsWith("Arrow");
}

function build(report: Report): void {
  const catalogue = new Catalogue(report);
  const panel = report.motions.length ? new MotionPanel(catalogue) : null;
  const parts: [string, string][] = [
    ["verdict", "Verdict"],
    ...(panel ? [["motions", "Motions"] as [string, string]] : []),
    ["figures", "Figures"],
    ["tables", "Tables"],
    ["runs", "Runs"],
    ["about", "About"],
  ];
  const page = document.getElementById("page")!;
  page.append(header(report, parts), verdictSection(report));
  if (panel) page.append(panel.element);
  page.append(
    figuresSection(report),
    tablesSection(report),
    runsSection(catalogue, (motion) => panel?.show(motion)),
    aboutSection(report),
  );
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || busy(event.target, event.key)) return;
    if (event.key.toLowerCase() === "d") toggle();
    else if (!panel?.key(event.key.length === 1 ? event.key.toLowerCase() : event.key)) return;
    event.preventDefault();
  });
}

build(JSON.parse(document.getElementById("data")!.textContent!) as Report);
