// SPDX-License-Identifier: BSD-3-Clause
// The motion viewer: which motion, its buttons, its views and what its row says.

import { h, select } from "../dom";
import { brief, duration } from "../format";
import { onChange } from "../theme";
import type { Catalogue, RunFacts } from "./catalogue";
import { Player } from "./player";
import type { Playback } from "./timeline";

const SPEEDS = [0.25, 0.5, 1, 2, 4];

export class MotionPanel {
  readonly element = h("section", { id: "motions", class: "motions" });
  private index = 0;
  private player: Player | null = null;
  private state: Playback = { progress: 0, playing: false, loop: true, speed: 1 };
  private sweep = true;
  private readonly pickers = h("div", { class: "bar pickers" });
  private readonly stage = h("div", { class: "stage-place" });
  private readonly side = h("div", { class: "side" });
  private readonly play = h(
    "button",
    { type: "button", id: "play", class: "primary", title: "Key: space", click: () => this.player?.toggle() },
    "▶ Play",
  );
  private readonly scrub = h("input", {
    type: "range",
    id: "scrub",
    min: 0,
    max: 1000,
    value: 0,
    "aria-label": "Where on the way",
    input: () => this.player?.seek(Number(this.scrub.value) / 1000),
  });
  private readonly place = h("output", { id: "place", for: "scrub" }, "0 %");
  private readonly loop = this.checkbox("loop", "Loop", true, (on) => this.player?.set({ loop: on }));
  private readonly swept = this.checkbox(
    "sweep",
    "Sweep",
    true,
    (on) => ((this.sweep = on), this.player?.showSweep(on)),
  );

  constructor(private readonly catalogue: Catalogue) {
    const speed = select(
      "Speed",
      SPEEDS.map((factor) => `${factor}×`),
      SPEEDS.indexOf(1),
      (i) => this.player?.set({ speed: SPEEDS[i] }),
    );
    const zoom = (factor: number, name: string, label: string): HTMLElement =>
      h(
        "button",
        { type: "button", class: "small", "aria-label": label, click: () => this.player?.view.zoom(factor) },
        name,
      );
    const lenses = h(
      "div",
      { class: "lenses" },
      zoom(1.5, "+", "Nearer"),
      zoom(1 / 1.5, "−", "Farther"),
      h(
        "button",
        { type: "button", class: "small", "aria-label": "See all", click: () => this.player?.view.reset() },
        "⤢",
      ),
    );
    this.element.append(
      h("h2", {}, "Motions"),
      this.pickers,
      h(
        "div",
        { class: "viewer" },
        h(
          "div",
          { class: "main" },
          h("div", { class: "frame" }, this.stage, lenses),
          h("div", { class: "bar controls" }, this.play, this.scrub, this.place, this.loop, this.swept, speed),
          keys(),
        ),
        this.side,
      ),
    );
    onChange(() => this.show(this.index, false));
    this.show(this.start(), false);
  }

  /** Shows a motion. \param jump scrolls there and plays it */
  show(index: number, jump = true): void {
    const motion = this.catalogue.report.motions[index];
    const scene = this.catalogue.report.scenes[motion.scene];
    const facts = this.catalogue.facts(motion.run);
    const progress = index === this.index ? this.state.progress : 0;
    this.index = index;
    this.player?.dispose();
    this.player = null;
    this.state = { ...this.state, progress, playing: jump || this.state.playing };
    this.updatePickers();
    try {
      this.player = new Player(scene, motion, facts.clearance, this.state, this.sweep, (state) => this.follow(state));
      this.stage.replaceChildren(this.player.view.element);
    } catch (error) {
      this.stage.replaceChildren(
        h("p", { class: "missing" }, `This scene cannot be drawn here: ${(error as Error).message}`),
      );
    }
    this.side.replaceChildren(...this.sideParts(facts));
    if (jump) this.element.scrollIntoView({ behavior: "smooth" });
  }

  /** Moves to the motion before or after, round and round. */
  step(by: number): void {
    const count = this.catalogue.report.motions.length;
    this.show((this.index + by + count) % count, false);
  }

  key(key: string): boolean {
    const { player } = this;
    if (!player) return false;
    const actions: Record<string, () => void> = {
      " ": () => player.toggle(),
      ArrowRight: () => player.seek(this.state.progress + 0.01),
      ArrowLeft: () => player.seek(this.state.progress - 0.01),
      Home: () => player.seek(0),
      End: () => player.seek(1),
      l: () => this.flip(this.loop),
      s: () => this.flip(this.swept),
      n: () => this.step(1),
      p: () => this.step(-1),
      "+": () => player.view.zoom(1.25),
      "-": () => player.view.zoom(0.8),
      "0": () => player.view.reset(),
    };
    actions[key]?.();
    return key in actions;
  }

  /** The first motion to show: one with a slice, else one that counts. */
  private start(): number {
    const { motions } = this.catalogue.report;
    const sliced = motions.findIndex(({ slice }) => slice !== null);
    return sliced >= 0
      ? sliced
      : Math.max(
          0,
          motions.findIndex(({ run }) => this.catalogue.facts(run).solved),
        );
  }

  private flip(label: HTMLLabelElement): void {
    label.querySelector("input")!.click();
  }

  private checkbox(id: string, name: string, on: boolean, change: (on: boolean) => void): HTMLLabelElement {
    const box = h("input", { type: "checkbox", id, checked: on, change: () => change(box.checked) });
    return h("label", {}, box, name);
  }

  private follow(state: Playback): void {
    this.state = state;
    const progress = Math.min(1, state.progress);
    this.scrub.value = String(Math.round(1000 * progress));
    this.place.textContent = `${Math.round(100 * progress)} %`;
    this.play.textContent = state.playing ? "❚❚ Pause" : "▶ Play";
  }

  private updatePickers(): void {
    const { report } = this.catalogue;
    const { scene, run } = report.motions[this.index];
    const { planner } = this.catalogue.facts(run);
    const planners = this.catalogue.planners(scene);
    const motions = this.catalogue.motions(scene, planner);
    const first = (s: number, p: string): void => this.show(this.catalogue.motions(s, p)[0].index, false);
    const labelled = (name: string, list: HTMLElement): HTMLElement => h("label", {}, h("span", {}, name), list);
    this.pickers.replaceChildren(
      labelled(
        "Scenario",
        select(
          "Scenario",
          report.scenes.map(({ name }) => name),
          scene,
          (i) => {
            const others = this.catalogue.planners(i);
            first(i, others.includes(planner) ? planner : others[0]);
          },
        ),
      ),
      labelled(
        "Planner",
        select("Planner", planners, planners.indexOf(planner), (i) => first(scene, planners[i])),
      ),
      labelled(
        "Run",
        select(
          "Run",
          motions.map(({ motion }) => this.describe(motion.run, motion.why)),
          motions.findIndex(({ index }) => index === this.index),
          (i) => this.show(motions[i].index, false),
        ),
      ),
    );
  }

  private describe(run: number, why: string): string {
    const facts = this.catalogue.facts(run);
    const checker = facts.instance.split("_").pop();
    return `run ${facts.run}, ${checker}: ${why}${facts.solved ? "" : ` (${facts.reason || facts.outcome})`}`;
  }

  private sideParts(facts: RunFacts): HTMLElement[] {
    const motion = this.catalogue.report.motions[this.index];
    const scene = this.catalogue.report.scenes[motion.scene];
    const command = `narrows replay ${this.catalogue.report.campaign.file} ${motion.run}`;
    const lines: [string, string][] = [
      ["Outcome", facts.solved ? "solved, verified" : `${facts.outcome}${facts.reason ? `: ${facts.reason}` : ""}`],
      ["CPU time", duration(facts.cpu)],
      ["Length", facts.length === null ? "–" : `${brief(facts.length)} rad`],
      ["Verified clearance", brief(facts.clearance)],
      ["Evaluations", brief(facts.evaluations)],
      [
        "Waypoints",
        motion.stored === motion.path.length
          ? String(motion.stored)
          : `${motion.path.length} shown of ${motion.stored}`,
      ],
      ["Joints", String(scene.dimension)],
    ];
    const parts: HTMLElement[] = [
      h("dl", { class: "facts" }, ...lines.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)])),
    ];
    if (this.player?.slice) parts.push(this.player.slice.element);
    if (this.player)
      parts.push(h("h3", {}, "Clearance over the way, and the verified least (dashed)"), this.player.chart.element);
    if (scene.leftOut)
      parts.push(
        h(
          "p",
          { class: "note" },
          `${scene.leftOut} obstacles have too many triangles for this page and are not shown.`,
        ),
      );
    const copy = h(
      "button",
      { type: "button", class: "small", click: () => void navigator.clipboard?.writeText(command) },
      "Copy",
    );
    parts.push(h("details", {}, h("summary", {}, "Do this run again"), h("code", {}, command), copy));
    return parts;
  }
}

function keys(): HTMLElement {
  const hint = (name: string, what: string): HTMLElement => h("span", {}, h("kbd", {}, name), ` ${what}`);
  return h(
    "p",
    { class: "keys" },
    hint("space", "play"),
    hint("← →", "scrub"),
    hint("N P", "next, previous"),
    hint("L", "loop"),
    hint("S", "sweep"),
    hint("+ − 0", "zoom"),
    hint("D", "dark"),
  );
}
