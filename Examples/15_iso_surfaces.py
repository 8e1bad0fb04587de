"""Iso-surfaces found in each pixel, lit, one translucent around an opaque one, and the scene's depth knows them.

    python3 15_iso_surfaces.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import numpy
import scene
from vtkcellprojection import vtkBarycentricShellMapper
from vtkmodules.vtkFiltersSources import vtkSphereSource

arguments = scene.make_parser(__doc__, "iso_surfaces.png").parse_args()
# Twisted, so that no image file could hold it.
z, y, x = numpy.mgrid[-1.0:1.0:29j, -1.0:1.0:29j, -1.0:1.0:29j]
density = meshes.make_bucky_ball(x, y, z)
grid = meshes.make_hexahedra(x * numpy.cos(0.4 * z) - y * numpy.sin(0.4 * z),
                             x * numpy.sin(0.4 * z) + y * numpy.cos(0.4 * z), z, density=density)

surfaces = scene.make_property((0.0, 255.0), 20.0)
surfaces.GetRGBTransferFunction().RemoveAllPoints()
surfaces.GetScalarOpacity().RemoveAllPoints()
for value, red, green, blue, opacity in ((70.0, 0.3, 0.6, 1.0, 0.35), (160.0, 1.0, 0.55, 0.15, 1.0)):
    surfaces.GetRGBTransferFunction().AddRGBPoint(value, red, green, blue)
    surfaces.GetScalarOpacity().AddPoint(value, opacity)
surfaces.GetIsoSurfaceValues().SetNumberOfContours(2)
surfaces.GetIsoSurfaceValues().SetValue(0, 70.0)
surfaces.GetIsoSurfaceValues().SetValue(1, 160.0)
surfaces.ShadeOn()
surfaces.SetDiffuse(0.9)
surfaces.SetSpecular(0.4)
surfaces.SetSpecularPower(30.0)

window, renderer = scene.make_window(*arguments.size)
mapper = vtkBarycentricShellMapper()
mapper.SetBlendModeToIsoSurface()
scene.add_volume(renderer, mapper, grid, surfaces)
ball = vtkSphereSource()
ball.SetRadius(0.42)
ball.SetThetaResolution(48)
ball.SetPhiResolution(32)
scene.add_surface(renderer, ball, (0.75, 0.75, 0.8))
scene.look_at(renderer, grid.GetBounds(), zoom=2.1)
window.Render()
print(scene.save(window, arguments.output))
