# SPDX-License-Identifier: BSD-3-Clause
"""Runs analysis/iostv.py on 05_via_point_figures and looks at the tables and pictures: PROGRAM ANALYSIS OUT"""
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, sys.argv[2])

PRINTED_DIGITS_HOLD = {  # figure, what -> printed; to all digits
    ("Fig. 2", "S_v"): "-11.9635",
    ("Fig. 2", "zeta_v"): "5.4327",
    ("Fig. 2", "iterations from S_f"): "40",
    ("Fig. 4", "zeta_v"): "-16.6294",
    ("Fig. 6", "zeta"): "-1.0328",
    ("Fig. 6", "iterations from theta_v"): "58",
    ("Fig. 8", "iterations from q_0"): "12",
    ("Fig. 9", "iterations from theta_v"): "28",
}
CLAIMS_THAT_FAIL = {("Fig. 9", "acceleration's jump at the via"): 157.98, ("Fig. 9", "highest jerk"): 1510.0}
LEAST_JERKS = {"A": 72.2, "B": 7214.0, "C": 1261.2}


def rows(text):
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]


def check_printed(table):
    measured = {(row[0], row[1]): float(row[3]) for row in table if re.fullmatch(r"[-\d.e+]+", row[3])}
    for key, printed in PRINTED_DIGITS_HOLD.items():
        digits = len(printed.partition(".")[2])
        assert abs(measured[key] - float(printed)) <= 0.51 * 10.0**-digits, (key, printed, measured[key])
    for key, value in CLAIMS_THAT_FAIL.items():
        assert abs(measured[key] - value) < 0.1, (key, measured[key])


def check_comparison(table):
    found = {(row[0], row[1]): row[2:] for row in table}
    for problem, jerk in LEAST_JERKS.items():
        own = found[problem, "sum of rises"]
        assert float(own[2]) <= jerk, (problem, own)
        assert float(own[3]) <= 0.41 and float(own[4]) < 1e-6, (problem, own)
        assert float(own[2]) < float(found[problem, "full"][2]), problem
        for infinite in ("LSPB with a stop", "cubic spline"):
            assert found[problem, infinite][2] == "∞", (problem, infinite)
    assert found["C", "Fig. 9"][1] == "∞"  # its velocity jumps
    assert found["C", "sixth order"][2] == "1693.3", found["C", "sixth order"]


def check_refusals(program, out):
    for arguments in ([], [out, out / "none.csv"]):
        run = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False)
        assert run.returncode != 0 and run.stderr, arguments


def main():
    program, analysis, out = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    command = [sys.executable, "-B", str(analysis / "iostv.py"), program, str(out)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    printed, comparison, jerks = run.stdout.split("\n\n")
    check_printed(rows(printed))
    check_comparison(rows(comparison))
    for problem, full, own, least in rows(jerks)[2:]:
        assert float(least) < float(own) < float(full), problem
    from iostv import PICTURES

    for name in PICTURES:
        assert 10_000 < (out / f"iostv-{name}.svg").stat().st_size < 130_000, name
    check_refusals(program, out)


if __name__ == "__main__":
    main()
