"""Aurora over a lake: curtains stand on the depth to which the particles penetrate; three lines of light, one mesh.

    python3 08_aurora.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import numpy
import scene
import terrain
from vtkcellprojection import vtkProjectedPolyhedraMapper
from vtkmodules.vtkCommonDataModel import vtkPlane

arguments = scene.make_parser(__doc__, "aurora.png").parse_args()
NIGHT = ((700.0, 0.03, 0.06, 0.07), (1500.0, 0.05, 0.10, 0.11), (2000.0, 0.20, 0.30, 0.30), (2600.0, 0.30, 0.45, 0.42))
# Nitrogen at the lower edge, oxygen at 558 nm, oxygen at 630 nm high up: height of the most light, its spread, colour.
LINES = {"nitrogen": (0.04, 0.06, (0.75, 0.2, 1.0), 0.6), "green": (0.16, 0.2, (0.15, 1.0, 0.45), 1.2),
         "red": (0.55, 0.35, (0.9, 0.1, 0.45), 0.6)}


def make_curtain(distance, phase):
    """240 x 3 x 20 points along the curtain, through it and upwards, in tens of kilometres."""
    along = numpy.linspace(-1.0, 1.0, 240)[None, None, :]
    layer = numpy.linspace(-1.0, 1.0, 3)[None, :, None]
    up = numpy.linspace(0.0, 1.0, 20)[:, None, None] ** 1.5
    fold = meshes.make_noise(along, phase, 0.5, 1.6, 3)
    x = 55.0 * along + 4.0 * meshes.make_noise(along, phase + 4.0, 0.5, 5.0, 2)
    y = distance + 22.0 * fold + 0.35 * layer
    activity = numpy.clip(0.6 + 0.9 * meshes.make_noise(along, phase, 0.7, 17.0, 3), 0.15, 1.0)
    activity *= numpy.clip(0.7 + 1.1 * meshes.make_noise(along, phase, 3.3, 1.3), 0.0, 1.0)
    z = 9.0 - 1.2 * activity + 0.8 * fold + up * (9.0 + 13.0 * activity)
    light = activity * (1.0 - abs(layer)) * numpy.minimum(1.0, 12.0 * (1.0 - along ** 2))
    return meshes.make_hexahedra(x, y, z, **{
        name: light * numpy.minimum(1.0, up / 0.04) * numpy.exp(-((up - centre) / spread) ** 2) * (1.0 - up)
        for name, (centre, spread, *_) in LINES.items()})


window, renderer = scene.make_window(*arguments.size)
heights = terrain.make_heights(65, 120.0)
ground = terrain.make_surface(terrain.Terrain(heights, 0.0 * heights, 120.0).make_mesh((0.0, 0.0, 0.0), 0.0), 7680.0)
for side, share in ((1.0, 1.0), (-1.0, 0.45)):  # the sky, and what the lake mirrors of it
    for curtain in (make_curtain(36.0, 0.2), make_curtain(55.0, 2.9)):
        for name, (_, _, color, emission) in LINES.items():
            mapper = vtkProjectedPolyhedraMapper()
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectScalarArray(name)
            light = scene.make_emission(((0.0, *color, 0.0), (1.0, *color, share * emission)))
            scene.add_volume(renderer, mapper, curtain, light).SetScale(1.0, 1.0, side)
    shore = vtkPlane()
    shore.SetNormal(0.0, 0.0, side)
    actor = terrain.make_actor(terrain.make_texture(heights, 120.0, NIGHT), ground)
    actor.GetMapper().AddClippingPlane(shore)
    actor.SetScale(0.006, 0.002, 0.0025 * side)
    actor.SetPosition(-23.0, 10.0, -2.1 * side)
    renderer.AddActor(actor)
scene.add_stars(renderer, 900, 200.0)
scene.set_sky(renderer, (0.005, 0.012, 0.022), (0.005, 0.008, 0.03))
scene.set_camera(renderer, (0.0, -2.0, 0.5), (0.0, 30.0, 3.2), 54.0)
window.Render()
print(scene.save(window, arguments.output))
