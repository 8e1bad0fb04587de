"""Draws the benchmark's plots from scaling.csv, and scaling.md beside it: cost against cells, pixels and threads, and
the stages of Tiles.

    scaling.py FOLDER    FOLDER/scaling.csv is there
"""

import csv
import itertools
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

# In the order of a frame.
STAGES = ("cull", "transform", "box", "bin", "order", "set_up", "cover", "shade", "composite", "repair", "write", "wait",
          "rest")
TIMES = {"cells": (lambda row: row["cells"], "tetrahedra"),
         "pixels": (lambda row: row["width"] * row["height"], "pixels"),
         "threads": (lambda row: row["threads"], "threads")}
TEXTS = ("sweep", "transfer", "method", "engine", "renderer", "processor", "smp_backend", "vtk")
TILES = "ours, Tiles"


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
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,g}"))
    axis.yaxis.set_minor_formatter(NullFormatter())
    axis.grid(alpha=0.3)
    axis.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.22), ncol=2)


def timed(rows, transfer):
    return [row for row in rows if row["timed_ms"] is not None and row["transfer"] == transfer]


def whole(row):
    """ns per tetrahedron of the frame whose stages were timed."""
    return sum(row[f"{stage}_ns"] for stage in STAGES)


def plot_stages(axis, sweep, rows):
    """Shares of Tiles' frames with the smooth function, one bar for each row."""
    across, label = TIMES[sweep]
    shown = timed(rows, "smooth")
    bottoms = [0.0] * len(shown)
    for stage, color in zip(STAGES, plt.cm.tab20.colors):
        heights = [100.0 * row[f"{stage}_ns"] / whole(row) for row in shown]
        axis.bar(range(len(shown)), heights, bottom=bottoms, color=color, label=stage.replace("_", " "))
        bottoms = [bottom + height for bottom, height in zip(bottoms, heights)]
    for place, row in enumerate(shown):
        axis.text(place, 101.0, f"{whole(row):,.0f} ns", ha="center", fontsize=8)
    axis.set_xticks(range(len(shown)))
    axis.set_xticklabels([f"{int(across(row)):,}" for row in shown], rotation=20, fontsize=8)
    axis.set(xlabel=label, ylabel="% of a frame by Tiles, smooth; above: per cell", ylim=(0.0, 108.0))
    handles, names = axis.get_legend_handles_labels()
    axis.legend(handles[::-1], names[::-1], fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))


def fixed(sweep, row):
    """What the rows of a sweep have in common."""
    cells, pixels = f"{int(row['cells']):,} tetrahedra", f"{int(row['width'])} x {int(row['height'])} pixels"
    threads = f"{int(row['threads'])} threads"
    return ", ".join({"cells": (pixels, threads), "pixels": (cells, threads), "threads": (cells, pixels)}[sweep])


def draw(sweep, rows, looks, path):
    figure, (times, stages) = plt.subplots(1, 2, figsize=(11, 6))
    plot_times(times, sweep, rows, looks)
    plot_stages(stages, sweep, rows)
    figure.suptitle(f"Against {sweep}: a jittered lattice, {fixed(sweep, rows[0])}", fontsize=10)
    figure.tight_layout()
    figure.savefig(path, dpi=80, bbox_inches="tight")
    plt.close(figure)


def table(header, lines):
    return ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)] + [
        "| " + " | ".join(line) + " |" for line in lines] + [""]


def milliseconds(row):
    return f"{row['median_ms']:.{0 if row['median_ms'] >= 100.0 else 1}f}" if row else ""


def time_table(sweep, rows):
    """A line per mesh or image and function: each method's ms, and how many times Tiles' that is."""
    across, label = TIMES[sweep]
    methods = [method for method in dict.fromkeys(row["method"] for row in rows) if method != TILES]
    lines, last = [], {}
    for mine in (row for row in rows if row["method"] == TILES):
        before = last.get(mine["transfer"])
        last[mine["transfer"]] = mine
        line = [f"{int(across(mine)):,}", mine["transfer"], milliseconds(mine),
                f"{mine['median_ms'] / before['median_ms']:.2f}" if before else "",
                f"{1e6 * mine['median_ms'] / mine['cells']:.0f}", f"{1e-6 * mine['fragments_per_s']:.0f}",
                f"{mine['maximum']:.1e} ({int(mine['error_size'])})"]
        for method in methods:
            other = next((row for row in rows if row["method"] == method and row["transfer"] == mine["transfer"]
                          and across(row) == across(mine)), None)
            line += [f"{milliseconds(other)} ({other['median_ms'] / mine['median_ms']:.1f}, {other['maximum']:.0e})"
                     if other else ""]
        lines.append(line)
    return table([label, "function", "Tiles ms", "of the row before", "ns a tetrahedron", "M fragments a s", "largest error"] + [
        f"{method} ms (of Tiles', largest error)" for method in methods], lines)


def stage_table(sweep, rows):
    across, label = TIMES[sweep]
    lines = []
    for transfer in dict.fromkeys(row["transfer"] for row in rows):
        for row in timed(rows, transfer):
            stages = [f"{row[f'{stage}_ns']:.{2 if row[f'{stage}_ns'] < 1.0 else 1}f}" for stage in STAGES]
            lines.append([f"{int(across(row)):,}", transfer, f"{whole(row):.0f}"] + stages + [
                f"{1e-6 * row['fragments']:.1f}", f"{row['cover_lane_use']:.2f}", f"{row['shade_lane_use']:.2f}",
                f"{row['mesh_bytes_per_cell']:.0f}", f"{row['frame_bytes_per_cell']:.0f}"])
    return table([label, "function", "all"] + [stage.replace("_", " ") for stage in STAGES] + [
        "M fragments", "lane use, cover", "shade", "B a tetrahedron that last", "of a frame"], lines)


def write_tables(rows, sweeps, path):
    first = rows[0]
    threads = int(max(row["threads"] for row in rows))
    lines = ["# Cost against cells, pixels and threads", "",
             f"{first['processor']}, {threads} threads (vtkSMPTools by {first['smp_backend']}), OpenGL by "
             f"{first['renderer']}, VTK {first['vtk']}. Drawn by `make bench` from [scaling.csv](scaling.csv), whose columns "
             "`Testing/Benchmark/ScalingRow.h` explains. One run; medians of 9 frames, a new eye each, of slow mappers of fewer"
             "; mappers whose frames would take seconds are left out. Errors: of premultiplied float RGBA (VTK's: "
             "8 bits, without alpha) against the float64 oracle, in an image of as many pixels across as stands in brackets. "
             "Stages: ns per tetrahedron of the mesh; from order on, within tiles, the mean of all threads; wait: threads "
             "without a tile; rest: driver, depth, blending. Lane use, cover: covered lanes of the vectors of pixels that were "
             "looked at; shade: lanes of the vectors of fragments that hold one.", ""]
    for sweep, shown in sweeps.items():
        lines += [f"## Against {sweep}", "", f"{fixed(sweep, shown[0]).capitalize()}.", "",
                  f"![Against {sweep}]({sweep}.png)", ""]
        lines += time_table(sweep, shown) + stage_table(sweep, shown)
    path.write_text("\n".join(lines[:-1]) + "\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = read(folder / "scaling.csv")
    looks = styles(rows)
    sweeps = {sweep: [row for row in rows if row["sweep"] == sweep] for sweep in TIMES}
    sweeps = {sweep: shown for sweep, shown in sweeps.items() if shown}
    for sweep, shown in sweeps.items():
        draw(sweep, shown, looks, folder / f"{sweep}.png")
        print(folder / f"{sweep}.png")
    write_tables(rows, sweeps, folder / "scaling.md")
    print(folder / "scaling.md")


if __name__ == "__main__":
    main()
