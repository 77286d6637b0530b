# SPDX-License-Identifier: BSD-3-Clause
"""Runs 04_timed_trajectory and looks at what it says and writes: PROGRAM SCENARIO_DIRECTORY OUTPUT.csv"""
import csv
import math
import re
import subprocess
import sys

# Of arm_3link_1disc.yaml, relative degrees.
START, GOAL = (-55, 10, 15), (70, -15, -20)
LIMITS = {"v": 1.2, "a": 3.0, "j": 25.0}


def run(*words):
    return subprocess.run(words, capture_output=True, text=True, check=False)


def check_motion(rows, duration):
    times = [row["time"] for row in rows]
    assert times[0] == 0.0 and abs(times[-1] - duration) < 1e-3, times[-1]
    assert all(0.0 < b - a < 1.001e-3 for a, b in zip(times, times[1:]))
    for joint, (start, goal) in enumerate(zip(START, GOAL), 1):
        assert abs(rows[0][f"q_{joint}"] - math.radians(start)) < 1e-9
        assert abs(rows[-1][f"q_{joint}"] - math.radians(goal)) < 1e-9
        for row in (rows[0], rows[-1]):
            assert max(abs(row[f"v_{joint}"]), abs(row[f"a_{joint}"])) < 1e-9, row
        for kind, limit in LIMITS.items():
            assert max(abs(row[f"{kind}_{joint}"]) for row in rows) <= limit * (1 + 1e-8), (kind, joint)
        # Each column is the derivative of the one before: a step's mean speed lies between what its ends allow.
        for a, b in zip(rows, rows[1:]):
            step = b["time"] - a["time"]
            for kind, rate, bend in (("q", "v", LIMITS["a"]), ("v", "a", LIMITS["j"])):
                mean = (b[f"{kind}_{joint}"] - a[f"{kind}_{joint}"]) / step
                assert abs(mean - a[f"{rate}_{joint}"]) <= bend * step * 1.001 + 1e-6, (kind, joint, a["time"])
    # The fastest motion under limits reaches one of them.
    most = max(abs(row[f"{kind}_{joint}"]) / limit
               for row in rows for joint in (1, 2, 3) for kind, limit in LIMITS.items())
    assert most > 0.999, most


def main():
    program, scenarios, output = sys.argv[1:]
    scenario = f"{scenarios}/arm_3link_1disc.yaml"
    limits = [f"velocity={LIMITS['v']}", f"acceleration={LIMITS['a']}", f"jerk={LIMITS['j']}"]
    done = run(program, scenario, output, *limits)
    assert done.returncode == 0, done.stderr
    found = re.fullmatch(r"arm-3link-1disc: ([\d.]+) s, with stops ([\d.]+) s, clearance (\S+) proven .*\n",
                         done.stdout)
    assert found, done.stdout
    duration, stops, clearance = map(float, found.groups())
    assert duration < stops and clearance > 0.0, done.stdout
    with open(output, newline="", encoding="utf-8") as file:
        check_motion([{key: float(text) for key, text in row.items()} for row in csv.DictReader(file)], duration)
    for bad in ("velocity=0", "jerk=inf", "acceleration=1, 2"):
        refused = run(program, scenario, output, bad)
        assert refused.returncode == 1 and bad.split("=", maxsplit=1)[0] in refused.stderr, refused.stderr


if __name__ == "__main__":
    main()
