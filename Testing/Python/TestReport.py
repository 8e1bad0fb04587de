"""The report from end to end on a lattice of a few cells: every column is there and holds what it says."""

import csv
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ("scene", "cells", "transfer", "light", "method", "setting", "engine", "sort", "blend", "frames", "median_ms",
           "first_ms", "prepare_ms", "mcells_per_s", "ratio_to_vtk", "rmse", "p999", "maximum",
           "share_above_half_level", "rmse_outside", "maximum_inside", "misordered_faces", "levels_to_shirley_tuchman")

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    progress = subprocess.run([sys.argv[1], folder / "report.csv", "tiny"], check=True, text=True, capture_output=True)
    with open(folder / "report.csv", newline="") as stream:
        table = csv.DictReader(stream)
        rows = list(table)
        assert tuple(table.fieldnames) == COLUMNS, table.fieldnames
    assert len(progress.stdout.splitlines()) == len(rows), progress.stdout
    assert {(row["method"], row["transfer"]) for row in rows if row["light"] == "unlit"} == {
        (method, transfer) for method in ("VTK projected tetrahedra", "Exact, Raster", "ShirleyTuchman",
                                          "Simplified, ShirleyTuchman", "Simplified, Exact, Tiles")
        for transfer in ("smooth", "spiky")}
    for row in rows:
        assert row["scene"] == "lattice" and row["frames"] == "3", row
        is_whole = not row["method"].startswith("Simplified")
        assert (row["cells"] == "384") if is_whole else (0 < int(row["cells"]) < 384), row
        median, speed = float(row["median_ms"]), float(row["mcells_per_s"])
        assert abs(speed * median / (int(row["cells"]) / 1000.0) - 1.0) < 0.01, row
        assert float(row["first_ms"]) > 0.0 and float(row["ratio_to_vtk"]) > 0.0, row
        errors = [float(row[column]) for column in ("rmse", "p999", "maximum")]
        assert errors == sorted(errors) and 0.0 < float(row["maximum_inside"]) <= errors[2], row
        assert 0.0 < float(row["rmse_outside"]) <= errors[2], row
        assert 0.0 <= float(row["share_above_half_level"]) <= 1.0, row
        if row["method"] == "Exact, Raster":
            assert errors[2] < 1e-4 * (1.0 if row["light"] == "unlit" else 10.0), row
            assert row["misordered_faces"] == "0" and float(row["prepare_ms"]) > 0.0, row
        elif row["method"] == "VTK projected tetrahedra":
            assert errors[0] > 1e-3 and int(row["misordered_faces"]) > 0 and float(row["ratio_to_vtk"]) == 1.0, row
            # From inside it is another picture.
            assert abs(float(row["rmse_outside"]) / errors[0] - 1.0) > 0.01, row
        elif is_whole:
            assert float(row["levels_to_shirley_tuchman"]) == 0.0, row
        else:
            # The oracle's is the whole mesh; the standard method draws no light.
            assert errors[0] > 1e-3, row
            assert row["light"] == "lit" or float(row["levels_to_shirley_tuchman"]) > 0.1, row

    drawn = subprocess.run([sys.executable, ROOT / "Testing" / "Benchmark" / "report.py", folder], check=True, text=True,
                           capture_output=True)
    report = (folder / "report.md").read_text()
    assert drawn.stdout.strip() == str(folder / "report.md"), drawn.stdout
    assert (folder / "lattice.png").stat().st_size > 10000
    # A line per row in the tables, each with its numbers.
    for row in rows:
        name = f"{row['method']} {row['setting']}".strip()
        assert f"| {name} | {row['engine']} | {row['sort']} | " in report, row
        assert f"| {float(row['rmse']):.1e} | " in report, row
    # The bars, and the levels beside the approximations.
    for transfer in ("smooth", "spiky"):
        assert any(line.startswith(f"| lattice | {transfer} | ") and line.endswith("| 0 | yes |")
                   for line in report.splitlines()), report
    assert "lattice, smooth, 20 %: " in report
