"""Six linear hexahedra beside six quadratic ones of the same corners, whose heat and shape go on between them.

    python3 13_quadratic_cells.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkRenderingCore import vtkRenderer

arguments = scene.make_parser(__doc__, "quadratic_cells.png", (1200, 600)).parse_args()
NODES = ((0.0, 0.1, 0.3, 0.9, 0.6), (0.4, 0.3, 0.8, 0.8, 0.4), (0.7, 1.0, 0.8, 0.2, 1.2), (1.0, 1.0, 0.25, 0.1, 4.0))

quadratic, linear = meshes.make_quadratic_ring(6)
window, renderer = scene.make_window(*arguments.size)
right = vtkRenderer()
right.SetBackground(renderer.GetBackground())
window.AddRenderer(right)
for side, mesh, left in ((renderer, linear, 0.0), (right, quadratic, 0.5)):
    side.SetViewport(left, 0.0, left + 0.5, 1.0)
    mapper = vtkPreIntegratedTetrahedraMapper()
    # Of the size of the mesh and of the range of its scalar; only what is curved is cut.
    mapper.SetTolerance(2e-3)
    scene.add_volume(side, mapper, mesh, scene.make_property((0.0, 1.0), mesh.GetLength(), NODES))
    # On both sides the edges between the corners, which the quadratic cells leave.
    side.AddActor(scene.make_outline(linear))
    scene.look_at(side, quadratic.GetBounds(), (0.0, -1.0, 1.4), 1.25)
window.Render()
for side in (renderer, right):
    drawn = side.GetVolumes().GetItemAsObject(0).GetMapper().GetLastStatistics()
    print(drawn.GetValueByName(0, "CellsIn"), "cells,", drawn.GetValueByName(0, "CellsDrawn"), "tetrahedra drawn")
print(scene.save(window, arguments.output))
