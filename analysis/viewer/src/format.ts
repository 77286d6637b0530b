// SPDX-License-Identifier: BSD-3-Clause
// Numbers and tables as text.

/** `digits` that count, without an exponent where it can be read so; an en dash for what was not measured. */
export function brief(value: number | null, digits = 3): string {
  if (value === null || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-5) return value.toExponential(digits - 1).replace("e+", "e");
  const text = Number(value.toPrecision(digits));
  return size >= 1e4 ? Math.round(value).toLocaleString("en") : String(text);
}

export function percent(share: number, digits = 1): string {
  return `${(100 * share).toFixed(digits)}\u00a0%`;
}

/** Seconds in a unit that suits them. */
export function duration(seconds: number | null): string {
  if (seconds === null) return "–";
  if (seconds < 1e-3) return `${brief(1e6 * seconds)} µs`;
  return seconds < 1 ? `${brief(1e3 * seconds)} ms` : `${brief(seconds)} s`;
}

/** A file with comma separated values (RFC 4180). */
export function csv(header: string[], rows: (string | number | null)[][]): string {
  const cell = (value: string | number | null): string => {
    const text = value === null ? "" : String(value);
    return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
  };
  return [header, ...rows].map((row) => row.map(cell).join(",")).join("\r\n") + "\r\n";
}
