"""Ground fog on Mount St. Helens: prisms on a mesh whose detail goes with the eye, as light and as a maximum.

    python3 09_ground_fog.py [-o picture.png] [--size WIDTH HEIGHT] [--generated] [--flight FRAMES]
"""

import flight
import numpy
import scene
import terrain
from vtkmodules.vtkRenderingCore import vtkRenderer

parser = scene.make_parser(__doc__, "ground_fog.png", (1200, 800))
parser.add_argument("--generated", action="store_true", help="mountains from Perlin noise")
parser.add_argument("--flight", type=int, metavar="FRAMES", help="measures how much a pixel changes in a slow flight")
arguments = parser.parse_args()

DEPTH = 220.0  # of the fog, metres
heights, spacing = (terrain.make_heights(), 60.0) if arguments.generated else terrain.load_heights()
level = numpy.percentile(heights, 40.0)
width, length = spacing * (numpy.array(heights.shape[::-1]) - 1.0)
window, lower = scene.make_window(*arguments.size)

if arguments.flight:
    window.SetSize(640, 480)
    for maximum in (False, True):
        lower.RemoveAllViewProps()
        foggy = flight.FoggyScene(lower, heights, spacing, level, DEPTH, maximum)
        path = flight.Flight(foggy, 0.005, 0.5 * arguments.flight, arguments.flight + 1)
        changes = path.compare(window, path.find_pops(20))
        print("maximum" if maximum else "emission", "| largest change of 255, {:.2f} with geomorphing, {:.2f} without, "
              "{:.2f} at full resolution".format(*changes))

upper = vtkRenderer()
window.AddRenderer(upper)
upper.SetViewport(0.0, 0.5, 1.0, 1.0)
lower.SetViewport(0.0, 0.0, 1.0, 0.5)
eye, focal_point = (0.5 * width, -0.2 * length, 2600.0), (0.5 * width, 0.4 * length, 1100.0)
for renderer, maximum in ((upper, False), (lower, True)):
    renderer.RemoveAllViewProps()
    foggy = flight.FoggyScene(renderer, heights, spacing, level, DEPTH, maximum)
    triangles = foggy.show(eye, focal_point, 0.003, view_angle=30.0)
    print(f"{triangles} triangles, {foggy.fog.GetInput().GetNumberOfCells()} prisms")
window.SetSize(*arguments.size)
window.Render()
print(scene.save(window, arguments.output))
