# SPDX-License-Identifier: BSD-3-Clause
"""Figures as PDF and tables as LaTeX (booktabs), from the data that the page shows."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

MANY = 40  # lines of a legend or axis that still fit on one page
SPECIAL = {"_": r"\_", "%": r"\%", "&": r"\&", "#": r"\#", "$": r"\$", "{": r"\{", "}": r"\}", "*": "$^*$"}


def escaped(text):
    return "".join(SPECIAL.get(letter, letter) for letter in text)


def brief(value, factor=1.0):
    return "--" if value is None else f"{float(f'{factor * value:.3g}'):.12g}"


def table(header, rows):
    """The first column is text, the others are numbers."""
    lines = [
        r"\begin{tabular}{l" + "r" * (len(header) - 1) + "}",
        r"\toprule",
        " & ".join(header) + r" \\",
        r"\midrule",
    ]
    lines += [" & ".join(row) + r" \\" for row in rows]
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}", ""])


def summary(rows):
    header = ["planner", "solved", r"95\,\% interval", "CPU (ms)", "evaluations", "length (rad)", "clearance"]
    return table(
        header,
        [
            [
                escaped(row["planner"]),
                f"{row['solved']}/{row['runs']}",
                f"[{100 * row['low']:.1f}, {100 * row['high']:.1f}]",
                brief(row["cpu"], 1e3),
                brief(row["evaluations"]),
                brief(row["length"]),
                brief(row["clearance"]),
            ]
            for row in rows
        ],
    )


def contests(rows):
    header = ["group", "model", "solved", "CPU (ms)", "sampling", "solved", "CPU (ms)", "$p$ (Holm)", "ahead"]
    lines = []
    for row in rows:
        sides = []
        for side in ("ours", "theirs"):
            sides += [escaped(row[side]), rf"{100 * row[side + '_solved']:.1f}\,\%", brief(row[side + "_cpu"], 1e3)]
        winner = {"ours": "model", "theirs": "sampling"}.get(row["winner"], "undecided")
        lines.append([escaped(row["group"]), *sides, brief(row["adjusted"]), winner])
    return table(header, lines)


def draw_steps(figure, panel):
    page, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for series in panel["series"]:
        if series["x"]:
            x, y = [*series["x"], max(panel["end"], series["x"][-1])], [*series["y"], series["y"][-1]]
            style = {"linewidth": 2.0} if series["ours"] else {"linewidth": 1.0, "linestyle": "--"}
            axes.step([x[0], *x], [0.0, *y], where="post", label=series["name"], **style)
    axes.set(xscale="log", ylim=(0, 1.02), xlabel=figure["x"], ylabel=figure["y"])
    if 0 < len(panel["series"]) <= MANY:
        axes.legend(fontsize=6, ncols=1 + len(panel["series"]) // 14)
    return page


def draw_intervals(figure, panel):
    rows = sorted(panel["rows"], key=lambda row: row["share"])
    page, axes = plt.subplots(figsize=(6.4, 1.0 + 0.22 * len(rows)), layout="constrained")
    for place, row in enumerate(rows):
        axes.plot([row["low"], row["high"]], [place, place], color="tab:red" if row["ours"] else "tab:blue")
        axes.plot(row["share"], place, "o", color="tab:red" if row["ours"] else "tab:blue", markersize=4)
    axes.set_yticks(range(len(rows)), [row["planner"] for row in rows], fontsize=7)
    axes.set(xlim=(-0.02, 1.02), xlabel=figure["x"])
    return page


def draw_trend(figure, panel):
    page, axes = plt.subplots(figsize=(4.8, 3.4), layout="constrained")
    for series in panel["series"]:
        style = {"linewidth": 2.0} if series["ours"] else {"linewidth": 1.0, "linestyle": "--"}
        axes.plot(series["x"], series["y"], marker="o", markersize=3, label=series["name"], **style)
    axes.set(xscale="log", yscale="log", xlabel=figure["x"], ylabel=figure["y"])
    axes.set_title(panel["name"], fontsize=8)
    if 0 < len(panel["series"]) <= MANY:
        axes.legend(fontsize=5, ncols=1 + len(panel["series"]) // 14)
    return page


def draw_stacked(figure, panel):
    """Shares of the ends that runs had, solved first."""
    rows = panel["rows"]
    page, axes = plt.subplots(figsize=(6.4, 1.4 + 0.22 * len(rows)), layout="constrained")
    ends = dict.fromkeys(end for row in rows for end in row["counts"])
    before = np.zeros(len(rows))
    totals = np.array([sum(row["counts"].values()) for row in rows], float)
    for end in sorted(ends, key=lambda end: end != "solved"):
        shares = np.array([row["counts"].get(end, 0) for row in rows]) / totals
        axes.barh(range(len(rows)), shares, left=before, label=end)
        before += shares
    axes.set_yticks(range(len(rows)), [row["planner"] for row in rows], fontsize=7)
    axes.set(xlim=(0.0, 1.0), xlabel=figure["x"])
    axes.invert_yaxis()
    axes.legend(fontsize=6, ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.25))
    return page


def draw_phase(figure, panel):
    """Shares as squares, with the line and its band."""
    widths, rows = np.array(panel["columns"]), np.arange(len(panel["rows"]))
    page, axes = plt.subplots(figsize=(4.2, 0.9 + 0.42 * len(rows)), layout="constrained")
    middle = np.sqrt(widths[1:] * widths[:-1])
    edges = [widths[0] ** 2 / middle[0], *middle, widths[-1] ** 2 / middle[-1]]
    shares = np.array([[np.nan if share is None else share for share in row] for row in panel["shares"]])
    axes.pcolormesh(edges, np.arange(len(rows) + 1) - 0.5, shares, cmap="RdYlGn", vmin=0, vmax=1, alpha=0.7)
    if panel["line"]:
        middle, low, high = np.clip(np.array(panel["line"]).T, edges[0], edges[-1])
        axes.fill_betweenx(rows, low, high, color="black", alpha=0.2, linewidth=0)
        axes.plot(middle, rows, color="black")
    for row, column in np.argwhere(np.isfinite(shares)):
        axes.text(widths[column], row, f"{100 * shares[row, column]:.0f}", ha="center", va="center", fontsize=7)
    axes.set(xscale="log", xlabel=figure["x"], ylabel=figure["y"])
    axes.set_yticks(rows, [links or "any" for links in panel["rows"]])
    axes.set_title(panel["name"], fontsize=8)
    axes.invert_yaxis()
    return page


def cell_text(cell):
    return escaped(cell) if isinstance(cell, str) else brief(cell)


DRAW = {
    "phase": draw_phase,
    "steps": draw_steps,
    "intervals": draw_intervals,
    "stacked": draw_stacked,
    "trend": draw_trend,
}
BY_PANEL = ("phase", "trend")  # these have no panel of all groups: each becomes a file


def write_paper(data, folder):
    """\\param data what the page is told  \\return the files that were written"""
    folder.mkdir(parents=True, exist_ok=True)
    texts = {"all_groups.tex": summary(data["totals"]), "contests.tex": contests(data["contests"])}
    for group in dict.fromkeys(row["group"] for row in data["groups"]):
        texts[f"group_{group}.tex"] = summary([row for row in data["groups"] if row["group"] == group])
    for one in data["tables"]:
        heads = [escaped(column["title"]) for column in one["columns"]]
        texts[f"{one['id']}.tex"] = table(heads, [[cell_text(cell) for cell in row] for row in one["rows"]])
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    written = [folder / name for name in texts]
    for figure in data["figures"]:
        for number, panel in enumerate(figure["panels"] if figure["kind"] in BY_PANEL else figure["panels"][:1]):
            if figure["kind"] not in DRAW:
                continue
            page = DRAW[figure["kind"]](figure, panel)
            written.append(folder / f"{figure['id']}{f'_{number + 1}' if number else ''}.pdf")
            page.savefig(written[-1], metadata={"CreationDate": None})
            plt.close(page)
    return written
