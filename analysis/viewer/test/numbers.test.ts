// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";

import { heatColour, shade } from "../src/charts/heat";
import { edges } from "../src/charts/phase";
import { linear, linearTicks, log, logTicks } from "../src/charts/scale";
import { stepPath } from "../src/charts/steps";
import { linePath } from "../src/charts/trend";
import { brief, csv, duration } from "../src/format";
import { type Column, filtered, sorted } from "../src/table";

describe("numbers as text", () => {
  it.each([
    [null, "–"],
    [0, "0"],
    [0.00123456, "0.00123"],
    [1234.5, "1230"],
    [123456, "123,456"],
    [2.5e-7, "2.50e-7"],
    [3e7, "3.00e7"],
  ])("%s is written as %s", (value, text) => expect(brief(value)).toBe(text));

  it("durations have the unit that suits them", () =>
    expect([1.5e-5, 0.0425, 2, null].map(duration)).toEqual(["15 µs", "42.5 ms", "2 s", "–"]));

  it("csv quotes what would break it", () =>
    expect(
      csv(
        ["a", "b"],
        [
          ["x,y", 1],
          ['say "no"', null],
        ],
      ),
    ).toBe('a,b\r\n"x,y",1\r\n"say ""no""",\r\n'));
});

describe("scales", () => {
  it("linear ticks are round and within", () => {
    expect(linearTicks(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    expect(linearTicks(-0.37, 1.1, 4)).toEqual([0, 0.5, 1]);
    expect(linearTicks(3, 3, 4)).toEqual([3]);
  });

  it("logarithmic ticks are powers of ten, fewer if there are many", () => {
    expect(logTicks(2e-4, 30, 7)).toEqual([1e-3, 1e-2, 0.1, 1, 10]);
    expect(logTicks(1e-6, 1e6, 5)).toEqual([1e-6, 1e-3, 1, 1e3, 1e6]);
    expect(logTicks(2, 5, 5)).toEqual([2, 5]);
  });

  it("map their ends to the picture's and the geometric mean to the middle", () => {
    const x = log(0.01, 100, 50, 250);
    expect([x(0.01), x(1), x(100)]).toEqual([50, 150, 250]);
    expect(linear(0, 4, 100, 0)(1)).toBe(75);
  });

  it("a step curve rises only at its steps", () => {
    const [x, y] = [linear(0, 10, 0, 100), linear(0, 1, 100, 0)];
    const series = { name: "a", ours: true, x: [2, 5], y: [0.5, 1] };
    expect(stepPath(series, x, y, 0, 10)).toBe("M0.0,100.0H20.0V50.0H50.0V0.0H100.0");
  });

  it("lines join their points on logarithmic axes", () => {
    const series = { name: "a", ours: true, x: [0.01, 0.1, 1], y: [1, 100, 10] };
    expect(linePath(series, log(0.01, 1, 0, 100), log(1, 100, 50, 0))).toBe("M0.0,50.0L50.0,0.0L100.0,25.0");
  });

  it("cells of a logarithmic axis meet halfway", () => {
    const borders = edges([0.01, 0.1, 1]);
    [10 ** -2.5, 10 ** -1.5, 10 ** -0.5, 10 ** 0.5].forEach((edge, i) => expect(borders[i]).toBeCloseTo(edge, 12));
  });

  it("heat is least at 0 and most at 1", () => {
    expect([shade(1, 1, 100), shade(10, 1, 100), shade(100, 1, 100)]).toEqual([0, 0.5, 1]);
    expect([heatColour(0), heatColour(0.5), heatColour(1)]).toEqual([
      "rgb(0,125,120)",
      "rgb(238,214,160)",
      "rgb(178,58,30)",
    ]);
  });
});

describe("tables", () => {
  const rows = [
    { name: "b10", time: 2 },
    { name: "b9", time: null },
    { name: "A", time: 1 },
    { name: "c", time: 1 },
  ];
  const columns: Column<(typeof rows)[number]>[] = [
    { title: "name", value: (r) => r.name },
    { title: "time", value: (r) => r.time },
  ];
  const names = (list: typeof rows): string[] => list.map(({ name }) => name);

  it("sort numbers by value, what is missing last both ways, equal ones as they were", () => {
    expect(names(sorted(rows, columns, { column: 1, down: false }))).toEqual(["A", "c", "b10", "b9"]);
    expect(names(sorted(rows, columns, { column: 1, down: true }))).toEqual(["b10", "A", "c", "b9"]);
  });

  it("sort names as people count", () =>
    expect(names(sorted(rows, columns, { column: 0, down: false }))).toEqual(["A", "b9", "b10", "c"]));

  it("filter by every word", () => {
    expect(names(filtered(rows, columns, "B"))).toEqual(["b10", "b9"]);
    expect(names(filtered(rows, columns, "b 2"))).toEqual(["b10"]);
    expect(filtered(rows, columns, " ")).toBe(rows);
  });
});
