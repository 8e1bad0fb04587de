"""The synthetic examples, made small and with no data files, agree with their baselines by the rule of the C++ pictures.

Colours that differ by more than 3 of 255 may add up to one pixel. CELLPROJECTION_NEW_BASELINES in the environment names a
folder where the pictures are kept, to be looked at before they become baselines.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import vtkcellprojection
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURES = {"04_search_light": [], "05_laser_cone": [], "06_camp_fire": ["--frames", "1"], "08_aurora": [],
            "09_ground_fog": ["--generated"], "10_lit_bucky_ball": [], "14_bending_beam": [],
            "12_polyhedral_mesh": [], "13_quadratic_cells": [], "15_iso_surfaces": [], "16_warped_texture": [],
            "18_exodus_blocks": []}
if hasattr(vtkcellprojection, "vtkTetGenTetrahedralizer"):
    PICTURES["17_tetrahedra_by_tetgen"] = []
# Drivers place the samples of a multisampled window differently: here every pixel is one sample.
ONE_SAMPLE = """
import pathlib, runpy, sys
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderWindow
vtkOpenGLRenderWindow.SetGlobalMaximumNumberOfMultiSamples(0)
sys.argv = sys.argv[1:]
sys.path.insert(0, str(pathlib.Path(sys.argv[0]).parent))
runpy.run_path(sys.argv[0], run_name="__main__")
"""


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def find_difference(picture, baseline):
    """The colours' difference above 3, summed over the picture, and in all."""
    difference = vtkImageDifference()
    difference.SetInputData(read(picture))
    difference.SetImageData(read(baseline))
    difference.AllowShiftOff()
    difference.AveragingOff()
    difference.SetThreshold(3)
    difference.Update()
    return difference.GetThresholdedError(), difference.GetError()


with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(os.environ.get("CELLPROJECTION_NEW_BASELINES", scratch))
    different = []
    for name, options in PICTURES.items():
        picture = folder / f"TestGallery_{name}.png"
        command = [sys.executable, "-c", ONE_SAMPLE, str(ROOT / "Examples" / f"{name}.py"), "-o", str(picture)]
        command += ["--size", "160", "120"] + options
        environment = dict(os.environ, CELLPROJECTION_DATA=str(ROOT / "no" / "such" / "folder"))
        subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
        baseline = ROOT / "Testing" / "Data" / "Baseline" / picture.name
        above, error = find_difference(picture, baseline) if baseline.exists() else (float("inf"), float("inf"))
        print(f"{name}: difference {error:.3f}, above 3: {above:.3f}")
        if above > 1.0:
            different.append(name)
    assert not different, different
