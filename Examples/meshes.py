"""The meshes that the examples show: from files where they are, else generated."""

import math
import os
import pathlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPerlinNoise, vtkStructuredGrid
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


def find_data(name):
    """The file's path; None where it is not."""
    path = pathlib.Path(os.environ.get("CELLPROJECTION_DATA", ROOT.parent / "shared" / "data")) / name
    return path if path.exists() else None


def load():
    """The structured grid and its name."""
    path = find_data("bluntfinxyz.bin")
    if path:
        return read_blunt_fin(path.parent), "Blunt Fin"
    print("The Blunt Fin data are not here: this is a generated curvilinear mesh.")
    return make_curvilinear(), "generated mesh"


def make_bucky_ball(x, y, z):
    """Blobs at the 60 corners of a truncated icosahedron in the cube of half side 1."""
    golden = 0.5 * (1.0 + math.sqrt(5.0))
    kinds = ((0.0, 1.0, 3.0 * golden), (1.0, 2.0 + golden, 2.0 * golden), (golden, 2.0, 2.0 * golden + 1.0))
    signs = numpy.array(numpy.meshgrid((-1, 1), (-1, 1), (-1, 1))).reshape(3, -1).T
    corners = {tuple(numpy.roll(sign * kind, turn)) for kind in kinds for sign in signs for turn in range(3)}
    squares = [(x - a) ** 2 + (y - b) ** 2 + (z - c) ** 2 for a, b, c in 0.16 * numpy.array(sorted(corners))]
    return 255.0 * numpy.clip(sum(numpy.exp(-square / 0.018) for square in squares), 0.0, 1.0)


def load_bucky_ball():
    """32 x 32 x 32 points around a molecule of 60 atoms, as a structured grid, and its name."""
    z, y, x = numpy.mgrid[-1.0:1.0:32j, -1.0:1.0:32j, -1.0:1.0:32j]
    path = find_data("Bucky.raw")
    if path:
        return make_structured(x, y, z, density=numpy.fromfile(path, numpy.uint8).reshape(x.shape)), "Bucky ball"
    print("Bucky.raw is not here: this is a generated molecule.")
    return make_structured(x, y, z, density=make_bucky_ball(x, y, z)), "generated molecule"


def make_noise(x, y, z=0.0, frequency=1.0, octaves=1):
    """Perlin noise of the arrays' shape, each octave of twice the frequency and half the height of the one before."""
    x, y, z = numpy.broadcast_arrays(x, y, z)
    noise, total = vtkPerlinNoise(), numpy.zeros(x.size)
    for octave in range(octaves):
        noise.SetFrequency(*3 * [frequency * 2.0 ** octave])
        noise.SetPhase(*3 * [0.37 * octave])
        total += [0.5 ** octave * noise.EvaluateFunction(point) for point in zip(x.flat, y.flat, z.flat)]
    return total.reshape(x.shape)


def make_structured(x, y, z, **arrays):
    """A structured grid; all arrays have the shape of the lattice, [k, j, i], the first is the scalar."""
    x, y, z = numpy.broadcast_arrays(x, y, z)
    points, grid = vtkPoints(), vtkStructuredGrid()
    points.SetData(numpy_to_vtk(numpy.stack((x, y, z), axis=-1).reshape(-1, 3).astype(float), deep=True))
    grid.SetDimensions(x.shape[::-1])
    grid.SetPoints(points)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.broadcast_to(values, x.shape).ravel().astype(float), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    grid.GetPointData().SetActiveScalars(next(iter(arrays)))
    return grid


def make_hexahedra(x, y, z, **arrays):
    """The same as an unstructured grid."""
    append = vtkAppendFilter()
    append.SetInputData(make_structured(x, y, z, **arrays))
    append.Update()
    return append.GetOutput()
