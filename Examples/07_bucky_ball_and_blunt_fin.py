"""Two meshes of the paper, each drawn as the hexahedra that it is: no cell is cut up, nothing is sorted.

    python3 07_bucky_ball_and_blunt_fin.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import scene
from vtkcellprojection import vtkProjectedPolyhedraMapper
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingCore import vtkRenderer

arguments = scene.make_parser(__doc__, "bucky_ball_and_blunt_fin.png", (1200, 520)).parse_args()

# Share of the scalar range, colour, emission: shells of the ball, and the air that the fin's shock compresses.
BALL = ((0.0, 0.1, 0.2, 0.9, 0.0), (0.22, 0.1, 0.3, 1.0, 0.0), (0.34, 0.15, 0.4, 1.0, 0.22), (0.46, 0.1, 0.3, 0.9, 0.03),
        (0.62, 1.0, 0.45, 0.1, 0.12), (0.8, 1.0, 0.5, 0.1, 1.1), (1.0, 1.0, 0.7, 0.3, 2.0))
FIN = ((0.0, 0.2, 0.1, 0.8, 0.0), (0.14, 0.1, 0.3, 1.0, 0.0), (0.19, 0.1, 0.5, 1.0, 0.12), (0.26, 0.3, 0.9, 0.5, 0.18),
       (0.4, 1.0, 0.7, 0.15, 0.5), (0.6, 1.0, 0.3, 0.1, 1.6), (1.0, 1.0, 0.1, 0.1, 4.0))


def draw(renderer, structured, name, nodes, direction, zoom):
    append, mapper = vtkAppendFilter(), vtkProjectedPolyhedraMapper()
    append.SetInputData(structured)
    append.Update()
    grid = append.GetOutput()
    scene.add_volume(renderer, mapper, grid, scene.make_property(grid.GetScalarRange(), grid.GetLength(), nodes))
    scene.look_at(renderer, grid.GetBounds(), direction, zoom)
    renderer.GetRenderWindow().Render()
    row = mapper.GetLastStatistics()
    counts = [row.GetValueByName(0, column).ToInt() for column in ("CellsIn", "CellsDrawn", "CellsSkippedTransparent")]
    print("{}: {} hexahedra, {} drawn, {} that emit nothing left out".format(name, *counts))
    return grid


window, left = scene.make_window(*arguments.size)
right = vtkRenderer()
right.SetBackground(left.GetBackground())
left.SetViewport(0.0, 0.0, 0.42, 1.0)
right.SetViewport(0.42, 0.0, 1.0, 1.0)
window.AddRenderer(right)
draw(left, *meshes.load_bucky_ball(), BALL, (0.7, -1.0, 0.45), 1.55)
right.AddActor(scene.make_outline(draw(right, *meshes.load(), FIN, (-0.9, 1.0, 0.55), 1.3)))
window.Render()
print(scene.save(window, arguments.output))
