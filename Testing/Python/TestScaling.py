"""The benchmark's scaling from end to end on a few cells: every column is there and holds what it says."""

import csv
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = tuple(f"{stage}_ns" for stage in ("cull", "transform", "box", "bin", "order", "set_up", "cover", "shade",
                                           "composite", "repair", "write", "wait"))
COLUMNS = ("sweep", "cells", "width", "height", "threads", "transfer", "method", "engine", "frames", "median_ms",
           "first_ms", "prepare_ms", "mcells_per_s", "ratio_to_vtk", "timed_ms") + STAGES + (
               "rest_ns", "fragments", "fragments_per_s", "cells_in_tiles", "cover_lane_use", "shade_lane_use",
               "mesh_bytes_per_cell", "frame_bytes_per_cell", "repaired_pixels", "error_size", "rmse", "p999",
               "maximum", "share_above_half_level", "renderer", "processor", "smp_backend", "vtk")
BOUNDS = {"ours, Tiles": 1e-4, "ours, Raster": 1e-4, "VTK projected tetrahedra": 1.0, "VTK Bunyk": 1.0, "VTK ZSweep": 1.0}


def check(row):
    cells, median = int(row["cells"]), float(row["median_ms"])
    assert row["frames"] == "2" and float(row["first_ms"]) > 0.0, row
    assert abs(float(row["mcells_per_s"]) * median / (cells / 1000.0) - 1.0) < 0.01, row
    assert 0.0 < float(row["rmse"]) <= float(row["maximum"]) < BOUNDS[row["method"]], row
    assert row["error_size"] == "32" and row["renderer"] and row["processor"] and row["vtk"], row
    if row["method"] == "ours, Tiles":
        check_stages(row, cells, median)
    else:
        assert all(row[stage] == "" for stage in STAGES) and row["fragments"] == "", row


def check_stages(row, cells, median):
    stages = [float(row[stage]) for stage in STAGES]
    whole = 1e6 * float(row["timed_ms"]) / cells
    assert min(stages) >= 0.0 and 0.0 < sum(stages) <= whole * 1.0001, row
    assert abs(sum(stages) + float(row["rest_ns"]) - whole) <= 0.001 * whole, row
    for stage in ("cull_ns", "transform_ns", "box_ns", "bin_ns", "order_ns", "set_up_ns", "cover_ns", "shade_ns",
                  "composite_ns", "write_ns"):
        assert float(row[stage]) > 0.0, (stage, row)
    for use in ("cover_lane_use", "shade_lane_use"):
        assert 0.0 < float(row[use]) <= 1.0, row
    assert abs(float(row["fragments_per_s"]) * median / 1000.0 / float(row["fragments"]) - 1.0) < 0.01, row
    assert float(row["mesh_bytes_per_cell"]) > 16.0 and float(row["frame_bytes_per_cell"]) > 4.0, row
    assert float(row["cells_in_tiles"]) > 0.0 and float(row["repaired_pixels"]) >= 0.0, row


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    printed = subprocess.run([sys.argv[1], "2", "scaling-tiny", folder], check=True, text=True, capture_output=True)
    with open(folder / "scaling.csv", newline="") as stream:
        table = csv.DictReader(stream)
        rows = list(table)
        assert tuple(table.fieldnames) == COLUMNS, table.fieldnames
    for row in rows:
        check(row)
    by_cells = [row for row in rows if row["sweep"] == "cells"]
    assert {(row["method"], row["cells"]) for row in by_cells if row["transfer"] == "smooth"} == {
        (method, cells) for method in BOUNDS for cells in ("384",)}, by_cells
    assert {row["width"] for row in rows if row["sweep"] == "pixels"} == {"32", "64"}
    # Where the number of threads does not follow, it says so.
    threads = {row["threads"] for row in rows if row["sweep"] == "threads"}
    assert threads >= {"1"} or (len(threads) == 1 and "threads left out" in printed.stdout), printed.stdout
    # As many pieces of rays for four times the pixels, about.
    tiles = [row for row in rows if row["sweep"] == "pixels" and row["method"] == "ours, Tiles"]
    assert 3.5 < float(tiles[1]["fragments"]) / float(tiles[0]["fragments"]) < 4.5, tiles
    assert f"{folder}/scaling.csv" in printed.stdout, printed.stdout

    drawn = subprocess.run([sys.executable, ROOT / "Testing" / "Benchmark" / "scaling.py", folder], check=True, text=True,
                           capture_output=True)
    names = ("cells.png", "pixels.png", "threads.png", "scaling.md")
    assert drawn.stdout.split() == [str(folder / name) for name in names], drawn.stdout
    for name in names[:3]:
        assert (folder / name).stat().st_size > 10000
    # A line of times and one of stages for each row of Tiles.
    tables = (folder / "scaling.md").read_text()
    for row in rows:
        if row["method"] == "ours, Tiles":
            assert f"{float(row['maximum']):.1e} (32) |" in tables, row
            assert f"| {float(row['cover_lane_use']):.2f} | {float(row['shade_lane_use']):.2f} |" in tables, row
