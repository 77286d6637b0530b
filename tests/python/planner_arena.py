# SPDX-License-Identifier: BSD-3-Clause
"""What Planner Arena (OMPL 1.5.2, `server.R`) reads of a database: the same tables, the same joins, the same columns by
their places. `tools/check-planner-arena` opens the program itself, which takes R and a gigabyte."""

import sqlite3
from contextlib import closing

import pandas

IDS = ["id", "experimentid", "plannerid"]  # of runs, to be left out of the attributes by their places
COMMON = ["id", "name", "totaltime", "timelimit", "memorylimit", "runcount"]
COMMON += ["version", "hostname", "cpuinfo", "date", "seed", "setup"]  # what comes after them is a parameter


class Arena:
    """The frames that it makes when a database is opened.
    \\throws ValueError telling what it would stumble over"""

    def __init__(self, database):
        with closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
            try:
                tables = {
                    name: pandas.read_sql_query(f"SELECT * FROM {name}", connection)
                    for name in ("experiments", "plannerConfigs", "runs", "progress", "enums")
                }
            except pandas.errors.DatabaseError as error:
                raise ValueError(str(error)) from error
        self._runs, self._enums = tables["runs"], tables["enums"]
        self._check_columns(tables)
        experiments = tables["experiments"].rename(columns={"id": "experiment.id", "name": "experiment"})
        planners = tables["plannerConfigs"].rename(columns={"id": "planner.id", "name": "planner"})
        self.extended = planners.merge(
            self._runs.rename(columns={"id": "run.id"}),
            left_on="planner.id",
            right_on="plannerid",
            suffixes=(".planner", ".run"),
        ).merge(
            experiments, left_on="experimentid", right_on="experiment.id", suffixes=(".plannerrun", ".experiment")
        )
        self.parameters = list(experiments.columns[len(COMMON) :])
        self._check_rows(experiments)

    @property
    def attributes(self):
        """What can be chosen to be plotted."""
        return list(self._runs.columns[len(IDS) :])

    @property
    def plotted(self):
        """Those that it finds again after the joins, as numbers."""
        numbers = self.extended.select_dtypes("number").columns
        return [name for name in self.attributes if name in numbers]

    def values(self, experiment, planner, attribute):
        """Behind one box of the plot."""
        chosen = (self.extended["experiment"] == experiment) & (self.extended["planner"] == planner)
        return self.extended.loc[chosen, attribute].dropna().tolist()

    def _check_columns(self, tables):
        for name, first in (("runs", IDS), ("experiments", COMMON), ("plannerConfigs", ["id", "name", "settings"])):
            if list(tables[name].columns[: len(first)]) != first:
                raise ValueError(f"{name}: begins with {list(tables[name].columns[: len(first)])}, not {first}")
        if list(tables["progress"].columns[:2]) != ["runid", "time"]:
            raise ValueError("progress: does not begin with runid and time")
        if "time" not in self.attributes:
            raise ValueError("runs: has no time, which is plotted first")

    def _check_rows(self, experiments):
        if len(self.extended) != len(self._runs):
            raise ValueError("runs: some are of no experiment or of no planner, and are not shown")
        split = experiments["experiment"].str.contains(r"\s")
        if split.any():
            raise ValueError(f"experiments: '{experiments.loc[split, 'experiment'].iloc[0]}' is not one word")
        last = experiments["version"].str.split(" ").str[-1]
        if not last.str.fullmatch(r"\d+(\.\d+)+").all():
            raise ValueError("experiments: the last word of version is no version")
        for name, values in self._enums.groupby("name")["value"]:
            if not set(self._runs[name].dropna()) <= set(values):
                raise ValueError(f"enums: values of {name} without a description")
