"""Draws the report of speed against error from the table of CellProjectionReport: plots and report.md beside it.

    report.py FOLDER    FOLDER/report.csv is there
"""

import csv
import itertools
import os
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

REFERENCE = "VTK projected tetrahedra"
APPROXIMATIONS = ("ShirleyTuchman", "ShirleyTuchmanExponential", "Voxel", "UniformThickness1", "UniformThickness2",
                  "Centroid")
# What Cignoni et al. compare with their standard projected tetrahedra.
CHEAP = APPROXIMATIONS[2:]
LEVELS = "Simplified, "
# Largest error that the exact integration and the finest table may have, and of which rows.
BARS = (("Exact, Raster", "", "unlit", 1e-4), ("Exact, Tiles", "", "unlit", 1e-4), ("Exact, Raster", "", "lit", 1e-3),
        ("Exact, Tiles", "", "lit", 1e-3), ("Table", "256", "unlit", 2e-2))
LIT_TABLE = "Table, 4 samples"
# Table 4 of Cignoni et al.: speed-up and mean image error of levels, of BluntFin over the level of 2 %.
PAPER_LEVELS = {("Bucky ball", "2 %"): (3.03, 1.91), ("Bucky ball", "5 %"): (5.48, 4.62),
                ("Bucky ball", "10 %"): (10.73, 10.02), ("Blunt Fin", "4 %"): (2.33, 3.35),
                ("Blunt Fin", "6 %"): (4.33, 5.39)}
# Below this an error is rounding: the plots end here.
LEAST = 1e-8
NUMBERS = ("cells", "frames", "median_ms", "first_ms", "prepare_ms", "mcells_per_s", "ratio_to_vtk", "rmse", "p999",
           "maximum", "share_above_half_level", "rmse_outside", "maximum_inside", "misordered_faces", "levels_to_shirley_tuchman")


def read(path):
    with open(path, newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        row.update({name: float(row[name]) if row[name] else None for name in NUMBERS})
        row["name"] = f"{row['method']} {row['setting']}".strip()
    return rows


def grouped(rows, *columns):
    """Rows by the columns' values, in the order of the table."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[column] for column in columns), []).append(row)
    return groups


def plot_scene(scene, rows, path):
    """One curve per method: time across, largest error above and RMSE below, one column per look."""
    looks = grouped(rows, "transfer", "light")
    figure, axes = plt.subplots(2, len(looks), figsize=(5.2 * len(looks), 11), squeeze=False)
    styles = dict(zip(dict.fromkeys(row["method"] for row in rows),
                      itertools.product(("o", "s", "^", "v", "D"), plt.cm.tab10.colors)))
    for column, (look, shown) in enumerate(looks.items()):
        for axis, quantity, label in zip(axes[:, column], ("maximum", "rmse"), ("largest error", "RMSE")):
            for (method,), points in grouped(shown, "method").items():
                points = sorted(points, key=lambda row: row["median_ms"])
                marker, color = styles[method]
                axis.plot([row["median_ms"] for row in points], [max(row[quantity], LEAST) for row in points],
                          marker=marker, color=color, linewidth=1, label=method)
            axis.set(xscale="log", yscale="log", xlabel="ms per frame", ylabel=label,
                     title=f"{scene}, {look[0]}, {look[1]}")
            axis.grid(alpha=0.3)
    curves = {}
    for axis in axes.flat:
        curves.update({label: handle for handle, label in zip(*axis.get_legend_handles_labels())})
    figure.legend(curves.values(), curves.keys(), loc="lower center", ncol=2 * len(looks), fontsize=8)
    figure.tight_layout(rect=(0.0, 0.15, 1.0, 1.0))
    figure.savefig(path, dpi=80)
    plt.close(figure)


def shown(value, form):
    return "" if value is None else format(value, form)


def table(rows):
    lines = ["| method | engine | sort | blend | median ms | first | prepare | Mcells/s | ratio | RMSE | 99.9 % | maximum "
             "| inside | % > 1/510 | misordered |", "|" + "---|" * 15]
    for row in rows:
        frames = "" if row["frames"] >= 9 else f" ({row['frames']:.0f})"
        cells = (row["name"], row["engine"], row["sort"], row["blend"], f"{row['median_ms']:.1f}{frames}",
                 f"{row['first_ms']:.0f}", f"{row['prepare_ms']:.1f}", f"{row['mcells_per_s']:.2f}",
                 f"{row['ratio_to_vtk']:.2f}", f"{row['rmse']:.1e}", f"{row['p999']:.1e}", f"{row['maximum']:.1e}",
                 shown(row["maximum_inside"], ".1e"), f"{100.0 * row['share_above_half_level']:.1f}", shown(row["misordered_faces"], ".0f"))
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def bar_table(rows):
    """Whether the errors of each scene are within BARS, in the order of the cells that was proven."""
    lines = ["| scene | function | " + " | ".join(
        f"{method} {setting}".strip() + f", {light}: at most {bar:.0e}" for method, setting, light, bar in BARS)
        + f" | {LIT_TABLE}, lit over unlit: at most 1.25 | misordered | holds |", "|" + "---|" * (len(BARS) + 5)]
    for (scene, transfer), look in grouped(rows, "scene", "transfer").items():
        found = [next((row for row in look if (row["method"], row["setting"], row["light"]) == bar[:3]
                       and row["sort"] == "chosen"), None) for bar in BARS]
        drawn = [(row, bar[3]) for row, bar in zip(found, BARS) if row]
        misordered = sum(row["misordered_faces"] or 0 for row, _ in drawn)
        tables = {row["light"]: row["maximum"] for row in look if row["method"] == LIT_TABLE}
        ratio = tables["lit"] / tables["unlit"] if len(tables) == 2 else None
        holds = bool(drawn) and misordered == 0 and all(row["maximum"] <= bar for row, bar in drawn) \
            and (ratio or 0.0) <= 1.25
        errors = [f"{row['maximum']:.1e}" if row else "not drawn" for row in found]
        errors += [f"{ratio:.2f}" if ratio else "not drawn"]
        lines.append(f"| {scene} | {transfer} | {' | '.join(errors)} | {misordered:.0f} | {'yes' if holds else '**no**'} |")
    return lines


def is_beaten(row, others):
    """Whether one of the others is both faster and nearer to the oracle."""
    return any(other["median_ms"] < row["median_ms"] and other["rmse_outside"] < row["rmse_outside"] for other in others)


def has_place(row, rows):
    """No other row of the look is both faster and nearer to the oracle, and VTK's own approximation is no nearer."""
    worst = max((other["rmse_outside"] for other in rows if other["method"] == REFERENCE), default=row["rmse_outside"])
    return row["rmse_outside"] <= worst and not is_beaten(row, rows)


def by_opengl(rows):
    return [row for row in rows if row["engine"] in ("Raster", "OpenGL") and not row["method"].startswith(LEVELS)]


def standard_of(rows):
    return next((row for row in rows if row["method"] == APPROXIMATIONS[0]), None)


def is_approximate(row):
    return row["method"] in APPROXIMATIONS or row["method"].startswith(LEVELS)


def approximation_table(looks):
    lines = ["| scene | function | approximation | cells | median ms | speed-up | mean difference, levels of 255 "
             "| RMSE to the oracle | has a place | of OpenGL alone |", "|" + "---|" * 10]
    for (scene, transfer), rows in looks.items():
        standard = standard_of(rows)
        exact = [row for row in rows if row["method"].startswith("Exact") and row["sort"] == "chosen"]
        for row in [row for row in rows if is_approximate(row)] + exact if standard else ():
            cells = (scene, transfer, row["name"], f"{row['cells']:.0f}", f"{row['median_ms']:.1f}",
                     f"{standard['median_ms'] / row['median_ms']:.2f}", shown(row["levels_to_shirley_tuchman"], ".2f"),
                     f"{row['rmse_outside']:.1e}", "yes" if has_place(row, rows) else "no",
                     ("yes" if has_place(row, by_opengl(rows)) else "no") if row in by_opengl(rows) else "")
            lines.append("| " + " | ".join(cells) + " |")
    return lines


def between(values, form=".2f"):
    return f"{min(values):{form}} to {max(values):{form}}" if values else "not measured"


def read_approximations(looks):
    found = {}
    for rows in looks.values():
        standard = standard_of(rows)
        for row in rows if standard else ():
            if row["method"] in CHEAP:
                found.setdefault(row["method"], []).append(
                    (standard["median_ms"] / row["median_ms"], row["levels_to_shirley_tuchman"] or 0.0))
    return "; ".join(f"{name} {between([pair[0] for pair in pairs])} times as fast, "
                     f"{between([pair[1] for pair in pairs])} levels off" for name, pairs in found.items())


def read_levels(looks):
    """Levels of the mesh against the cheap approximations of all of it."""
    lines, beaten, cheap = [], 0, 0
    for (scene, transfer), rows in looks.items():
        standard = standard_of(rows)
        levels = [row for row in rows if row["method"] == LEVELS + APPROXIMATIONS[0]]
        for row in levels if standard else ():
            paper = PAPER_LEVELS.get((scene, row["setting"]))
            lines.append(f"{scene}, {transfer}, {row['setting']}: {100.0 * row['cells'] / standard['cells']:.1f} % of the "
                         f"cells, {standard['median_ms'] / row['median_ms']:.2f} times as fast, "
                         f"{row['levels_to_shirley_tuchman']:.2f} levels off"
                         + (f" (paper{', over its level of 2 %' * (scene == 'Blunt Fin')}: {paper[0]:.2f} times, "
                            f"{paper[1]:.2f})" if paper else ""))
        for row in rows if levels else ():
            if row["method"] in CHEAP:
                cheap += 1
                beaten += any(level["median_ms"] < row["median_ms"] and level["levels_to_shirley_tuchman"]
                              < row["levels_to_shirley_tuchman"] for level in levels)
    return lines, beaten, cheap


def read_places(looks, choose):
    places = {}
    for rows in looks.values():
        for row in choose(rows):
            if row["method"] in APPROXIMATIONS:
                places.setdefault(row["method"], []).append(has_place(row, choose(rows)))
    kept = [f"{name} in {sum(places[name])} of {len(places[name])}" for name in APPROXIMATIONS
            if any(places.get(name, ()))]
    gone = [name for name in APPROXIMATIONS if name in places and not any(places[name])]
    return (", ".join(kept) or "none of them") + " of the scenes and functions above" + (
        f"; never for {', '.join(gone)}" if gone and kept else "")


def reading(looks):
    """What the numbers say, in words that follow from them."""
    levels, beaten, cheap = read_levels(looks)
    return [
        "Cignoni, Montani, Sarti and Scopigno (1995) take the standard projected tetrahedra for the right image. Of their "
        "Voxel, UTS1, UTS2 and Centroid the text at hand, which lacks their tables 2 and 3, says that an image by UTS2 "
        "took about 8 s on the Bucky ball, where their table 4 has 15.24 s for the standard method on 176,687 "
        "tetrahedra, and that it lies about as far off as the standard method on a mesh simplified at 10 % error, of which "
        "table 4 has a mean image error of 10.02 and 1.42 s. Here, against ShirleyTuchman: "
        f"{read_approximations(looks) or 'nothing was measured'}. What the approximations avoid, by the paper, is "
        "intersections and interpolations at the thickest point, and triangles; sorting they do not avoid.", "",
        "Simplify or approximate? Levels of the mesh by vtkTetrahedraSimplifier, drawn by the same standard method: "
        f"{'; '.join(levels) or 'not measured'}. In {beaten} of {cheap} cases a level is both faster than Voxel, "
        "UniformThickness1, UniformThickness2 or Centroid on the whole mesh and nearer to the standard image.", "",
        "**Still worth using today:** an approximation has a place where no other method of the same scene and function is "
        "both faster and more exact, and where it is no further off than VTK's projected tetrahedra. That holds for "
        f"{read_places(looks, lambda rows: rows)}; of what OpenGL draws from the whole mesh, Tiles and levels left out, "
        f"for {read_places(looks, by_opengl)}."]


def processor():
    info = pathlib.Path("/proc/cpuinfo")
    names = [line.split(":", 1)[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")] \
        if info.exists() else []
    return names[0] if names else "unknown processor"


def write_report(rows, folder):
    lines = [
        "# Speed against error", "",
        f"{len(rows)} rows, {os.cpu_count()} cores, {processor()}. Drawn by `make report` from [report.csv](report.csv).", "",
        "Speed: median of 9 frames with a new eye each (of fewer, in brackets, where a method is slow). First: the first "
        "frame; prepare: what of it is not done again. Ratio: VTK's projected tetrahedra's median in the same run over "
        "the method's. Error: premultiplied float RGBA of the volume against a float64 ray caster, over covered pixels of "
        "three views, two from outside and one from inside the mesh: RMSE and share of all pixels, the largest percentile "
        "and maximum of the views, and the maximum inside; of VTK's mappers the 8-bit window. VTK's ray casters draw "
        "nothing from inside (a frame of ZSweep does not even end: its errors are those from outside). Of simplified meshes "
        "the error is that to the whole mesh. Misordered: shared faces whose cells are drawn in the wrong order; empty "
        "where there is no order. Each blend mode is compared with its own oracle.", "",
        "## Do the bars hold?", "", "Largest error in any of the three views, and misordered faces in them.", ""]
    lines += bar_table(rows) + [""]
    for (scene,), shown_rows in grouped(rows, "scene").items():
        picture = scene.lower().replace(" ", "_") + ".png"
        plot_scene(scene, shown_rows, folder / picture)
        lines += [f"## {scene}", "", f"![{scene}]({picture})", ""]
        for (transfer, light), look in grouped(shown_rows, "transfer", "light").items():
            lines += [f"### {scene}, {transfer}, {light}", ""] + table(look) + [""]
            missing = [name for name in dict.fromkeys(row["name"] for row in rows if row["light"] == light)
                       if name not in {row["name"] for row in look}]
            lines += [f"Not drawn here, or given up for a frame that took too long: {', '.join(missing)}.", ""] * bool(missing)
    composite = [row for row in rows if row["blend"] == "composite" and row["light"] == "unlit"]
    classic = [row for row in composite if row["scene"] in ("Bucky ball", "Blunt Fin")] or composite
    looks = grouped(classic, "scene", "transfer")
    lines += ["## The approximations of the literature", ""] + approximation_table(looks) + [
        "", "Speed-up and difference: from ShirleyTuchman's frame and image of the whole mesh; RMSE: from outside.", ""]
    lines += reading(looks) + [""]
    (folder / "report.md").write_text("\n".join(lines))


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = read(folder / "report.csv")
    if not rows:
        sys.exit("report.csv has no rows")
    write_report(rows, folder)
    print(folder / "report.md")


if __name__ == "__main__":
    main()
