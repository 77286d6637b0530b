# SPDX-License-Identifier: BSD-3-Clause
"""HPPM's slices of joint space: curves of the campaign traced again, with what is around them."""

import base64
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from report_rows import scenario_texts

SECONDS = 60  # for one slice
DIGITS = 6


def packed(rows):
    """A picture of '#' and '.' as bits, rows after each other, in base64."""
    bits = np.array([[cell == "#" for cell in row] for row in rows])
    return base64.b64encode(np.packbits(bits.ravel()).tobytes()).decode(), bits


def short(values):
    return [[float(f"{value:.{DIGITS}g}") for value in row] for row in values]


def page_slice(view):
    """\\return a dictionary for analysis/viewer/src/model.ts (Slice)"""
    obstacles = []
    for obstacle in view["obstacles"]:
        bits, picture = packed(obstacle["rows"])
        if picture.any():
            obstacles.append({"name": obstacle["name"], "bits": bits})
    rows = view["obstacles"][0]["rows"] if view["obstacles"] else [""]
    kept = {key: view[key] for key in ("status", "joins", "bottleneck", "spacing", "lambda", "deviation")}
    return {
        **kept,
        "tracedFrom": view["traced_from"],
        "columns": len(rows[0]),
        "rows": len(rows),
        "obstacles": obstacles,
        **{key: short(view[key]) for key in ("curve", "rejected", "path", "middle")},
        "direction": view["direction"],
    }


def command(program, scenario, target, recipe, options):
    words = [program, "plan", scenario, "--planner", "hppm", "--no-recipe", "--slice", target]
    words += ["--time", str(options["time_limit"]), "--checker", options["checker"], "--motion", options["motion"]]
    for name, value in recipe.items():
        words += ["--param", f"{name}={value}"]
    return [str(word) for word in words]


def trace(program, text, recipe, options):
    """\\return the slice, or None if this run's recipe spans none that can be drawn"""
    with tempfile.TemporaryDirectory() as folder:
        scenario, target = Path(folder) / "scenario.yaml", Path(folder) / "slice.json"
        scenario.write_text(text)
        words = command(program, scenario, target, recipe, options)
        try:
            subprocess.run(words, capture_output=True, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return None
        return page_slice(json.loads(target.read_text())) if target.exists() else None


def recipes(database, motions):
    """Motions that followed a curve in a plane: (number of the motion, its experiment, its recipe)."""
    for number, motion in enumerate(motions):
        query = "SELECT experimentid, recipe FROM runs WHERE id = ?"
        row = database.execute(query, (motion["run"],)).fetchone()
        recipe = json.loads(row["recipe"] or "{}")
        if recipe.get("search") == "paper" and recipe.get("form") == "plane":
            yield number, row["experimentid"], recipe


def collect(database, path, motions, program, most):
    """Slices for the first of a scene's motions that has one. \\return slices by the motion's number, and how many
    scenes could have had one"""
    slices, tried = {}, set()
    for number, experiment, recipe in recipes(database, motions):
        key = motions[number]["scene"], json.dumps(recipe, sort_keys=True)
        if motions[number]["scene"] in {motions[done]["scene"] for done in slices} or key in tried:
            continue
        tried.add(key)
        if program is None or len(slices) >= most:
            continue
        text, options = scenario_texts(path, [experiment])[experiment]
        view = trace(program, text, recipe, options)
        if view is not None:
            slices[number] = view
    return slices, len({scene for scene, _ in tried})
