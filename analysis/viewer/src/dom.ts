// SPDX-License-Identifier: BSD-3-Clause
// Elements by function call, so that text never becomes markup.

type Child = Node | string;

interface Attributes {
  [name: string]: string | number | boolean | ((event: Event) => void) | undefined;
}

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
}

/** An HTML element. Functions among the attributes listen to the event of that name. */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

/** An SVG element. */
export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  fill(element, attributes, children);
  return element;
}

/** A drop-down list. */
export function select(
  label: string,
  options: string[],
  chosen: number,
  change: (index: number) => void,
): HTMLSelectElement {
  const element = h("select", { "aria-label": label, change: () => change(element.selectedIndex) });
  options.forEach((text, index) => element.append(h("option", { value: index, selected: index === chosen }, text)));
  return element;
}

/** Hands the reader a file. */
export function save(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  h("a", { href: address, download: name }).click();
  window.setTimeout(() => URL.revokeObjectURL(address), 1000);
}
