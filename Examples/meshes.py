"""The meshes that the examples show: from files where they are, else generated."""

import math
import os
import pathlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader

ROOT = pathlib.Path(__file__).resolve().parents[1]


def read_blunt_fin(folder):
    """40 x 32 x 32 points around a fin on a plate, with the density of the air."""
    reader = vtkMultiBlockPLOT3DReader()
    reader.SetXYZFileName(str(folder / "bluntfinxyz.bin"))
    reader.SetQFileName(str(folder / "bluntfinq.bin"))
    reader.SetScalarFunctionNumber(100)
    reader.Update()
    return reader.GetOutput().GetBlock(0)


def make_curvilinear(size=(40, 32, 32)):
    """A lattice bent around an axis, with a wave in its density."""
    points = vtkPoints()
    density = vtkDoubleArray()
    density.SetName("Density")
    for k in range(size[2]):
        for j in range(size[1]):
            for i in range(size[0]):
                angle = 2.0 * i / (size[0] - 1)
                radius = 1.0 + (j / (size[1] - 1)) ** 1.5
                z = k / (size[2] - 1)
                points.InsertNextPoint(radius * math.cos(angle), radius * math.sin(angle), z)
                wave = 0.5 + 0.5 * math.sin(4.0 * angle) * math.cos(3.0 * radius + 2.0 * z)
                density.InsertNextValue(0.2 + 4.8 * wave ** 4)
    grid = vtkStructuredGrid()
    grid.SetDimensions(size)
    grid.SetPoints(points)
    grid.GetPointData().SetScalars(density)
    return grid


def load():
    """The structured grid and its name."""
    folder = pathlib.Path(os.environ.get("CELLPROJECTION_DATA", ROOT.parent / "shared" / "data"))
    if (folder / "bluntfinxyz.bin").exists():
        return read_blunt_fin(folder), "Blunt Fin"
    print("The Blunt Fin data are not here: this is a generated curvilinear mesh.")
    return make_curvilinear(), "generated mesh"


def make_hexahedra(x, y, z, **arrays):
    """An unstructured grid of hexahedra; all arrays have the shape of the lattice, [k, j, i]."""
    x, y, z = numpy.broadcast_arrays(x, y, z)
    points, grid, append = vtkPoints(), vtkStructuredGrid(), vtkAppendFilter()
    points.SetData(numpy_to_vtk(numpy.stack((x, y, z), axis=-1).reshape(-1, 3).astype(float), deep=True))
    grid.SetDimensions(x.shape[::-1])
    grid.SetPoints(points)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.broadcast_to(values, x.shape).ravel().astype(float), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    grid.GetPointData().SetActiveScalars(next(iter(arrays)))
    append.SetInputData(grid)
    append.Update()
    return append.GetOutput()
