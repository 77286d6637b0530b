# SPDX-License-Identifier: BSD-3-Clause
"""Runs 03_moving_pipe and looks at how it ends: PROGRAM SCENARIO.yaml"""
import re
import subprocess
import sys

# Velocities of the pipe: at rest, towards the arm, past it, away; and one that takes it over the base.
ARRIVES = [(0, 0), (-60, -50), (0, 20), (30, 0)]
BEYOND_HELP = (-100, -100)


def run(velocity, *more):
    command = [*sys.argv[1:], *map(str, velocity), *more]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def main():
    for velocity in ARRIVES:
        result = run(velocity)
        found = re.match(r"arrived after (\d+) ticks: (\d+) motions, clearance ([\d.]+) proven", result.stdout)
        assert result.returncode == 0 and found, (velocity, result)
        assert int(found[2]) > 40 and float(found[3]) > 5.0, (velocity, result.stdout)
    hit = run(BEYOND_HELP)
    assert hit.returncode == 1 and hit.stdout.startswith("the pipe reaches the arm"), hit
    told = run((0, 20), "all").stdout.splitlines()
    assert len(told) > 40 and all("goes" in line or "waits (" in line for line in told[:-1]), told[:3]
    assert subprocess.run(sys.argv[1:2], capture_output=True, check=False).returncode == 2


if __name__ == "__main__":
    main()
