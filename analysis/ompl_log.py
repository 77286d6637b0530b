# SPDX-License-Identifier: BSD-3-Clause
"""A campaign as logs of OMPL's Benchmark class, one per instance, for OMPL's own tools (ompl_benchmark_statistics).

What a log cannot hold is left out: paths, and texts that may have more than one line.
"""

from contextlib import closing

from report_rows import open_database

LONG_TEXTS = ("parameters", "measures", "recipe", "output")
KEYS = ("id", "experimentid", "plannerid", "environmentid")
OWN_COLUMNS = ("scenario", "checker", "motion")  # of experiments, beyond OMPL's


def write_logs(path, folder):
    """\\return the files that were written"""
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    with closing(open_database(path)) as database:
        columns = [(row["name"], row["type"] or "TEXT") for row in database.execute("PRAGMA table_info(runs)")]
        columns = [(name, kind) for name, kind in columns if name not in KEYS + LONG_TEXTS]
        enums = enum_lines(database)
        for experiment in database.execute("SELECT * FROM experiments ORDER BY id").fetchall():
            target = folder / f"{experiment['name']}.log"
            lines = [*head(experiment), *enums, *planners(database, experiment["id"], columns)]
            target.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
            written.append(target)
    return written


def text_block(text):
    return ["<<<|", *(text or "").splitlines(), "|>>>"]


def head(experiment):
    version = experiment["version"].split()
    yield f"{version[0]} version {version[-1]}"
    yield f"Experiment {experiment['name']}"
    yield f"{len(OWN_COLUMNS)} experiment properties"
    for name in OWN_COLUMNS:
        yield f"{name} TEXT = {experiment[name]}"
    yield f"Running on {experiment['hostname']}"
    yield f"Starting at {experiment['date']}"
    yield from text_block(experiment["setup"])
    yield from text_block(experiment["cpuinfo"])
    yield f"{experiment['seed']} is the random seed"
    yield f"{experiment['timelimit']!r} seconds per run"
    yield f"{experiment['memorylimit']!r} MB per run"
    yield f"{experiment['runcount']} runs per planner"
    yield f"{experiment['totaltime'] or 0.0!r} seconds spent to collect the data"


def enum_lines(database):
    values = {}
    for name, description in database.execute("SELECT name, description FROM enums ORDER BY name, value"):
        values.setdefault(name, []).append(description)
    enums = "1 enum type" if len(values) == 1 else f"{len(values)} enum types"
    # OMPL's reader looks for "enum" as the last word but one.
    return [enums, *("|".join([name, *descriptions]) for name, descriptions in values.items())]


def planners(database, experiment, columns):
    """The part of a log about its planners."""
    query = """SELECT DISTINCT plannerConfigs.id AS id, name, settings FROM plannerConfigs
               JOIN runs ON runs.plannerid = plannerConfigs.id WHERE experimentid = ? ORDER BY plannerConfigs.id"""
    entries = database.execute(query, (experiment,)).fetchall()
    yield f"{len(entries)} planners"
    names = ", ".join(name for name, _ in columns)
    for entry in entries:
        settings = [part for part in (entry["settings"] or "").split(";") if part]
        yield entry["name"]
        yield f"{len(settings)} common properties"
        yield from settings
        yield f"{len(columns)} properties for each run"
        yield from (f"{name} {kind}" for name, kind in columns)
        rows = database.execute(
            f"SELECT {names} FROM runs WHERE experimentid = ? AND plannerid = ? ORDER BY run", (experiment, entry["id"])
        ).fetchall()
        yield f"{len(rows)} runs"
        yield from ("".join(cell(value) for value in row) for row in rows)
        yield "."


def cell(value):
    """All digits of a number; nothing for what was not measured."""
    return ("" if value is None else repr(value) if isinstance(value, float) else str(value)) + "; "
