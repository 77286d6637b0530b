# SPDX-License-Identifier: BSD-3-Clause
"""Builds examples/plugin by itself, as somebody else would, and plans with it: check_plugin.py NARROWS SOURCES FOLDER"""

import pathlib
import shutil
import sqlite3
import subprocess
import sys


def main(program, sources, folder):
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    build = folder / "build"
    subprocess.run(
        ["cmake", "-S", f"{sources}/examples/plugin", "-B", build, "-D", f"NARROWS_INCLUDE={sources}/src"], check=True
    )
    subprocess.run(["cmake", "--build", build], check=True)
    plugin = build / "libstagger.so"

    listed = subprocess.run(
        [program, "list", "planners", "--plugin", plugin], check=True, capture_output=True, text=True
    ).stdout
    assert "stagger" in listed and "plugin libstagger.so" in listed, listed
    shown = subprocess.run(
        [program, "--plugin", plugin, "show", "planner", "stagger"], check=True, capture_output=True, text=True
    ).stdout
    assert "tries" in shown, shown

    experiment = folder / "plugin.cfg"
    experiment.write_text(
        f"[problem]\nname = plugin\nscenario = {sources}/experiments/scenarios/gap_small.yaml\n"
        "[benchmark]\nrun_count = 5\nwarm_up = 0\n[planner]\nrrtconnect =\nstagger =\nstagger.tries = 50\n"
    )
    refused = subprocess.run([program, "bench", experiment], capture_output=True, text=True)
    assert refused.returncode == 2 and "stagger" in refused.stderr, refused.stderr
    subprocess.run([program, "bench", experiment, "--plugin", plugin], check=True)
    database = sqlite3.connect(folder / "plugin.db")
    runs = database.execute(
        "SELECT outcome, json_extract(parameters, '$.tries'), runs.id FROM runs"
        " JOIN plannerConfigs ON plannerConfigs.id = plannerid WHERE name = 'stagger'"
    ).fetchall()
    assert [run[:2] for run in runs] == [("solved", "50")] * 5, runs
    (plugins,) = database.execute("SELECT plugins FROM environments").fetchone()
    assert plugins.startswith("libstagger.so ") and len(plugins.split()[1]) == 64, plugins
    database.close()
    subprocess.run([program, "replay", folder / "plugin.db", str(runs[0][2]), "--plugin", plugin], check=True)


main(*sys.argv[1:])
