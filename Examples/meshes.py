"""The meshes that the examples show: from files where they are, else generated."""

import math
import os
import pathlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_QUADRATIC_HEXAHEDRON, vtkMultiBlockDataSet, vtkPerlinNoise, vtkStructuredGrid,
    vtkUnstructuredGrid)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader

try:
    from vtkmodules.vtkIOExodus import vtkExodusIIReader
except ImportError:
    vtkExodusIIReader = None

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


def find_leaves(corner, size, is_fine):
    """The cubes of an octree: corner and size; is_fine(middle, size) says which are cut."""
    if not is_fine([c + 0.5 * size for c in corner], size):
        return [(corner, size)]
    half = size // 2
    children = [tuple(c + half * (i >> axis & 1) for axis, c in enumerate(corner)) for i in range(8)]
    return [leaf for child in children for leaf in find_leaves(child, half, is_fine)]


def make_octree(size, is_fine):
    """Polyhedra, one a leaf of the octree of a cube, with the nodes and faces of smaller leaves beside them."""
    leaves = find_leaves((0, 0, 0), size, is_fine)
    nodes = {tuple(c + s * (i >> axis & 1) for axis, c in enumerate(leaf)) for leaf, s in leaves for i in range(8)}
    points, grid = vtkPoints(), vtkUnstructuredGrid()
    nodes = {node: points.InsertNextPoint(node) for node in sorted(nodes)}

    def split_edge(a, b):
        middle = tuple((p + q) // 2 for p, q in zip(a, b))
        hangs = middle in nodes and middle not in (a, b)
        return split_edge(a, middle) + split_edge(middle, b) if hangs else [nodes[a]]

    def split_side(corner, length, u, v):
        def at(i, j):
            return tuple(c + i * (axis == u) + j * (axis == v) for axis, c in enumerate(corner))
        half = length // 2
        if half and at(half, half) in nodes:
            return [f for i in (0, half) for j in (0, half) for f in split_side(at(i, j), half, u, v)]
        square = [at(0, 0), at(length, 0), at(length, length), at(0, length)]
        return [[node for a, b in zip(square, square[1:] + square[:1]) for node in split_edge(a, b)]]

    grid.SetPoints(points)
    for leaf, length in leaves:
        sides = [(leaf[:a] + (leaf[a] + s,) + leaf[a + 1:], (a + 1) % 3, (a + 2) % 3) for a in range(3) for s in (0, length)]
        faces, stream = [face for corner, u, v in sides for face in split_side(corner, length, u, v)], vtkIdList()
        for number in [len(faces)] + [n for face in faces for n in (len(face), *face)]:
            stream.InsertNextId(number)
        grid.InsertNextCell(VTK_POLYHEDRON, stream)
    return grid


def make_quadratic_ring(cells):
    """Hexahedra of 20 nodes around a ring, round and with a wave of heat, and their linear twins of 8 nodes."""
    sides = [(0, 0), (2, 0), (2, 2), (0, 2)]
    middles = [(1, 0), (2, 1), (1, 2), (0, 1)]
    places = [(k, *s) for k in (0, 2) for s in sides] + [(k, *s) for k in (0, 2) for s in middles] + [(1, *s) for s in sides]
    points, wave, grid, twin, ids = vtkPoints(), vtkDoubleArray(), vtkUnstructuredGrid(), vtkUnstructuredGrid(), {}
    for cell in range(cells):
        for k, i, j in places:
            key = ((2 * cell + k) % (2 * cells), i, j)
            if key not in ids:
                angle, radius = math.pi * key[0] / cells, 0.6 + 0.2 * i
                ids[key] = points.InsertNextPoint(radius * math.cos(angle), radius * math.sin(angle), 0.25 * j)
                wave.InsertNextValue(0.5 + 0.4 * math.cos(2.0 * angle) + 0.1 * (j - 1))
        corners = [ids[(2 * cell + k) % (2 * cells), i, j] for k, i, j in places]
        grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, corners)
        twin.InsertNextCell(VTK_HEXAHEDRON, 8, corners[:8])
    for mesh in (grid, twin):
        mesh.SetPoints(points)
        mesh.GetPointData().SetScalars(wave)
    return grid, twin


def read_blocks(path):
    """The blocks of an Exodus file with all their point data."""
    reader = vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.Update()
    return reader.GetOutput()


def load_blocks():
    """Composite data, the name of its scalar and of itself."""
    path = find_data("disk_out_ref.ex2")
    if path and vtkExodusIIReader:
        return read_blocks(path), "Temp", "disk_out_ref"
    print("disk_out_ref.ex2 is not here, or VTK cannot read it: these are two generated blocks.")
    blocks = vtkMultiBlockDataSet()
    for block, size in enumerate(((14, 10, 10), (20, 16, 8))):
        move, turned = vtkTransform(), vtkTransformFilter()
        move.RotateZ(120.0 * block)
        turned.SetTransform(move)
        turned.SetInputData(make_curvilinear(size))
        turned.Update()
        blocks.SetBlock(block, turned.GetOutput())
    return blocks, "Density", "generated blocks"
