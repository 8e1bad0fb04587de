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
# Below this an error is rounding: the plots end here.
LEAST = 1e-8
NUMBERS = ("cells", "frames", "median_ms", "first_ms", "prepare_ms", "mcells_per_s", "ratio_to_vtk", "rmse", "p999",
           "maximum", "share_above_half_level", "misordered_faces", "levels_to_shirley_tuchman")


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
             "| % > 1/510 | misordered |", "|" + "---|" * 14]
    for row in rows:
        frames = "" if row["frames"] >= 9 else f" ({row['frames']:.0f})"
        cells = (row["name"], row["engine"], row["sort"], row["blend"], f"{row['median_ms']:.1f}{frames}",
                 f"{row['first_ms']:.0f}", f"{row['prepare_ms']:.1f}", f"{row['mcells_per_s']:.2f}",
                 f"{row['ratio_to_vtk']:.2f}", f"{row['rmse']:.1e}", f"{row['p999']:.1e}", f"{row['maximum']:.1e}",
                 f"{100.0 * row['share_above_half_level']:.1f}", shown(row["misordered_faces"], ".0f"))
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def has_place(row, rows):
    """No other row of the look is both faster and nearer to the oracle, and VTK's own approximation is no nearer."""
    worst = max((other["rmse"] for other in rows if other["method"] == REFERENCE), default=row["rmse"])
    return row["rmse"] <= worst and not any(
        other["median_ms"] < row["median_ms"] and other["rmse"] < row["rmse"] for other in rows)


def approximation_table(looks):
    lines = ["| scene | function | approximation | speed-up | mean difference, levels of 255 | RMSE to the oracle "
             "| has a place |", "|" + "---|" * 7]
    for (scene, transfer), rows in looks.items():
        standard = next((row for row in rows if row["method"] == APPROXIMATIONS[0]), None)
        for row in rows:
            if standard and row["method"] in APPROXIMATIONS:
                lines.append(f"| {scene} | {transfer} | {row['method']} | "
                             f"{standard['median_ms'] / row['median_ms']:.2f} | "
                             f"{shown(row['levels_to_shirley_tuchman'], '.2f')} | {row['rmse']:.1e} | "
                             f"{'yes' if has_place(row, rows) else 'no'} |")
    return lines


def between(values, form=".2f"):
    return f"{min(values):{form}} to {max(values):{form}}" if values else "not measured"


def reading(looks):
    """What the numbers say, in words that follow from them."""
    speed, difference, survivors = {}, {}, {}
    for rows in looks.values():
        standard = next((row for row in rows if row["method"] == APPROXIMATIONS[0]), None)
        for row in rows if standard else ():
            if row["method"] in APPROXIMATIONS:
                speed.setdefault(row["method"], []).append(standard["median_ms"] / row["median_ms"])
                difference.setdefault(row["method"], []).append(row["levels_to_shirley_tuchman"] or 0.0)
                survivors.setdefault(row["method"], []).append(has_place(row, rows))
    found = "; ".join(f"{name} {between(speed[name])} times as fast, {between(difference[name])} levels off"
                      for name in CHEAP if name in speed)
    kept = [f"{name} in {sum(survivors[name])} of {len(survivors[name])}" for name in APPROXIMATIONS
            if any(survivors.get(name, ()))]
    gone = [name for name in APPROXIMATIONS if name in survivors and not any(survivors[name])]
    return [
        "Cignoni, Montani, Sarti and Scopigno (1995) take the standard projected tetrahedra for the right image. Of their "
        "Voxel, UTS1, UTS2 and Centroid the text at hand, which lacks their tables 2 and 3, says that an image by UTS2 "
        "took about 8 s on the Bucky ball, where their table 4 has 15.24 s for the standard method on 176,687 "
        "tetrahedra, and that it lies as far off as the standard method on a mesh simplified at 10 % error, of which "
        f"table 4 has a mean image error of 10.02. Here, against ShirleyTuchman: {found or 'nothing was measured'}. "
        "What the approximations avoid, by the paper, is intersections and interpolations at the thickest point, and "
        "triangles; sorting, and in our case the ray in every fragment, they do not avoid.",
        "",
        "**Still worth using today:** an approximation has a place where no other method of the same scene and function is "
        "both faster and more exact, and where it is no further off than VTK's projected tetrahedra. That holds for " + (", ".join(kept) or "none of them") + " of the scenes and "
        "functions above" + (f"; never for {', '.join(gone)}" if gone else "") + "."]


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
        "the method's. Error: premultiplied float RGBA of the volume against a float64 ray caster, over covered pixels; "
        "of VTK's mappers the 8-bit window. Misordered: shared faces whose cells are drawn in the wrong order; empty "
        "where there is no order. Each blend mode is compared with its own oracle.", ""]
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
    lines += ["## The approximations of the literature", ""] + approximation_table(looks) + [""] + reading(looks) + [""]
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
