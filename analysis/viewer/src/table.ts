// SPDX-License-Identifier: BSD-3-Clause
// Tables that sort by a click on their heads and filter by typing.

import { h, save } from "./dom";
import { csv } from "./format";

export type Value = string | number | null;

export interface Column<Row> {
  title: string;
  value: (row: Row) => Value; // what is sorted by, filtered by and saved
  show?: (row: Row) => string | Node; // what is read, if it differs
  hint?: string;
}

export interface Order {
  column: number;
  down: boolean;
}

/** Rows in a column's order; what was not measured comes last, either way, and equal rows stay as they were. */
export function sorted<Row>(rows: Row[], columns: Column<Row>[], order: Order | null): Row[] {
  if (order === null) return rows;
  const { value } = columns[order.column];
  const sign = order.down ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [x, y] = [value(a), value(b)];
    if (x === null || y === null) return Number(x === null) - Number(y === null);
    if (typeof x === "number" && typeof y === "number") return sign * (x - y);
    return sign * String(x).localeCompare(String(y), "en", { numeric: true });
  });
}

/** Rows in which every word of the query occurs. */
export function filtered<Row>(rows: Row[], columns: Column<Row>[], query: string): Row[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return rows;
  return rows.filter((row) => {
    const text = columns
      .map((column) => column.value(row) ?? "")
      .join(" ")
      .toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

const STEP = 50; // rows shown at once

/** A table with its filter, its count and its download. */
export class Table<Row> {
  readonly element: HTMLElement;
  private order: Order | null = null;
  private query = "";
  private shown = STEP;
  private readonly body = h("tbody");
  private readonly count = h("span", { class: "count", "aria-live": "polite" });
  private readonly more = h("button", { type: "button", click: () => this.showMore() }, "Show more");
  private readonly heads: HTMLElement[];

  constructor(
    private readonly name: string,
    private readonly rows: Row[],
    private readonly columns: Column<Row>[],
  ) {
    this.heads = columns.map(({ title, hint }, index) =>
      h("th", { scope: "col", title: hint }, h("button", { type: "button", click: () => this.sort(index) }, title)),
    );
    const cells = h("table", {}, h("thead", {}, h("tr", {}, ...this.heads)), this.body);
    const bar = h("div", { class: "bar" }, this.filter(), this.count, h("span", { class: "gap" }), this.download());
    const scroll = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": name }, cells);
    this.element = h("div", { class: "table", id: `table-${name}` }, bar, scroll, this.more);
    this.update();
  }

  private filter(): HTMLInputElement {
    const attributes = { type: "search", placeholder: "Filter…", "aria-label": `Filter ${this.name}` };
    const field = h("input", {
      ...attributes,
      input: () => {
        this.query = field.value;
        this.shown = STEP;
        this.update();
      },
    });
    return field;
  }

  private download(): HTMLElement {
    const write = (): void => {
      const rows = this.current().map((row) => this.columns.map(({ value }) => value(row)));
      const header = this.columns.map(({ title }) => title);
      save(`${this.name}.csv`, "text/csv", csv(header, rows));
    };
    return h("button", { type: "button", click: write }, "CSV");
  }

  private showMore(): void {
    this.shown += 4 * STEP;
    this.update();
  }

  private sort(column: number): void {
    this.order = { column, down: this.order?.column === column && !this.order.down };
    this.update();
  }

  private current(): Row[] {
    return sorted(filtered(this.rows, this.columns, this.query), this.columns, this.order);
  }

  private update(): void {
    const all = this.current();
    const total = this.rows.length;
    this.body.replaceChildren(...all.slice(0, this.shown).map((row) => line(row, this.columns)));
    this.count.textContent = all.length === total ? `${total} rows` : `${all.length} of ${total} rows`;
    this.more.hidden = all.length <= this.shown;
    this.heads.forEach((head, index) => {
      const direction = this.order?.down ? "descending" : "ascending";
      head.setAttribute("aria-sort", this.order?.column === index ? direction : "none");
    });
  }
}

function line<Row>(row: Row, columns: Column<Row>[]): HTMLElement {
  const cells = columns.map((column) => {
    const value = column.value(row);
    const content = column.show ? column.show(row) : value === null ? "–" : String(value);
    return h("td", { class: typeof value === "string" ? undefined : "number" }, content);
  });
  return h("tr", {}, ...cells);
}
