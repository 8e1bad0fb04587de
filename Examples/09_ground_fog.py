"""Ground fog on Mount St. Helens: prisms on a mesh whose detail goes with the eye, as light and as a maximum.

    python3 09_ground_fog.py [-o picture.png] [--size WIDTH HEIGHT] [--generated] [--flight]
"""

import flight
import numpy
import scene
import terrain
from vtkmodules.vtkRenderingCore import vtkRenderer

parser = scene.make_parser(__doc__, "ground_fog.png", (1200, 800))
parser.add_argument("--generated", action="store_true", help="mountains from Perlin noise")
parser.add_argument("--flight", action="store_true", help="measures how much a slow flight changes a pixel per frame")
arguments = parser.parse_args()

heights, spacing = (terrain.make_heights(), 60.0) if arguments.generated else terrain.load_heights()
level = numpy.percentile(heights, 40.0)
width, length = spacing * (numpy.array(heights.shape[::-1]) - 1.0)
window, lower = scene.make_window(*arguments.size)
upper = vtkRenderer()
window.AddRenderer(upper)
upper.SetViewport(0.0, 0.5, 1.0, 1.0)
lower.SetViewport(0.0, 0.0, 1.0, 0.5)
eye, focal_point = (0.5 * width, -0.2 * length, 2600.0), (0.5 * width, 0.4 * length, 1100.0)
for renderer, maximum in ((upper, False), (lower, True)):
    foggy = flight.FoggyScene(renderer, heights, spacing, level, 220.0, maximum)
    triangles = foggy.show(eye, focal_point, 0.003, view_angle=30.0)
    print(f"{triangles} triangles, {foggy.fog.GetInput().GetNumberOfCells()} prisms")
window.Render()
print(scene.save(window, arguments.output))
