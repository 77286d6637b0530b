#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two builds of a micro-benchmark by paired ratios.

    bench/compare.py OLD_PROGRAM NEW_PROGRAM [--rounds 15] [--filter REGEX] [--min-time SECONDS]

The programs take turns, round by round, the first one changing, so that what else the machine does meets both alike. Of every benchmark and
round the ratio new : old of CPU times is one number; printed are their median, and the median's 95 % interval by order
statistics. Two commits: build each into its own directory, e.g. with `git worktree`.
"""
import argparse
import json
import math
import statistics
import subprocess
import sys


def measure(program, options):
    """CPU time per benchmark, in nanoseconds."""
    done = subprocess.run([program, "--benchmark_format=json", f"--benchmark_filter={options.filter}",
                           f"--benchmark_min_time={options.min_time}"], check=True, capture_output=True, text=True)
    units = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    return {row["name"]: row["cpu_time"] * units[row["time_unit"]]
            for row in json.loads(done.stdout)["benchmarks"] if not row.get("error_occurred")}


def median_interval(values, confidence=0.95):
    """Median, and the order statistics that enclose the true one with at least that confidence, if there are enough."""
    ordered, n = sorted(values), len(values)
    below = 0.0
    rank = 0  # how many may be left out on either side
    while rank < n // 2:
        below += math.comb(n, rank) * 0.5 ** n
        if 2.0 * below > 1.0 - confidence:
            break
        rank += 1
    lower = ordered[rank - 1] if rank > 0 else float("-inf")
    upper = ordered[n - rank] if rank > 0 else float("inf")
    return statistics.median(ordered), lower, upper


def compare(rounds):
    """Rows (name, median ratio, lower, upper) of rounds, each a pair of measure()'s results (old, new)."""
    names = [name for name in rounds[0][0] if all(name in old and name in new for old, new in rounds)]
    return [(name, *median_interval([new[name] / old[name] for old, new in rounds])) for name in names]


def verdict(lower, upper):
    return "faster" if upper < 1.0 else "slower" if lower > 1.0 else "no difference shown"


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--filter", default=".")
    parser.add_argument("--min-time", type=float, default=0.05)
    options = parser.parse_args(arguments)
    if options.rounds < 6:
        parser.error("--rounds must be at least 6: fewer give no interval")
    rounds = []
    for k in range(options.rounds):
        if k % 2 == 0:
            old, new = measure(options.old, options), measure(options.new, options)
        else:
            new, old = measure(options.new, options), measure(options.old, options)
        rounds.append((old, new))
    for name, ratio, lower, upper in compare(rounds):
        print(f"{name:50s} {ratio:6.3f}  [{lower:.3f}, {upper:.3f}]  {verdict(lower, upper)}")


if __name__ == "__main__":
    main(sys.argv[1:])
