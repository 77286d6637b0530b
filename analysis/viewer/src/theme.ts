// SPDX-License-Identifier: BSD-3-Clause
// Light and dark: the system's choice until the reader makes one.

import { h } from "./dom";

export type Theme = "light" | "dark";

const listeners = new Set<() => void>();

export function current(): Theme {
  const chosen = document.documentElement.dataset.theme;
  if (chosen === "light" || chosen === "dark") return chosen;
  return window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/** Calls back whenever the theme changes. */
export function onChange(listener: () => void): void {
  listeners.add(listener);
}

/** A colour of the style sheet, for what is drawn on canvases. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function announce(): void {
  listeners.forEach((listener) => listener());
}

/** The button that switches. */
export function themeButton(): HTMLElement {
  const button = h("button", { type: "button", id: "theme", title: "Light or dark (key: D)", click: toggle });
  const label = (): void => {
    button.textContent = current() === "dark" ? "☀ Light" : "☾ Dark";
  };
  onChange(label);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", announce);
  label();
  return button;
}

export function toggle(): void {
  document.documentElement.dataset.theme = current() === "dark" ? "light" : "dark";
  announce();
}
