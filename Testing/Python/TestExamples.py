"""Every numbered example writes a picture that is large enough and not empty; with and without data."""

import os
import pathlib
import subprocess
import sys
import tempfile

import vtkcellprojection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

NEED_DATA = ("01_render_a_file", "07_bucky_ball_and_blunt_fin", "09_ground_fog", "10_lit_bucky_ball",
             "18_exodus_blocks")
# What takes long where a processor draws.
SMALLER = ("14_bending_beam", "15_iso_surfaces", "16_warped_texture")
ROOT = pathlib.Path(__file__).resolve().parents[2]


def check_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)
    drawn = (abs(pixels - pixels[0]).max(axis=1) > 8).mean()
    print(path.name, image.GetDimensions(), f"{100 * drawn:.1f} % drawn")
    assert image.GetDimensions()[0] >= 512
    assert drawn > 0.05, "the picture is empty"


def run(example, folder, environment):
    picture = pathlib.Path(folder) / (example.stem + ".png")
    command = [sys.executable, str(example), "-o", str(picture)]
    command += ["--size", "512", "128"] if example.stem in SMALLER else []
    output = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout
    if "without TetGen" in output and not hasattr(vtkcellprojection, "vtkTetGenTetrahedralizer"):
        print(example.stem, "needs TetGen")
        return output
    assert output.splitlines()[-1] == str(picture.resolve()), output
    check_picture(picture)
    return output


examples = sorted(ROOT.glob("Examples/[0-9]*.py"))
assert len(examples) >= 9 and set(NEED_DATA) < {example.stem for example in examples}
without_data = dict(os.environ, CELLPROJECTION_DATA=str(ROOT / "no" / "such" / "folder"))
with tempfile.TemporaryDirectory() as folder:
    for example in examples:
        assert len(example.read_text().splitlines()) < 60, example
        output = run(example, folder, os.environ)
        # Where there are no data it has been run without them.
        if example.stem in NEED_DATA and "generated" not in output:
            assert "generated" in run(example, folder, without_data), example
