// SPDX-License-Identifier: BSD-3-Clause
// An arm in the plane, on a canvas: wheel or buttons zoom, dragging moves.

import { h } from "../dom";
import type { Obstacle, Scene, Vector } from "../model";
import { colour } from "../theme";
import { type Camera, fit, panned, zoomed } from "./camera";
import { type Link, place } from "./kinematics";
import type { Timeline } from "./timeline";
import { type ArmView, type Shown, SWEPT, sweepColour } from "./view";

const THIN = 2.5; // pixels that a link is drawn thick at least

export class PlanarView implements ArmView {
  readonly element: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  private readonly swept: Link[][];
  private readonly observer: ResizeObserver;
  private camera: Camera | null = null;
  private shown: Shown | null = null;

  constructor(
    private readonly scene: Scene,
    timeline: Timeline,
  ) {
    this.element = h("canvas", { class: "stage", role: "img", "aria-label": `The arm in ${scene.name}` });
    this.context = this.element.getContext("2d")!;
    this.swept = timeline.poses(SWEPT).map((row) => place(scene.robot, row));
    this.element.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
    this.element.addEventListener("pointermove", (event) => this.onDrag(event));
    this.element.addEventListener("pointerdown", (event) => this.element.setPointerCapture(event.pointerId));
    this.element.addEventListener("dblclick", () => this.reset());
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.element);
  }

  draw(shown: Shown): void {
    this.shown = shown;
    if (!this.camera) return;
    const { width, height } = this.element;
    const ratio = window.devicePixelRatio;
    const { center, scale } = this.camera;
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, width, height);
    this.context.setTransform(
      ratio * scale,
      0,
      0,
      -ratio * scale,
      width / 2 - ratio * scale * center[0],
      height / 2 + ratio * scale * center[1],
    );
    this.context.lineCap = this.context.lineJoin = "round";
    this.drawScene();
    if (shown.sweep) this.drawSweep();
    this.drawEnds();
    if (shown.probe) this.drawArm(place(this.scene.robot, shown.probe), colour("probe"), 0.9);
    this.drawArm(place(this.scene.robot, shown.row), colour("arm"), 1);
  }

  zoom(factor: number): void {
    this.look(this.camera && zoomed(this.camera, factor));
  }

  reset(): void {
    const points = this.swept.flat().flatMap((link) => [link.from, link.to]);
    const { clientWidth, clientHeight } = this.element;
    const reach = Math.max(...this.scene.robot.radii);
    const arm = fit(points, clientWidth, clientHeight, reach);
    // Obstacles as far as they are near: a long wall must not make the arm small.
    const half = [(0.75 * clientWidth) / arm.scale, (0.75 * clientHeight) / arm.scale];
    const near = this.scene.obstacles
      .flatMap(corners)
      .filter((p) => p.every((value, i) => Math.abs(value - arm.center[i]) < half[i]));
    this.look(fit([...points, ...near], clientWidth, clientHeight, reach));
  }

  dispose(): void {
    this.observer.disconnect();
  }

  private look(camera: Camera | null): void {
    this.camera = camera;
    if (this.shown) this.draw(this.shown);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0) return;
    this.element.width = Math.round(clientWidth * window.devicePixelRatio);
    this.element.height = Math.round(clientHeight * window.devicePixelRatio);
    this.reset();
  }

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    const pixel = [event.offsetX - this.element.clientWidth / 2, this.element.clientHeight / 2 - event.offsetY];
    this.look(this.camera && zoomed(this.camera, Math.exp(-0.002 * event.deltaY), pixel));
  }

  private onDrag(event: PointerEvent): void {
    if (event.buttons === 1) this.look(this.camera && panned(this.camera, event.movementX, -event.movementY));
  }

  private line(points: Vector[], style: string, width: number): void {
    this.context.beginPath();
    points.forEach((point, i) =>
      i ? this.context.lineTo(point[0], point[1]) : this.context.moveTo(point[0], point[1]),
    );
    this.context.strokeStyle = style;
    this.context.lineWidth = width;
    this.context.stroke();
  }

  private pixel(): number {
    return 1 / this.camera!.scale;
  }

  private drawScene(): void {
    const { context } = this;
    for (const obstacle of this.scene.obstacles) {
      context.beginPath();
      if (obstacle.circle) context.arc(...obstacle.circle, 0, 2 * Math.PI);
      else obstacle.outline?.forEach((p, i) => (i ? context.lineTo(p[0], p[1]) : context.moveTo(p[0], p[1])));
      context.closePath();
      context.fillStyle = colour("obstacle");
      context.strokeStyle = colour("obstacle-edge");
      context.lineWidth = this.pixel();
      context.fill();
      context.stroke();
    }
    if (this.scene.rail) this.line(this.scene.rail, colour("obstacle-edge"), 2 * this.pixel());
    if (this.scene.target)
      this.ring(this.scene.target.point, Math.max(this.scene.target.tolerance, 5 * this.pixel()), colour("goal"));
  }

  private ring(point: Vector, radius: number, style: string): void {
    this.context.beginPath();
    this.context.arc(point[0], point[1], radius, 0, 2 * Math.PI);
    this.context.strokeStyle = style;
    this.context.lineWidth = 2 * this.pixel();
    this.context.stroke();
  }

  /** The arm as thick as it is, and its joints. */
  private drawArm(links: Link[], style: string, alpha: number): void {
    const pixel = this.pixel();
    this.context.globalAlpha = alpha;
    for (const link of links) this.line([link.from, link.to], style, Math.max(THIN * 1.6 * pixel, 2 * link.radius));
    for (const link of links) this.dot(link.from, link.radius);
    this.context.globalAlpha = 1;
  }

  private dot(point: Vector, radius: number): void {
    this.context.beginPath();
    this.context.arc(point[0], point[1], Math.max(2 * this.pixel(), 0.45 * radius), 0, 2 * Math.PI);
    this.context.fillStyle = colour("card");
    this.context.fill();
  }

  private drawEnds(): void {
    const ends: [Link[], string][] = [
      [this.swept[0], "start"],
      [this.swept[SWEPT - 1], "goal"],
    ];
    for (const [links, name] of ends) {
      this.context.globalAlpha = 0.55;
      for (const link of links)
        this.line([link.from, link.to], colour(name), Math.max(THIN * this.pixel(), 2 * link.radius));
      this.context.globalAlpha = 1;
    }
  }

  private drawSweep(): void {
    this.swept.forEach((links, i) => {
      const style = `rgb(${sweepColour(i / (SWEPT - 1)).join(",")})`;
      for (const link of links) {
        this.context.globalAlpha = 0.16;
        if (link.radius > 0) this.line([link.from, link.to], style, 2 * link.radius);
        this.context.globalAlpha = 0.5;
        this.line([link.from, link.to], style, 1.2 * this.pixel());
      }
    });
    this.context.globalAlpha = 1;
    this.line(
      this.swept.map((links) => links[links.length - 1].to),
      colour("ink"),
      0.8 * this.pixel(),
    );
  }
}

function corners(obstacle: Obstacle): Vector[] {
  if (!obstacle.circle) return obstacle.outline ?? [];
  const [x, y, r] = obstacle.circle;
  return [
    [x - r, y],
    [x + r, y],
    [x, y - r],
    [x, y + r],
  ];
}
