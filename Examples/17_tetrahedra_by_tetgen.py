"""A mixed mesh whose polyhedra no point sees all of: TetGen meshes the inside of its boundary anew.

    python3 17_tetrahedra_by_tetgen.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import math
import sys

import scene
import vtkcellprojection
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_POLYHEDRON, vtkUnstructuredGrid

arguments = scene.make_parser(__doc__, "tetrahedra_by_tetgen.png", (960, 640)).parse_args()
if not hasattr(vtkcellprojection, "vtkTetGenTetrahedralizer"):
    sys.exit(print("CellProjection was built without TetGen: install libtet1.5-dev and build again."))

STEPS, FLOORS = 48, 4
NODES = ((0.0, 0.1, 0.2, 0.9, 0.05), (0.5, 0.3, 0.9, 0.7, 0.1), (0.7, 1.0, 0.6, 0.1, 1.0), (1.0, 1.0, 0.2, 0.1, 4.0))


def make_mesh():
    """A spiral of polyhedra, one a floor, and a hexahedron a floor in the middle."""
    points, grid, corners, layer = vtkPoints(), vtkUnstructuredGrid(), 2 * STEPS, 2 * STEPS + 4
    for floor in range(FLOORS + 1):
        for side, shift in ((range(STEPS), 0.0), (reversed(range(STEPS)), 0.28)):
            for step in side:
                angle = 4.0 * math.pi * step / STEPS
                radius = 0.5 + 0.09 * angle + shift
                points.InsertNextPoint(radius * math.cos(angle), radius * math.sin(angle), 0.25 * floor)
        for x, y in ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)):
            points.InsertNextPoint(x, y, 0.25 * floor)
    grid.SetPoints(points)
    for low in range(0, FLOORS * layer, layer):
        sides = [(i, (i + 1) % corners, (i + 1) % corners + layer, i + layer) for i in range(corners)]
        faces, stream = [range(corners), range(layer, layer + corners)] + sides, vtkIdList()
        for number in [len(faces)] + [n for f in faces for n in (len(f), *(low + corner for corner in f))]:
            stream.InsertNextId(number)
        grid.InsertNextCell(VTK_POLYHEDRON, stream)
        grid.InsertNextCell(VTK_HEXAHEDRON, 8, [low + corners + i + up for up in (0, layer) for i in range(4)])
    return grid


tetrahedra, heat = vtkcellprojection.vtkTetGenTetrahedralizer(), vtkDoubleArray()
tetrahedra.SetInputData(make_mesh())
tetrahedra.SetModeToRemesh()
tetrahedra.SetMaximumVolume(5e-4)
tetrahedra.Update()
mesh = tetrahedra.GetOutput()
for x, y, z in (mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())):
    heat.InsertNextValue(0.5 + 0.5 * math.sin(4.0 * math.atan2(y, x) + 9.0 * z))
mesh.GetPointData().SetScalars(heat)
print(f"{2 * FLOORS} cells, {mesh.GetNumberOfCells()} tetrahedra, {tetrahedra.GetNumberOfNewPoints()} new points")
(window, renderer), mapper = scene.make_window(*arguments.size), vtkcellprojection.vtkPreIntegratedTetrahedraMapper()
scene.add_volume(renderer, mapper, mesh, scene.make_property((0.0, 1.0), mesh.GetLength(), NODES))
renderer.AddActor(scene.make_outline(mesh))
scene.look_at(renderer, mesh.GetBounds(), (0.3, -1.0, 1.1), 1.35)
window.Render()
print(scene.save(window, arguments.output))
