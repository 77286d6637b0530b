// SPDX-License-Identifier: BSD-3-Clause
// The parts of the page around the motion viewer.

import { styles } from "./charts/colours";
import { figureCard } from "./charts/figure";
import { h } from "./dom";
import { brief, duration, percent } from "./format";
import type { Contest, NamedTable, Report, SummaryRow } from "./model";
import { type Catalogue, factsOf, type RunFacts } from "./motion/catalogue";
import { type Column, Table, type Value } from "./table";

export function verdictSection(report: Report): HTMLElement {
  const { headline, sentences, notes } = report.verdict;
  return h(
    "section",
    { id: "verdict" },
    h("p", { class: "eyebrow" }, "Verdict"),
    h("h1", {}, headline),
    h("p", { class: "lead" }, sentences.join(" ")),
    h("p", { class: "note" }, notes.join(" ")),
  );
}

const WINNERS = { ours: "model", theirs: "sampling", undecided: "undecided" };

const CONTEST: Column<Contest>[] = [
  { title: "Group", value: (c) => c.group },
  {
    title: "Ahead",
    value: (c) => WINNERS[c.winner],
    show: (c) => h("span", { class: `tag ${c.winner}` }, WINNERS[c.winner]),
  },
  { title: "Model planner", value: (c) => c.ours },
  { title: "Solved", value: (c) => c.ours_solved, show: (c) => percent(c.ours_solved) },
  { title: "CPU", value: (c) => c.ours_cpu, show: (c) => duration(c.ours_cpu), hint: "median over solved runs" },
  { title: "Sampling planner", value: (c) => c.theirs },
  { title: "Solved", value: (c) => c.theirs_solved, show: (c) => percent(c.theirs_solved) },
  { title: "CPU", value: (c) => c.theirs_cpu, show: (c) => duration(c.theirs_cpu), hint: "median over solved runs" },
  {
    title: "Ratio",
    value: (c) => c.lead,
    show: (c) => (c.lead === null ? "–" : `${brief(c.lead, 2)}×`),
    hint: "sampling time over model time",
  },
  {
    title: "p (Holm)",
    value: (c) => c.adjusted,
    show: (c) => brief(c.adjusted, 2),
    hint: "sign test over instances, or ranks of runs where instances are few",
  },
];

const SUMMARY: Column<SummaryRow>[] = [
  { title: "Group", value: (r) => r.group },
  { title: "Planner", value: (r) => r.planner, show: (r) => (r.ours ? h("b", {}, r.planner) : r.planner) },
  { title: "Solved", value: (r) => r.share, show: (r) => `${r.solved}/${r.runs}` },
  {
    title: "95 % interval",
    value: (r) => r.low,
    show: (r) => `${percent(r.low)} – ${percent(r.high)}`,
    hint: "Wilson",
  },
  { title: "CPU", value: (r) => r.cpu, show: (r) => duration(r.cpu), hint: "median over solved runs" },
  {
    title: "Quartiles",
    value: (r) => r.cpu_lower,
    show: (r) => (r.cpu === null ? "–" : `${duration(r.cpu_lower)} – ${duration(r.cpu_upper)}`),
  },
  {
    title: "Evaluations",
    value: (r) => r.evaluations,
    show: (r) => brief(r.evaluations),
    hint: "median: what the planner asked of model or checker",
  },
  { title: "State checks", value: (r) => r.checks, show: (r) => brief(r.checks) },
  { title: "Length", value: (r) => r.length, show: (r) => brief(r.length), hint: "median, radians" },
  {
    title: "Clearance",
    value: (r) => r.clearance,
    show: (r) => brief(r.clearance),
    hint: "median of the least over a path",
  },
];

const ENTRY: Column<Report["entries"][number]>[] = [
  { title: "Entry", value: (e) => e.name },
  {
    title: "Kind",
    value: (e) => (e.ours ? WINNERS.ours : WINNERS.theirs),
    show: (e) => (e.ours ? "sees the model" : "samples"),
  },
  { title: "Settings", value: (e) => e.settings },
];

/** A table that says itself what its columns are. */
function namedTable(table: NamedTable): HTMLElement[] {
  const columns = table.columns.map(
    ({ title, hint }, place): Column<Value[]> => ({
      title,
      hint,
      value: (row) => row[place],
      show: (row) => {
        const cell = row[place];
        return typeof cell === "string" ? cell : brief(cell);
      },
    }),
  );
  return [
    h("h3", {}, table.title),
    ...(table.note ? [h("p", { class: "note" }, table.note)] : []),
    new Table(table.id, table.rows, columns).element,
  ];
}

export function tablesSection(report: Report): HTMLElement {
  const section = h("section", { id: "tables" }, h("h2", {}, "Tables"));
  for (const table of report.tables) section.append(...namedTable(table));
  if (report.contests.length) {
    section.append(
      h("h3", {}, "Best against best, by group"),
      h(
        "p",
        { class: "note" },
        "Each side's best is the entry that solves most, then the fastest; both were picked on these very runs.",
      ),
      new Table("contests", report.contests, CONTEST).element,
    );
  }
  section.append(h("h3", {}, "All planners, by group"), new Table("groups", report.groups, SUMMARY).element);
  if (new Set(report.groups.map(({ group }) => group)).size > 1)
    section.append(h("h3", {}, "All groups together"), new Table("totals", report.totals, SUMMARY).element);
  section.append(h("h3", {}, "What the entries are"), new Table("entries", report.entries, ENTRY).element);
  return section;
}

export function figuresSection(report: Report): HTMLElement {
  const palette = styles(report.entries);
  return h(
    "section",
    { id: "figures" },
    h("h2", {}, "Figures"),
    h("div", { class: "figures" }, ...report.figures.map((figure) => figureCard(figure, palette))),
  );
}

interface ListedRun extends RunFacts {
  motion: number | undefined;
}

/** \param watch is asked for the motion of a run */
export function runsSection(catalogue: Catalogue, watch: (motion: number) => void): HTMLElement {
  const { report } = catalogue;
  const rows = report.runs.id.map((id, row): ListedRun => ({ ...factsOf(report, row), motion: catalogue.motion(id) }));
  const columns: Column<ListedRun>[] = [
    {
      title: "Motion",
      value: (r) => (r.motion === undefined ? null : 1),
      show: (r) =>
        r.motion === undefined
          ? ""
          : h("button", { type: "button", class: "small watch", click: () => watch(r.motion!) }, "▶ Watch"),
    },
    { title: "Instance", value: (r) => r.instance },
    { title: "Planner", value: (r) => r.planner },
    { title: "Run", value: (r) => r.run },
    { title: "Outcome", value: (r) => r.outcome + (r.reason ? `: ${r.reason}` : "") },
    { title: "CPU", value: (r) => r.cpu, show: (r) => duration(r.cpu) },
    { title: "Evaluations", value: (r) => r.evaluations, show: (r) => brief(r.evaluations) },
    { title: "Length", value: (r) => r.length, show: (r) => brief(r.length) },
    { title: "Clearance", value: (r) => r.clearance, show: (r) => brief(r.clearance) },
    { title: "Seed", value: (r) => r.seed },
  ];
  return h("section", { id: "runs" }, h("h2", {}, "Runs"), new Table("runs", rows, columns).element);
}

function leftOut(report: Report): string[] {
  const { paths, instances, shown, runs, slices, panels } = report.leftOut;
  const lines: string[] = [];
  if (paths)
    lines.push(
      `${paths} stored paths: of an instance and planner, at most the shortest, the one of median time and one that was not accepted are shown.`,
    );
  if (instances) lines.push(`The motions of ${instances} instances; those of ${shown} are here.`);
  if (runs) lines.push(`${runs} runs are not listed above. They count in every number and figure.`);
  if (slices) lines.push(`${slices} of HPPM's slices were not traced again.`);
  if (panels) lines.push(`${panels} groups have no panels of their own in the figures.`);
  return lines;
}

export function aboutSection(report: Report): HTMLElement {
  const { campaign, sessions } = report;
  const session = sessions[sessions.length - 1] ?? {};
  const names = Object.keys(session).filter((name) => name !== "id" && session[name] !== null && session[name] !== "");
  const missing = leftOut(report);
  return h(
    "section",
    { id: "about" },
    h("h2", {}, "What this is made of"),
    h(
      "p",
      {},
      `Every number is computed from the rows of ${campaign.file} (campaign ${campaign.name}, seed ${campaign.seed}, engine ${campaign.engine}). ` +
        "Times are CPU seconds of solve(). A path counts only if the verifier accepts it. A planner that draws no random numbers gives the same path in every run of an instance: its repeats tell about time only.",
    ),
    ...(missing.length ? [h("h3", {}, "Left out"), h("ul", {}, ...missing.map((line) => h("li", {}, line)))] : []),
    h(
      "p",
      { class: "note" },
      "Paths were thinned to within a thousandth of a radian, or a tenth of their clearance, of what is stored; their ends are exact. " +
        "Clearances over the way are distances to the surfaces as drawn; the least one beside them is the verifier's.",
    ),
    h(
      "details",
      {},
      h("summary", {}, `The machine (${sessions.length} ${sessions.length === 1 ? "session" : "sessions"})`),
      h(
        "dl",
        { class: "facts" },
        ...names.flatMap((name) => [h("dt", {}, name.replace(/_/g, " ")), h("dd", {}, String(session[name]))]),
      ),
    ),
  );
}
