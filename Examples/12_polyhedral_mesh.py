"""Polyhedra with hanging nodes: an octree as a finite-volume code writes it, fed to the mapper as it is.

    python3 12_polyhedral_mesh.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import math

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkCommonCore import vtkDoubleArray

arguments = scene.make_parser(__doc__, "polyhedral_mesh.png", (960, 720)).parse_args()
NODES = ((0.0, 0.1, 0.2, 0.8, 0.0), (0.35, 0.1, 0.4, 1.0, 0.3), (0.6, 0.9, 0.8, 0.2, 2.0), (1.0, 1.0, 0.3, 0.1, 20.0))


def distance(x, y, z):
    """From two rings through each other, links of a chain."""
    first = math.hypot(math.hypot(x - 11.0, y - 16.0) - 8.0, z - 16.0)
    return min(first, math.hypot(math.hypot(x - 21.0, z - 16.0) - 8.0, y - 16.0))


def is_fine(middle, size):
    """Small cells near the rings, none of a quarter of the cube."""
    return size > 4 or (size > 1 and distance(*middle) < size + 1.0)


grid, density = meshes.make_octree(32, is_fine), vtkDoubleArray()
for node in (grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())):
    density.InsertNextValue(math.exp(-0.15 * distance(*node) ** 2))
grid.GetPointData().SetScalars(density)
print(f"{grid.GetNumberOfCells()} polyhedra, {grid.GetNumberOfPoints()} points")
(window, renderer), mapper = scene.make_window(*arguments.size), vtkPreIntegratedTetrahedraMapper()
scene.add_volume(renderer, mapper, grid, scene.make_property((0.0, 1.0), grid.GetLength(), NODES))
scene.add_cut(renderer, grid, (0.0, 0.0, 16.01), (0.0, 0.0, 1.0))
renderer.AddActor(scene.make_outline(grid))
scene.look_at(renderer, grid.GetBounds(), (-0.7, -1.0, 1.1), 1.0)
window.Render()
print(scene.save(window, arguments.output))
