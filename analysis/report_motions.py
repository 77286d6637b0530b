# SPDX-License-Identifier: BSD-3-Clause
"""Which stored paths a report shows, and how they are made small enough for a page."""

import hashlib
import json
from contextlib import closing

import numpy as np

from report_rows import open_database, scenario_texts
from report_scenes import page_scene

FLAT = 1e-3  # radians: thinned paths stay this near to the stored ones, or a tenth of the clearance if that is less
POINTS = 600  # of one path at most
DECIMALS = 6
MOTIONS = 3  # per instance and planner


def thin(path, tolerance):
    """Numbers of the waypoints that a polyline needs to stay within `tolerance` of all (Ramer, Douglas, Peucker)."""
    kept, open_spans = {0, len(path) - 1}, [(0, len(path) - 1)]
    while open_spans:
        first, last = open_spans.pop()
        if last - first < 2:
            continue
        along = path[last] - path[first]
        offset = path[first + 1 : last] - path[first]
        square = along @ along
        share = np.clip(offset @ along / square, 0.0, 1.0) if square > 0.0 else np.zeros(len(offset))
        distance = np.linalg.norm(offset - share[:, None] * along, axis=1)
        worst = int(np.argmax(distance))
        if distance[worst] > tolerance:
            middle = first + 1 + worst
            kept.add(middle)
            open_spans += [(first, middle), (middle, last)]
    return sorted(kept)


def page_path(rows, clearance):
    """Waypoints for the page: thinned and rounded, but first and last as they are stored. \\return rows, and how many
    were stored"""
    path = np.array([[np.nan if value is None else value for value in row] for row in rows], dtype=float)
    path = path[np.isfinite(path).all(axis=1)]
    if len(path) < 2:
        return path.tolist(), len(rows)
    tolerance = min(FLAT, 0.1 * clearance) if clearance and np.isfinite(clearance) and clearance > 0.0 else FLAT
    kept = thin(path, tolerance)
    while len(kept) > POINTS:
        tolerance *= 2.0
        kept = thin(path, tolerance)
    return [path[0].tolist(), *np.round(path[kept[1:-1]], DECIMALS).tolist(), path[-1].tolist()], len(rows)


def chosen(runs):
    """Of one planner's runs on one instance that have a path: the shortest and the median one that count, and one that
    does not. \\return (why, run) pairs"""
    good = runs[runs["solved"]].sort_values(["length", "run"])
    bad = runs[~runs["solved"]]
    result = []
    if len(good):
        result.append(("shortest", good.iloc[0]))
    if len(good) > 1:
        by_time = good.sort_values(["cpu", "run"])
        typical = by_time.iloc[(len(by_time) - 1) // 2]
        if typical["id"] != good.iloc[0]["id"]:
            result.append(("median time", typical))
    if len(bad):
        result.append(("not accepted", bad.iloc[0]))
    return result[:MOTIONS]


def in_turn(experiments):
    """Experiments so that every group's first comes before any group's second: (id, group) pairs in, ids out."""
    rank, order = {}, []
    for experiment, group in experiments:
        rank[group] = rank.get(group, -1) + 1
        order.append((rank[group], len(order), experiment))
    return [experiment for _, _, experiment in sorted(order)]


class Collection:
    """Scenes and motions, as many as a budget holds. Whole instances go in, or stay out."""

    def __init__(self, budget):
        self.budget = budget
        self.scenes = []
        self.motions = []
        self._by_digest = {}

    def add(self, text, motions):
        """\\return whether there was room"""
        digest = hashlib.sha256(text.encode()).hexdigest()
        number = self._by_digest.get(digest)
        scene = page_scene(text) if number is None else None
        cost = len(json.dumps([scene, motions]))
        if cost > self.budget:
            return False
        self.budget -= cost
        if number is None:
            number = self._by_digest[digest] = len(self.scenes)
            self.scenes.append(scene)
        self.motions += [{**motion, "scene": number} for motion in motions]
        return True


def motions_of(database, runs):
    """The motions of one instance. \\param runs its runs that have a path"""
    motions = []
    for _, part in runs.groupby("planner", sort=False):
        for why, run in chosen(part):
            row = database.execute("SELECT angles FROM paths WHERE runid = ?", (int(run["id"]),)).fetchone()
            path, stored = page_path(json.loads(row["angles"]), run["clearance"])
            if len(path) > 1:
                motions.append({"run": int(run["id"]), "why": why, "path": path, "stored": stored})
    return motions


def collect(path, runs, megabytes):
    """\\return the collection, and a dictionary of what was left out of it"""
    with closing(open_database(path)) as database:
        kept = {row["runid"] for row in database.execute("SELECT runid FROM paths")}
        runs = runs[runs["id"].isin(kept)]
        pairs = list(runs[["experiment", "group"]].drop_duplicates().itertuples(index=False, name=None))
        collection, shown = Collection(int(1e6 * megabytes)), 0
        for experiment in in_turn(pairs):
            text = scenario_texts(path, [experiment])[experiment][0]
            if not collection.add(text, motions_of(database, runs[runs["experiment"] == experiment])):
                break
            shown += 1
    left_out = {"paths": len(kept) - len(collection.motions), "instances": len(pairs) - shown, "shown": shown}
    return collection, left_out
