#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's database, uploaded to a Planner Arena that runs and used as a reader would, in a headless Chromium.

  check_planner_arena.py ADDRESS RESULTS.db OUT      OUT gets a screenshot of each tab

`tools/check-planner-arena` starts the one that Debian has and calls this.
"""

import sqlite3
import sys
import time
from contextlib import closing
from pathlib import Path

from webdriver import Browser

IDS = 3  # columns at the beginning of `runs` that Planner Arena leaves out
COMMON = 12  # columns of `experiments` before the parameters
NO_PROGRESS = "There is no progress data in this database."
ONE_VERSION = "Only one version of OMPL was used for the benchmarks."

OPTIONS = "return Object.keys(document.getElementById(arguments[0])?.selectize?.options ?? {})"
# Shiny clears outputs while it works on them, so idleness is waited for, then looked at.
IDLE = "return window.Shiny?.shinyapp?.isConnected() && !document.documentElement.classList.contains('shiny-busy')"
PLOT = """
const place = document.getElementById('perf_plot');
const picture = place.querySelector('img');
const wrong = place.classList.contains('shiny-output-error') ? place.innerText : '';
return {wrong, width: picture?.naturalWidth ?? 0, source: picture?.src ?? ''};
"""
TABLE = """
const rows = [...document.querySelectorAll(`#${arguments[0]} tr`)];
return rows.map(row => [...row.children].map(cell => cell.innerText.trim()));
"""
TEXT = "return document.getElementById(arguments[0]).innerText"


def expect(condition, what):
    if not condition:
        raise AssertionError(what)


class Expected:
    """What the database holds, by queries of our own."""

    def __init__(self, file):
        with closing(sqlite3.connect(f"file:{file}?mode=ro", uri=True)) as database:
            self._database = database
            self.problems = self._column("SELECT name FROM experiments")
            self.attributes = self._column("SELECT name FROM pragma_table_info('runs')")[IDS:]
            self.parameters = self._column("SELECT name FROM pragma_table_info('experiments')")[COMMON:]
            texts = "SELECT name FROM pragma_table_info('runs') WHERE type = 'TEXT'"
            clashes = "SELECT name FROM pragma_table_info('experiments')"
            unplottable = {*self._column(texts), *self._column(clashes)}
            self.plotted = [name for name in self.attributes if name not in unplottable]
            self.planners = self._column("SELECT name FROM plannerConfigs ORDER BY id")
            self.missing = self._missing(self.problems[0])

    def _column(self, query):
        return [row[0] for row in self._database.execute(query)]

    def _missing(self, problem):
        """By attribute, [planner, runs without a value, runs] of a problem."""
        result = {}
        for attribute in self.plotted:
            query = f"""
                SELECT plannerConfigs.name, sum({attribute} IS NULL), count(*) FROM runs
                JOIN plannerConfigs ON plannerConfigs.id = plannerid JOIN experiments ON experiments.id = experimentid
                WHERE experiments.name = ? GROUP BY plannerid"""
            rows = self._database.execute(query, (problem,))
            result[attribute] = sorted([name, str(missing), str(total)] for name, missing, total in rows)
        return result


def settle(browser):
    """Until the server has had nothing to do for a while."""
    quiet = 0
    while quiet < 5:
        quiet = quiet + 1 if browser.wait(IDLE) else 0
        time.sleep(0.1)


def open_tab(browser, name):
    browser.click(f"#navbar a[data-value='{name}']")
    settle(browser)


def choose(browser, field, value):
    browser.script("document.getElementById(arguments[0]).selectize.setValue(arguments[1])", field, value)
    settle(browser)


def check_choices(browser, expected):
    expect(sorted(browser.script(OPTIONS, "perf_problem")) == sorted(expected.problems), "problems")
    expect(sorted(browser.script(OPTIONS, "perf_attr")) == sorted(expected.attributes), "attributes")
    for name in expected.parameters:
        expect(browser.script(OPTIONS, f"perfproblem_param{name}"), f"no choice of the parameter {name}")
    choose(browser, "perf_problem", expected.problems[0])
    boxes = "return [...document.querySelectorAll('#perf_planners input')].map(box => box.value)"
    expect(sorted(browser.script(boxes)) == sorted(expected.planners), "planners")
    browser.script("document.querySelectorAll('#perf_planners input:not(:checked)').forEach(box => box.click())")
    settle(browser)


def check_plots(browser, expected, out):
    pictures = set()
    for attribute in expected.plotted:
        choose(browser, "perf_attr", attribute)
        plot = browser.script(PLOT)
        expect(not plot["wrong"] and plot["width"] > 100, f"{attribute}: {plot['wrong'] or 'no plot'}")
        pictures.add(plot["source"])
        table = browser.script(TABLE, "perf_missing_data_table")[1:]
        expect(sorted(table) == expected.missing[attribute], f"{attribute}: {table}, not {expected.missing[attribute]}")
    expect(len(pictures) > len(expected.plotted) / 2, "the plots do not differ")
    choose(browser, "perf_attr", "time")
    browser.screenshot(out / "performance.png")


def check_other_tabs(browser, expected, out):
    open_tab(browser, "progress")
    expect(NO_PROGRESS in browser.script(TEXT, "progress_page"), "progress")
    browser.screenshot(out / "progress.png")
    open_tab(browser, "regression")
    expect(ONE_VERSION in browser.script(TEXT, "regression_page"), "regression")
    open_tab(browser, "dbinfo")
    setup = dict(row[:2] for row in browser.script(TABLE, "benchmark_info"))
    expect(setup["experiment"] == expected.problems[0], f"benchmark setup: {setup}")
    browser.screenshot(out / "dbinfo.png")
    links = "[...document.querySelectorAll('#dbinfo_page a')]"
    browser.script(f"{links}.find(link => link.innerText.includes('Planner')).click()")
    settle(browser)
    settings = dict(browser.script(TABLE, "planner_configs"))
    expect(sorted(settings) == sorted(expected.planners), f"planner configurations: {settings}")


def main(address, database, out):
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    expected = Expected(database)
    with Browser() as browser:
        browser.size(1280, 1000)
        browser.open(address)
        settle(browser)
        open_tab(browser, "database")
        browser.type("#database", str(Path(database).resolve()))
        browser.wait("return document.querySelector('#perf_planners input') !== null")
        settle(browser)
        check_choices(browser, expected)
        check_plots(browser, expected, out)
        check_other_tabs(browser, expected, out)
    print(
        f"{len(expected.problems)} problems, {len(expected.planners)} planners, "
        f"{len(expected.plotted)} of {len(expected.attributes)} attributes plotted: as the database has them"
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
