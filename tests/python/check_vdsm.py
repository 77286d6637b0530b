# SPDX-License-Identifier: BSD-3-Clause
"""Runs analysis/vdsm.py and holds its table against the paper's numbers: PROGRAM SCENARIOS OUTPUT_DIRECTORY"""
import subprocess
import sys
from pathlib import Path

SCRIPT = Path(__file__).parents[2] / "analysis" / "vdsm.py"

# What the paper prints, and how near the measured figure must come.
NUMBERS = {
    ("vdsm_none", "largest link angle (degrees)"): (32, 0.5),
    ("vdsm_none", "largest x0 (mm)"): (465, 0.5),
    ("vdsm_none", "least x0 (mm)"): (-98, 0.5),
    ("vdsm_obs1_paper_vertical", "largest link angle (degrees)"): (39, 0.5),
    ("vdsm_obs1_paper_vertical", "largest x0 (mm)"): (538, 1.0),
    ("vdsm_obs1_paper_vertical", "least x0 (mm)"): (-98, 0.5),
}
WORDS = {
    ("vdsm_none", "joints that turn"): "1",
    ("vdsm_obs1_paper_vertical", "joints that turn"): "1 4 5 6 7 8",
    ("vdsm_obs1_paper_vertical", "joints bent at A4"): "1 7 8",
    ("vdsm_obs1_paper_vertical", "joints bent at A5"): "1 4 5 6 7 8",
    ("vdsm_obs1_paper_vertical", "joints bent at A6"): "1 4 5 6",
    ("vdsm_obs3", "joints 4 and 6 bent together"): "never",
}
LEAST = {
    ("vdsm_obs1_paper_vertical", "distance of the axes (mm)"): 265.0,
    ("vdsm_obs1", "distance of the axes (mm)"): 265.0,
    ("vdsm_obs2", "clearance of the surfaces (mm)"): 0.0,  # so that axis and surface are 61.5 apart
    ("vdsm_obs3", "distance of the axes (mm)"): 264.0,
}


def table(text):
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines()]
    return {(row[0], row[1]): row[3] for row in rows[2:]}


def main():
    program, scenarios, out = sys.argv[1:]
    run = subprocess.run([sys.executable, "-B", SCRIPT, program, scenarios, out], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    measured = table(run.stdout)
    for key, (paper, tolerance) in NUMBERS.items():
        assert abs(float(measured[key]) - paper) <= tolerance, (key, measured[key])
    for key, words in WORDS.items():
        assert measured[key] == words, (key, measured[key])
    for key, least in LEAST.items():
        assert float(measured[key]) > least, (key, measured[key])
    assert len(measured[("vdsm_obs3", "joints that turn")].split()) == 3, "six rotational degrees of freedom"
    for name in ("vdsm_none", "vdsm_obs1", "vdsm_obs2", "vdsm_obs3"):
        for kind in ("views", "curves"):
            assert "<svg" in (Path(out) / f"{name}_{kind}.svg").read_text()[:500]


if __name__ == "__main__":
    main()
