# SPDX-License-Identifier: BSD-3-Clause
"""Runs 06_baseline_durations and looks at its table: PROGRAM"""
import subprocess
import sys


def main():
    program = sys.argv[1]
    first, again = (subprocess.run([program, "10"], capture_output=True, text=True, check=True).stdout for _ in range(2))
    assert first == again
    table = {row[1].strip(): [cell.strip() for cell in row[2:-1]] for row in (line.split("|") for line in first.splitlines())}
    del table["method"], table["---"]
    assert len(table) == 10, table.keys()
    assert table["stops, seven phases"] == ["1.000"] * 3, table
    ratios = {name: [float(cell.split()[0]) for cell in cells] for name, cells in table.items()}
    for name, cells in table.items():
        infinite = name in ("stops, trapezoid", "stops, parabolic blends", "cubic spline")
        assert all(cell.endswith("(∞)") == infinite for cell in cells), (name, cells)
    ours = ratios["overlapped moves, within 0.2 rad of the polyline"]
    assert all(own < 1.0 for own in ours), ours
    assert all(own < other for own, other in zip(ours, ratios["via-point spline, quintic step"])), ratios
    assert all(own < 1.0 for own in ratios["stops, trapezoid"]), ratios
    for wrong in ("0", "many"):
        run = subprocess.run([program, wrong], capture_output=True, text=True, check=False)
        assert run.returncode == 1 and run.stderr, wrong


if __name__ == "__main__":
    main()
