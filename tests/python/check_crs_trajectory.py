# SPDX-License-Identifier: BSD-3-Clause
"""Runs 01_crs_trajectory and looks at what it says and writes: PROGRAM SCENARIO_DIRECTORY OUTPUT.csv"""
import csv
import re
import subprocess
import sys

# Of the CRS-like cell: absolute degrees at the start, at goal 1 and at goal 2, and the hyperspheres of the two legs.
STATIONS = [(25, -5, 10), (95, 60, 80), (120, 10, 0)]
HYPERSPHERES = [190, 113]


def joints(row, kind):
    return [float(row[f"{kind}_{joint}_deg"]) for joint in (1, 2, 3)]


def near(angles, wanted, tolerance=2e-6):
    return all(abs(angle - want) <= tolerance for angle, want in zip(angles, wanted))


def check_report(text):
    for leg, spheres in enumerate(HYPERSPHERES, 1):
        assert f"crs-leg-{leg} full: {spheres} hyperspheres, {spheres + 1} waypoints" in text, text
        for form in ("full", "plane"):
            found = re.search(rf"crs-leg-{leg} {form}: .*clearance (\d\.\d+)", text)
            assert found and float(found.group(1)) > 0.1, text
    assert text.count("(paper: 2 ms)") == 2, text


def check_trajectory(rows):
    assert len(rows) == 1 + sum(HYPERSPHERES), len(rows)
    first_leg = [row for row in rows if row["leg"] == "1"]
    assert near(joints(rows[0], "absolute"), STATIONS[0]), rows[0]
    assert near(joints(first_leg[-1], "absolute"), STATIONS[1]), first_leg[-1]
    assert near(joints(rows[-1], "absolute"), STATIONS[2]), rows[-1]
    for before, after in zip(rows, rows[1:]):
        steps = [b - a for a, b in zip(joints(before, "absolute"), joints(after, "absolute"))]
        assert max(map(abs, steps)) <= 1.2, (before, after)  # a sphere's radius is 1.15 degrees
    for row in rows:
        a, b, c = joints(row, "absolute")
        assert near(joints(row, "relative"), (a, b - a, c - b)), row


def main():
    program, scenarios, output = sys.argv[1:]
    legs = [f"{scenarios}/crs_leg{leg}.yaml" for leg in (1, 2)]
    run = subprocess.run([program, *legs, output], capture_output=True, text=True, check=True)
    check_report(run.stdout)
    with open(output, newline="", encoding="utf-8") as file:
        check_trajectory(list(csv.DictReader(file)))
    # Legs that do not follow on each other are no trajectory.
    swapped = subprocess.run([program, *legs[::-1], output], capture_output=True, text=True, check=False)
    assert swapped.returncode == 1 and "does not begin where the leg before ends" in swapped.stderr, swapped.stderr


if __name__ == "__main__":
    main()
