// SPDX-License-Identifier: BSD-3-Clause
// One motion on show: the views of it, and the clock that moves them together.

import type { Motion, Scene, Vector } from "../model";
import { affordable, clearance, curve } from "./clearance";
import { ClearanceChart } from "./clearanceChart";
import { place } from "./kinematics";
import { PlanarView } from "./planarView";
import { SliceView } from "./sliceView";
import { SpatialView } from "./spatialView";
import { advance, type Playback, Timeline, toggled } from "./timeline";
import type { ArmView } from "./view";

export class Player {
  readonly view: ArmView;
  readonly chart: ClearanceChart;
  readonly slice: SliceView | null;
  readonly timeline: Timeline;
  private probe: Vector | null = null;
  private frame = 0;
  private before = 0;

  /**
   * \param state from the last motion: loop, speed and whether it plays are kept
   * \param changed is told of every change, to show it on buttons and sliders
   * \throws Error if the scene is in space and the browser has no WebGL
   */
  constructor(
    scene: Scene,
    motion: Motion,
    verified: number | null,
    public state: Playback,
    public sweep: boolean,
    private readonly changed: (state: Playback) => void,
  ) {
    this.timeline = new Timeline(motion.path);
    this.view =
      scene.robot.kind === "planar" ? new PlanarView(scene, this.timeline) : new SpatialView(scene, this.timeline);
    const poses = affordable(scene.robot.radii.length, scene.obstacles);
    const values = curve(
      (progress) => clearance(place(scene.robot, this.timeline.at(progress)), scene.obstacles),
      poses,
    );
    this.chart = new ClearanceChart(values, verified, (progress) => this.seek(progress));
    this.slice = motion.slice && new SliceView(motion.slice, (row) => ((this.probe = row), this.draw()));
    this.update();
  }

  toggle(): void {
    this.state = toggled(this.state);
    this.update();
  }

  seek(progress: number): void {
    this.state = { ...this.state, progress: Math.min(1, Math.max(0, progress)) };
    this.update();
  }

  set(change: Partial<Playback>): void {
    this.state = { ...this.state, ...change };
    this.update();
  }

  showSweep(sweep: boolean): void {
    this.sweep = sweep;
    this.draw();
  }

  /** All that is drawn, drawn again. */
  draw(): void {
    const row = this.timeline.at(this.state.progress);
    this.view.draw({ row, probe: this.probe, sweep: this.sweep });
    this.slice?.draw(row);
    this.chart.show(this.state.progress);
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.view.dispose();
    this.chart.dispose();
    this.slice?.dispose();
  }

  private update(): void {
    this.draw();
    this.changed(this.state);
    cancelAnimationFrame(this.frame);
    this.before = 0;
    if (this.state.playing) this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    const seconds = this.before ? Math.min(0.1, (now - this.before) / 1000) : 0;
    this.before = now;
    this.state = advance(this.state, seconds);
    this.draw();
    this.changed(this.state);
    if (this.state.playing) this.frame = requestAnimationFrame((next) => this.tick(next));
  }
}
