"""Search lights over a town: each is 1,395 hexahedra whose emission falls with the square of the distance.

    python3 04_search_light.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import random

import meshes
import numpy
import scene
from vtkcellprojection import vtkProjectedPolyhedraMapper
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkPlaneSource

arguments = scene.make_parser(__doc__, "search_light.png").parse_args()

# 16 x 4 x 32 points around the axis, from it, along it; the lamp's radius is 1 and the cone opens by 1 in 14.
angle = numpy.linspace(0.0, 2.0 * numpy.pi, 16)[None, None, :]
share = numpy.linspace(0.0, 1.0, 4)[None, :, None]
height = 170.0 * numpy.linspace(0.0, 1.0, 32)[:, None, None] ** 1.5
width = 1.0 + height / 14.0
light = (1.0 - share ** 2) / width ** 2
cone = meshes.make_hexahedra(
    width * share * numpy.cos(angle), width * share * numpy.sin(angle), height, light=light)
print(f"{cone.GetNumberOfCells()} hexahedra")

window, renderer = scene.make_window(*arguments.size)
scene.set_sky(renderer, (0.07, 0.08, 0.14), (0.0, 0.005, 0.02))
lamps = ((-26.0, 5.0, 24.0, (1.0, 0.9, 0.65)), (2.0, 12.0, 4.0, (0.7, 0.85, 1.0)),
         (30.0, 0.0, -30.0, (0.85, 0.9, 1.0)), (48.0, 20.0, -14.0, (1.0, 0.8, 0.6)))
for x, y, lean, color in lamps:
    emission = scene.make_emission(((0.0, *color, 0.0), (1.0, *color, 1.4)))
    beam = scene.add_volume(renderer, vtkProjectedPolyhedraMapper(), cone, emission)
    beam.SetPosition(x, y, 2.0)
    beam.RotateY(lean)
    lamp = vtkCylinderSource()
    lamp.SetHeight(2.4)
    lamp.SetRadius(1.2)
    lamp.SetResolution(24)
    body = scene.add_surface(renderer, lamp, (0.25, 0.25, 0.28))
    body.SetPosition(x, y, 1.0)
    body.RotateY(lean)
    body.RotateX(90.0)

ground = vtkPlaneSource()
field = scene.add_surface(renderer, ground, (0.03, 0.035, 0.05))
field.SetScale(1000.0, 1000.0, 1.0)
field.GetProperty().LightingOff()
town = random.Random(3)
for house in range(70):
    cube = vtkCubeSource()
    size = [town.uniform(3.0, 8.0), town.uniform(3.0, 8.0), town.uniform(4.0, 22.0)]
    block = scene.add_surface(renderer, cube, (0.10, 0.11, 0.15))
    block.SetScale(size)
    block.SetPosition(town.uniform(-110.0, 110.0), town.uniform(28.0, 120.0), 0.5 * size[2])
scene.set_camera(renderer, (0.0, -110.0, 7.0), (8.0, 0.0, 36.0), 46.0)
window.Render()
print(scene.save(window, arguments.output))
