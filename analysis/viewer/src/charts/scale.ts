// SPDX-License-Identifier: BSD-3-Clause
// From numbers to places on a picture.

export interface Scale {
  (value: number): number;
  ticks: number[];
}

const STEPS = [1, 2, 5, 10];

/** Round numbers within [low, high], about `count` of them. */
export function linearTicks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * (STEPS.find((factor) => factor * power >= raw * 0.999) ?? 10);
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

/** Powers of ten within [low, high], every k-th of them if there are more than `count`. */
export function logTicks(low: number, high: number, count: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const stride = Math.max(1, Math.ceil((last - first + 1) / count));
  const ticks: number[] = [];
  for (let power = first; power <= last; power += stride) ticks.push(Number(`1e${power}`));
  return ticks.length > 1 ? ticks : [low, high];
}

export function linear(low: number, high: number, from: number, to: number, count = 5): Scale {
  const span = high > low ? high - low : 1;
  return Object.assign((value: number) => from + ((value - low) / span) * (to - from), {
    ticks: linearTicks(low, high, count),
  });
}

/** \param low, high positive */
export function log(low: number, high: number, from: number, to: number, count = 6): Scale {
  const span = high > low ? Math.log(high / low) : 1;
  return Object.assign((value: number) => from + (Math.log(value / low) / span) * (to - from), {
    ticks: logTicks(low, high, count),
  });
}
