"""Laser cones in smoke: thin sheets of hexahedra, each a twentieth of its width.

    python3 05_laser_cone.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import numpy
import scene
from vtkcellprojection import vtkProjectedPolyhedraMapper
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource

arguments = scene.make_parser(__doc__, "laser_cone.png").parse_args()


def make_cone(slope, thickness, phase):
    """A mirror turns a beam along the cone; the smoke lights up in the sheet that it sweeps."""
    angle = numpy.linspace(0.0, 2.0 * numpy.pi, 97)[None, None, :]
    layer = numpy.linspace(-1.0, 1.0, 3)[None, :, None]
    along = 11.0 * numpy.linspace(0.005, 1.0, 73)[:, None, None] ** 1.2
    radius = along * (slope + thickness * layer)
    x, y, z = numpy.broadcast_arrays(radius * numpy.cos(angle), radius * numpy.sin(angle), along)
    density = numpy.clip(0.42 + 0.55 * meshes.make_noise(x + phase, y, z, 0.55, 3), 0.05, 1.0)
    # The same power crosses every circle of the cone, and none leaves the sheet.
    light = density * (1.0 - abs(layer)) / along
    return meshes.make_hexahedra(x, y, z, light=light * (1.0 - (along / 11.0) ** 6))


window, renderer = scene.make_window(*arguments.size)
lasers = ((0.0, 0.33, 0.016, (0.05, 1.0, 0.25)), (-3.4, 0.2, 0.02, (0.15, 0.35, 1.0)),
          (3.4, 0.2, 0.02, (1.0, 0.12, 0.2)))
for x, slope, thickness, color in lasers:
    cone = make_cone(slope, thickness, x)
    emission = scene.make_emission(((0.0, *color, 0.0), (1.0, *color, 9.0)))
    emission.GetScalarOpacity().AddPoint(10.0, 90.0)
    light = scene.add_volume(renderer, vtkProjectedPolyhedraMapper(), cone, emission)
    light.SetPosition(x, 0.0, 2.4)
    light.RotateX(84.0)
    box = scene.add_surface(renderer, vtkCubeSource(), (0.12, 0.12, 0.14))
    box.SetPosition(x, 0.33, 2.4)
    box.SetScale(0.5, 0.7, 0.4)
    print(f"{cone.GetNumberOfCells()} hexahedra")

floor = vtkPlaneSource()
floor.SetOrigin(-400.0, -400.0, 0.0)
floor.SetPoint1(400.0, -400.0, 0.0)
floor.SetPoint2(-400.0, 400.0, 0.0)
scene.add_surface(renderer, floor, (0.03, 0.03, 0.04)).GetProperty().LightingOff()
scene.set_sky(renderer, (0.02, 0.02, 0.035), (0.0, 0.0, 0.01))
scene.set_camera(renderer, (11.5, -17.0, 6.5), (-0.8, -4.5, 2.2), 36.0)
window.Render()
print(scene.save(window, arguments.output))
