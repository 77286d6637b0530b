// SPDX-License-Identifier: BSD-3-Clause
// An arm in space, drawn by three.js: dragging turns, wheel or buttons zoom, the right button moves.

import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Group,
  InstancedMesh,
  CylinderGeometry,
  EdgesGeometry,
  Line,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Object3D,
  PerspectiveCamera,
  Quaternion,
  Scene as Stage,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import { h } from "../dom";
import type { Obstacle, Scene, Vector } from "../model";
import { colour } from "../theme";
import { type Link, place } from "./kinematics";
import type { Timeline } from "./timeline";
import { type ArmView, type Shown, SWEPT, sweepColour } from "./view";

const UP = new Vector3(0, 1, 0); // the axis of three.js's cylinders
const SIDES = 20;

/** An arm of cylinders and balls that is moved by matrices; links are drawn `least` thick at least. */
class Body {
  readonly group = new Group();
  private readonly tubes: InstancedMesh;
  private readonly balls: InstancedMesh;

  constructor(
    links: number,
    material: MeshLambertMaterial,
    private readonly least: number,
    private readonly factor = 1,
  ) {
    this.tubes = new InstancedMesh(new CylinderGeometry(1, 1, 1, SIDES, 1, true), material, links);
    this.balls = new InstancedMesh(new SphereGeometry(1, SIDES, SIDES / 2), material, 2 * links);
    this.tubes.frustumCulled = this.balls.frustumCulled = false;
    this.group.add(this.tubes, this.balls);
  }

  pose(links: Link[], offset = 0): void {
    links.forEach((link, index) => {
      const [from, to] = [new Vector3(...link.from), new Vector3(...link.to)];
      const along = to.clone().sub(from);
      const radius = this.factor * Math.max(link.radius, this.least);
      const turn = new Quaternion().setFromUnitVectors(UP, along.clone().normalize());
      const size = new Vector3(radius, along.length(), radius);
      const i = offset + index;
      this.tubes.setMatrixAt(i, new Matrix4().compose(from.clone().add(to).multiplyScalar(0.5), turn, size));
      const ball = new Vector3(radius, radius, radius);
      this.balls.setMatrixAt(2 * i, new Matrix4().compose(from, turn, ball));
      this.balls.setMatrixAt(2 * i + 1, new Matrix4().compose(to, turn, ball));
    });
    this.tubes.instanceMatrix.needsUpdate = this.balls.instanceMatrix.needsUpdate = true;
  }

  tint(index: number, shade: Color): void {
    this.tubes.setColorAt(index, shade);
    this.balls.setColorAt(2 * index, shade);
    this.balls.setColorAt(2 * index + 1, shade);
  }
}

function material(name: string, opacity: number): MeshLambertMaterial {
  return new MeshLambertMaterial({
    color: colour(name),
    opacity,
    transparent: opacity < 1,
    depthWrite: opacity === 1,
    side: DoubleSide,
  });
}

function solid(obstacle: Obstacle): Group {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array((obstacle.vertices ?? []).flat()), 3));
  geometry.setIndex((obstacle.triangles ?? []).flat());
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  const edges = new LineSegments(
    new EdgesGeometry(geometry, 25),
    new LineBasicMaterial({ color: colour("obstacle-edge"), transparent: true, opacity: 0.5 }),
  );
  return new Group().add(new Mesh(flat, material("obstacle", 0.42)), edges);
}

function polyline(points: Vector[], name: string): Line {
  const geometry = new BufferGeometry().setFromPoints(points.map((p) => new Vector3(...p)));
  return new Line(geometry, new LineBasicMaterial({ color: colour(name) }));
}

export class SpatialView implements ArmView {
  readonly element: HTMLCanvasElement;
  private readonly stage = new Stage();
  private readonly camera = new PerspectiveCamera(38, 1, 0.001, 1e5);
  private readonly renderer: WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly observer: ResizeObserver;
  private readonly swept: Link[][];
  private readonly center = new Vector3();
  private reach = 1;
  private arm!: Body;
  private probe!: Body;
  private sweep!: Group;

  /** \throws Error if the browser has no WebGL */
  constructor(
    private readonly scene: Scene,
    timeline: Timeline,
  ) {
    this.element = h("canvas", { class: "stage", role: "img", "aria-label": `The arm in ${scene.name}` });
    this.renderer = new WebGLRenderer({
      canvas: this.element,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.swept = timeline.poses(SWEPT).map((row) => place(scene.robot, row));
    this.measure();
    this.furnish();
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.element);
    this.controls.addEventListener("change", () => this.render());
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.element);
    this.reset();
  }

  draw(shown: Shown): void {
    this.arm.pose(place(this.scene.robot, shown.row));
    this.probe.group.visible = shown.probe !== null;
    if (shown.probe) this.probe.pose(place(this.scene.robot, shown.probe));
    this.sweep.visible = shown.sweep;
    this.render();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.controls.update();
    this.render();
  }

  reset(): void {
    const distance = (2.05 * this.reach) / Math.min(1, this.camera.aspect);
    this.controls.target.copy(this.center);
    this.camera.position.copy(this.center).add(new Vector3(0.5, -0.8, 0.42).normalize().multiplyScalar(distance));
    this.camera.near = 0.001 * this.reach;
    this.camera.far = 100 * this.reach;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.render();
  }

  dispose(): void {
    this.observer.disconnect();
    this.controls.dispose();
    this.stage.traverse((part: Object3D) => {
      if (part instanceof Mesh || part instanceof LineSegments || part instanceof Line) {
        part.geometry.dispose();
        (part.material as LineBasicMaterial).dispose();
      }
    });
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Where the arm comes to: the middle, and how far from it. */
  private measure(): void {
    const points = this.swept.flat().flatMap((link) => [new Vector3(...link.from), new Vector3(...link.to)]);
    const [low, high] = [points[0].clone(), points[0].clone()];
    for (const point of points) {
      low.min(point);
      high.max(point);
    }
    this.center.copy(low).add(high).multiplyScalar(0.5);
    this.reach = Math.max(1e-6, high.distanceTo(low) / 2);
  }

  private furnish(): void {
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(0.6, -1, 1.6);
    this.stage.add(new AmbientLight(0xffffff, 1.5), sun);
    for (const obstacle of this.scene.obstacles) this.stage.add(solid(obstacle));
    if (this.scene.rail) this.stage.add(polyline(this.scene.rail, "obstacle-edge"));
    if (this.scene.tipPath) this.stage.add(polyline(this.scene.tipPath, "goal"));
    if (this.scene.target) this.stage.add(this.target(this.scene.target.point, this.scene.target.tolerance));
    const links = this.swept[0].length;
    const least = 0.008 * this.reach;
    this.arm = new Body(links, material("arm", 1), least, 1.02); // over the start and the goal
    this.probe = new Body(links, material("probe", 0.85), least);
    const [start, goal] = [
      new Body(links, material("start", 0.8), least),
      new Body(links, material("goal", 0.8), least),
    ];
    start.pose(this.swept[0]);
    goal.pose(this.swept[SWEPT - 1]);
    this.sweep = this.makeSweep(links, 0.4 * least);
    this.stage.add(this.arm.group, this.probe.group, start.group, goal.group, this.sweep);
  }

  private target(point: Vector, tolerance: number): Mesh {
    const ball = new Mesh(
      new SphereGeometry(Math.max(tolerance, 0.012 * this.reach), SIDES, SIDES),
      material("goal", 0.5),
    );
    ball.position.set(point[0], point[1], point[2]);
    return ball;
  }

  private makeSweep(links: number, least: number): Group {
    const ghosts = new Body(
      links * SWEPT,
      new MeshLambertMaterial({ transparent: true, opacity: 0.09, depthWrite: false }),
      least,
    );
    this.swept.forEach((pose, i) => {
      ghosts.pose(pose, i * links);
      const [r, g, b] = sweepColour(i / (SWEPT - 1));
      pose.forEach((_, k) => ghosts.tint(i * links + k, new Color(`rgb(${r}, ${g}, ${b})`)));
    });
    const tip = polyline(
      this.swept.map((pose) => pose[pose.length - 1].to),
      "ink",
    );
    return new Group().add(ghosts.group, tip);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    const first = this.camera.aspect === 1;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (first) this.reset();
    else this.render();
  }

  private render(): void {
    this.renderer.render(this.stage, this.camera);
  }
}
