"""Draws the benchmark's plots from scaling.csv: cost against cells, pixels and threads, and the stages of Tiles.

    scaling.py FOLDER    FOLDER/scaling.csv is there
"""

import csv
import itertools
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# In the order of a frame.
STAGES = ("cull", "transform", "box", "bin", "order", "set_up", "cover", "shade", "composite", "repair", "write", "wait",
          "rest")
TIMES = {"cells": (lambda row: row["cells"], "tetrahedra"),
         "pixels": (lambda row: row["width"] * row["height"], "pixels"),
         "threads": (lambda row: row["threads"], "threads")}
TEXTS = ("sweep", "transfer", "method", "engine")


def read(path):
    with open(path, newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        row.update({name: float(value) if value else None for name, value in row.items() if name not in TEXTS})
    return rows


def curves(rows):
    """Rows by method and function, in the order of the table."""
    found = {}
    for row in rows:
        found.setdefault((row["method"], row["transfer"]), []).append(row)
    return found


def styles(rows):
    methods = dict.fromkeys(row["method"] for row in rows)
    return dict(zip(methods, zip(plt.cm.tab10.colors, itertools.cycle(("o", "s", "^", "v", "D")))))


def plot_times(axis, sweep, rows, looks):
    across, label = TIMES[sweep]
    for (method, transfer), points in curves(rows).items():
        color, marker = looks[method]
        axis.plot([across(row) for row in points], [row["median_ms"] for row in points], color=color, marker=marker,
                  linewidth=1, linestyle="-" if transfer == "smooth" else "--", label=f"{method}, {transfer}")
    axis.set(xscale="log", yscale="log", xlabel=label, ylabel="ms per frame")
    axis.set_xticks(sorted({across(row) for row in rows}))
    axis.set_xticklabels([f"{int(tick):,}" for tick in axis.get_xticks()], rotation=20, fontsize=8)
    axis.minorticks_off()
    axis.grid(alpha=0.3)


def plot_stages(axis, sweep, rows):
    """Of Tiles with the smooth function, one bar for each row."""
    across, label = TIMES[sweep]
    shown = [row for row in rows if row["timed_ms"] is not None and row["transfer"] == "smooth"]
    bottoms = [0.0] * len(shown)
    for stage, color in zip(STAGES, plt.cm.tab20.colors):
        heights = [row[f"{stage}_ns"] for row in shown]
        axis.bar(range(len(shown)), heights, bottom=bottoms, color=color, label=stage.replace("_", " "))
        bottoms = [bottom + height for bottom, height in zip(bottoms, heights)]
    axis.set_xticks(range(len(shown)))
    axis.set_xticklabels([f"{int(across(row)):,}" for row in shown], rotation=20, fontsize=8)
    axis.set(xlabel=label, ylabel="ns per tetrahedron, Tiles, smooth")


def draw(sweep, rows, looks, path):
    figure, (times, stages) = plt.subplots(1, 2, figsize=(11, 5.2))
    plot_times(times, sweep, rows, looks)
    plot_stages(stages, sweep, rows)
    fixed = {"cells": f"{int(rows[0]['width'])} x {int(rows[0]['height'])} pixels, {int(rows[0]['threads'])} threads",
             "pixels": f"{int(rows[0]['cells']):,} tetrahedra, {int(rows[0]['threads'])} threads",
             "threads": f"{int(rows[0]['cells']):,} tetrahedra, {int(rows[0]['width'])} x {int(rows[0]['height'])} pixels"}
    figure.suptitle(f"Against {sweep}: a jittered lattice, {fixed[sweep]}", fontsize=10)
    times.legend(fontsize=7)
    stages.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.tight_layout()
    figure.savefig(path, dpi=80)
    plt.close(figure)


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = read(folder / "scaling.csv")
    looks = styles(rows)
    for sweep in TIMES:
        shown = [row for row in rows if row["sweep"] == sweep]
        if shown:
            path = folder / f"{sweep}.png"
            draw(sweep, shown, looks, path)
            print(path)


if __name__ == "__main__":
    main()
