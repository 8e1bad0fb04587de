"""An image of 48 x 48 x 48 points warped through a mesh of 64 hexahedra: the mesh twists, its texture goes along.

    python3 16_warped_texture.py [-o picture.png] [--size WIDTH HEIGHT] [--twist DEGREES]
"""

import meshes
import numpy
import scene
from vtkcellprojection import vtkBarycentricShellMapper
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

parser = scene.make_parser(__doc__, "warped_texture.png")
parser.add_argument("--twist", type=float, default=80.0)
arguments = parser.parse_args()

z, y, x = numpy.mgrid[-1.0:1.0:48j, -1.0:1.0:48j, -1.0:1.0:48j]
image = vtkImageData()
image.SetDimensions(48, 48, 48)
density = numpy_to_vtk(meshes.make_bucky_ball(x, y, z).ravel(), deep=True)
density.SetName("density")
image.GetPointData().SetScalars(density)

z, y, x = numpy.mgrid[-1.0:1.0:5j, -1.0:1.0:5j, -1.0:1.0:5j]
angle = numpy.radians(arguments.twist) * (0.5 + 0.5 * z)
grid = meshes.make_hexahedra(x * numpy.cos(angle) - y * numpy.sin(angle), x * numpy.sin(angle) + y * numpy.cos(angle),
                             1.6 * z, rest=x)
# Where each point was: 0 and 1 are the image's first and last points.
coordinates = numpy_to_vtk(0.5 + 0.5 * numpy.stack((x, y, z), axis=-1).reshape(-1, 3), deep=True)
coordinates.SetName("place in the image")
grid.GetPointData().SetTCoords(coordinates)

NODES = ((0.0, 0.2, 0.3, 0.8, 0.0), (0.15, 0.1, 0.4, 1.0, 0.05), (0.45, 0.3, 0.9, 0.9, 1.5), (0.8, 1.0, 0.7, 0.2, 6.0),
         (1.0, 1.0, 0.3, 0.1, 12.0))
window, renderer = scene.make_window(*arguments.size)
mapper = vtkBarycentricShellMapper()
mapper.SetVolumeTexture(image)
scene.add_volume(renderer, mapper, grid, scene.make_property((0.0, 255.0), 8.0, NODES))
renderer.AddActor(scene.make_outline(grid))
scene.look_at(renderer, grid.GetBounds(), zoom=1.15)
window.Render()
print(scene.save(window, arguments.output))
