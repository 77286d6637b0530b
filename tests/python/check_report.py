#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A small campaign's report, opened from the file system and used as a reader would, in a headless Chromium.

  check_report.py PROGRAM SCENARIOS OUT      OUT gets database, page and screenshots

Ends with 77, "skipped", where there is no chromedriver.
"""

import shutil
import sqlite3
import subprocess
import sys
import time
from contextlib import closing
from pathlib import Path
from xml.etree import ElementTree

from planner_arena import Arena
from webdriver import Browser

SKIPPED = 77
EXPERIMENT = """
[problem]
name = small
scenario = {folder}/gap_small.yaml, {folder}/hppm_case1.yaml, {folder}/spatial_elbow.yaml
[benchmark]
time_limit = 2
run_count = 3
seed = 1
save_paths = all
canary = 10
[planner]
hppm =
rrtconnect =
bkpiece1 =
[hypothesis]
all = RRT-Connect solves everything
all.planner = rrtconnect
all.quantity = success
all.direction = more
all.bound = 0.01
"""
RUNS = 3 * 3 * 3
ENTRIES = ["bkpiece1", "hppm", "hppm *", "rrtconnect"]  # one scenario prescribes a recipe

# Pixels of the arm's canvas that are not empty, and a number that changes when they do.
PICTURE = """
const source = document.querySelector('.stage-place canvas');
const copy = document.createElement('canvas');
[copy.width, copy.height] = [source.width, source.height];
const context = copy.getContext('2d');
context.drawImage(source, 0, 0);
const data = context.getImageData(0, 0, copy.width, copy.height).data;
let [filled, sum] = [0, 0];
for (let i = 0; i < data.length; i += 4)
  if (data[i + 3]) { ++filled; sum = (31 * sum + 7 * data[i] + 5 * data[i + 1] + 3 * data[i + 2]) % 1000003; }
return [filled, sum];
"""


EXTRAS = ["--paper", "--ompl-log"]


def expect(condition, what):
    if not condition:
        raise AssertionError(what)


def write_report(program, scenarios, out):
    experiment, database = out / "small.cfg", out / "small.db"
    experiment.write_text(EXPERIMENT.format(folder=Path(scenarios).resolve()))
    subprocess.run([program, "bench", experiment, "--db", database], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, "report", database, "-o", out / "report", *EXTRAS], check=True, stdout=subprocess.DEVNULL)
    return out / "report" / "index.html"


def choose(browser, label, name):
    """Picks from a list by what the entry begins with."""
    code = """
    const list = document.querySelector(`select[aria-label="${arguments[0]}"]`);
    const index = [...list.options].findIndex(({ text }) => text.startsWith(arguments[1]));
    list.selectedIndex = index;
    list.dispatchEvent(new Event('change'));
    return index;
    """
    expect(browser.script(code, label, name) >= 0, f"{label} {name} is not on the list")


def check_verdict(browser):
    expect(browser.script("return document.querySelector('#verdict h1').textContent.length > 10"), "no verdict")
    expect(
        f"{RUNS} runs of {len(ENTRIES)} planner entries on 3 instances"
        in browser.script("return document.querySelector('#verdict').innerText"),
        "sizes",
    )
    expect(browser.script("return document.querySelectorAll('#figures svg').length") == 6, "six figures")
    expect(browser.script("return document.querySelectorAll('#figures svg .curve').length") >= 6, "curves")


def settled(browser):
    """The picture once it is drawn and stays as it is."""
    before = [0, 0]
    for _ in range(100):
        now = browser.script(PICTURE)
        if now[0] > 0 and now == before:
            return now
        before = now
        time.sleep(0.05)
    raise AssertionError("the picture never rests")


def check_playing(browser):
    """Play, pause, scrub, keys; the picture follows."""
    place = "return Number(document.querySelector('#scrub').value)"
    browser.click("#play")
    browser.wait("return Number(document.querySelector('#scrub').value) > 20")
    browser.click("#play")
    stopped = browser.script(place)
    expect(browser.script("return document.querySelector('#play').textContent").endswith("Play"), "paused")
    before = browser.script(PICTURE)
    expect(before[0] > 1000, f"an empty picture: {before}")
    browser.script(
        "const s = document.querySelector('#scrub'); s.value = 700; s.dispatchEvent(new Event('input')); s.blur()"
    )
    expect(browser.script("return document.querySelector('#place').textContent") == "70 %", "scrubbed")
    expect(stopped == 700 or browser.script(PICTURE) != before, "the picture does not follow the scrubber")
    browser.script("document.activeElement.blur()")
    browser.press("home")
    expect(browser.script(place) == 0, "Home")
    browser.press("right")
    expect(browser.script(place) == 10, "arrow")
    browser.press("end")
    expect(browser.script(place) == 1000, "End")
    with_sweep = browser.script(PICTURE)
    browser.press("s")
    expect(browser.script(PICTURE) != with_sweep, "the sweep stays")
    browser.press("s")
    expect(browser.script("return document.querySelectorAll('.clearance polyline').length") == 1, "clearance curve")


def check_slice(browser):
    """Pointing into the slice poses a second arm."""
    choose(browser, "Scenario", "hppm-case-1")
    choose(browser, "Planner", "hppm")
    browser.wait("return document.querySelector('.stage.slice') !== null")
    alone = settled(browser)
    browser.point(".stage.slice", 20, -30)
    browser.wait(f"const now = (() => {{ {PICTURE} }})(); return now[1] !== arguments[0]", alone[1])
    browser.point("#verdict", 0, 0)


def check_space(browser, out):
    choose(browser, "Scenario", "spatial-elbow")
    browser.wait("return document.querySelector('.stage-place canvas') !== null")
    expect(browser.script("return document.querySelector('.stage-place canvas').getContext('2d') === null"), "no WebGL")
    check_playing(browser)
    before = browser.script(PICTURE)
    browser.click(".lenses button")
    expect(browser.script(PICTURE) != before, "zoom")
    browser.screenshot(out / "space.png")


def check_table(browser):
    cells = "return [...document.querySelectorAll('#table-runs tbody tr')].map((row) => row.cells[%d].textContent)"
    expect(len(browser.script(cells % 1)) == RUNS, "runs listed")
    browser.click("#table-runs th:nth-child(3) button")
    names = browser.script(cells % 2)
    expect(names == sorted(names) and sorted(set(names)) == ENTRIES, f"sorted by planner: {names}")
    browser.click("#table-runs th:nth-child(3) button")
    expect(browser.script(cells % 2) == sorted(names, reverse=True), "sorted the other way")
    browser.type("#table-runs input", "hppm gap")
    rows = browser.script(cells % 1)
    expect(len(rows) == 3 and all("gap-small" in name for name in rows), f"filtered: {rows}")
    expect(
        browser.script("return document.querySelector('#table-runs .count').textContent") == f"3 of {RUNS} rows",
        "count",
    )
    browser.click("#table-runs .watch")
    browser.wait("return document.querySelector('#play').textContent.endsWith('Pause')")
    shown = browser.script("return document.querySelector('select[aria-label=Scenario]').selectedOptions[0].text")
    expect(shown == "gap-small", f"watching {shown}")


def saved(browser, selector):
    """What a button hands out as a file."""
    browser.script(
        "const make = URL.createObjectURL; URL.createObjectURL = (blob) => ((window.saved = blob), make(blob))"
    )
    browser.click(selector)
    browser.script("window.saved.text().then((text) => (window.savedText = text))")
    return browser.wait("return window.savedText")


def check_hypotheses(browser):
    """Declared in the experiment file, decided on the page: three of three instances at a bound of a hundredth."""
    code = """return [...document.querySelectorAll('#tables table')].map((table) =>
        [...table.querySelectorAll('tbody tr:first-child td')].map((cell) => cell.textContent))"""
    first, quality = browser.script(code)[:2]
    expect(first[:3] == ["all", "RRT-Connect solves everything", "confirmed"], first)
    expect(first[4] == "3" and "3 of 3 solved" in first[5], first)
    expect(quality[0] in ENTRIES and len(quality) == 11, quality)
    expect("declared before the first run 1 came out confirmed" in browser.script("return document.body.innerText"), "verdict")


def check_downloads(browser):
    picture = ElementTree.fromstring(saved(browser, "#figure-time .bar button:nth-of-type(1)"))
    expect(picture.tag == "{http://www.w3.org/2000/svg}svg", f"not a picture: {picture.tag}")
    expect(len(picture.findall(".//{*}path")) == len(ENTRIES), "a curve for every entry")
    browser.script("window.savedText = null")
    lines = saved(browser, "#figure-ends .bar button:nth-of-type(2)").splitlines()
    expect(lines[0] == "planner,end,runs", lines[0])
    expect(sum(int(line.split(",")[2]) for line in lines[1:]) == RUNS, f"runs in {lines}")


def check_themes(browser, out):
    colour = "return getComputedStyle(document.body).backgroundColor"
    light = browser.script(colour)
    browser.click("#theme")
    expect(browser.script(colour) != light, "dark is as light")
    browser.script("scrollTo(0, 0)")
    browser.screenshot(out / "dark.png")
    browser.size(390, 844)
    browser.wait("return innerWidth === 390")
    expect(browser.script("return document.documentElement.scrollWidth") <= 390, "wider than a phone")
    browser.script("document.querySelector('#motions').scrollIntoView()")
    browser.screenshot(out / "phone.png")
    browser.size(1280, 900)
    browser.click("#theme")
    expect(browser.script(colour) == light, "light again")


def check_page(page, out):
    text = page.read_text(encoding="utf-8")
    expect(
        not any(word in text for word in ('src="http', "src='http", "@import", 'href="http')),
        "the page loads something",
    )
    with Browser() as browser:
        browser.size(1280, 900)
        browser.open(page.as_uri())
        browser.wait("return document.querySelectorAll('#figures svg').length === 6")
        check_verdict(browser)
        choose(browser, "Scenario", "gap-small")
        check_playing(browser)
        check_slice(browser)
        browser.screenshot(out / "plane.png")
        check_space(browser, out)
        check_table(browser)
        check_hypotheses(browser)
        check_downloads(browser)
        check_themes(browser, out)
        complaints = browser.complaints()
        expect(not complaints, f"the console says: {complaints}")


def rows_of(database, columns):
    """Runs by what tells them apart."""
    query = f"""SELECT experiments.name, plannerConfigs.name, run, {columns} FROM runs
                JOIN experiments ON experiments.id = experimentid JOIN plannerConfigs ON plannerConfigs.id = plannerid"""
    with closing(sqlite3.connect(database)) as connection:
        return {row[:3]: row[3:] for row in connection.execute(query)}


def check_logs(out):
    """OMPL's own tool reads the logs and gets the numbers that went into them."""
    logs = sorted((out / "report" / "ompl").glob("*.log"))
    expect(len(logs) == 3, f"logs: {logs}")
    read = out / "ompl.db"
    command = ["ompl_benchmark_statistics", "-d", read, *logs]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    columns = "time, status, solved, cpu_time, solution_length, solution_clearance, runs.seed, outcome, graph_states, uses_model"
    stored = rows_of(out / "small.db", columns)
    expect(len(stored) == RUNS and rows_of(read, columns) == stored, "OMPL's tool read other numbers")


def check_arena(out):
    """Planner Arena finds its columns in a new database, and all runs."""
    arena = Arena(out / "small.db")
    expect(len(arena.extended) == RUNS and arena.parameters == ["scenario", "checker", "motion"], "Planner Arena's frames")


def check_paper(out):
    paper = out / "report" / "paper"
    for name in ("ends.pdf", "success.pdf", "time.pdf", "effort.pdf", "profile.pdf"):
        expect((paper / name).read_bytes().startswith(b"%PDF"), name)
    rows = (paper / "all_groups.tex").read_text().splitlines()
    expect(sum(line.endswith(r"\\") for line in rows) == 1 + len(ENTRIES), f"a line for every entry: {rows}")
    expect("confirmed" in (paper / "hypotheses.tex").read_text(), "the hypothesis in LaTeX")


def main(program, scenarios, out):
    if shutil.which("chromedriver") is None:
        print("skipped: there is no chromedriver (Debian: chromium-driver)")
        return SKIPPED
    out = Path(out)
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    page = write_report(program, scenarios, out)
    check_logs(out)
    check_arena(out)
    check_paper(out)
    check_page(page, out)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
