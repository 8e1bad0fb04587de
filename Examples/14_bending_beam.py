"""A beam that swings in its second bending mode, its stress as colour: each frame sends moved points and stress alone.

    python3 14_bending_beam.py [-o picture.png] [--size WIDTH HEIGHT] [--frames N] [--sequence FOLDER]
"""

import pathlib

import meshes
import numpy
import scene
from vtkcellprojection import vtkBarycentricShellMapper
from vtkmodules.util.numpy_support import vtk_to_numpy

parser = scene.make_parser(__doc__, "bending_beam.png", (960, 540))
parser.add_argument("--frames", type=int, default=3)
parser.add_argument("--sequence", type=pathlib.Path, help="writes beam_000.png and so on there, one per frame")
arguments = parser.parse_args()

# Compressed blue, free of stress almost clear, stretched red.
STRESS = ((0.0, 0.1, 0.3, 1.0, 8.0), (0.4, 0.4, 0.7, 1.0, 0.8), (0.5, 0.8, 0.8, 0.8, 0.3), (0.6, 1.0, 0.8, 0.4, 0.8),
          (1.0, 1.0, 0.15, 0.05, 8.0))
K = 4.694091  # the second root of cosh K cos K = -1: a beam of length 1, clamped at x = 0

z, y, x = numpy.meshgrid(numpy.linspace(-0.06, 0.06, 7), numpy.linspace(-0.1, 0.1, 7), numpy.linspace(0.0, 1.0, 41),
                         indexing="ij")
grid = meshes.make_hexahedra(x, y, z, stress=0.0 * x)
points, stress = grid.GetPoints().GetData(), grid.GetPointData().GetArray("stress")
rest = vtk_to_numpy(points).copy()
along, height = rest[:, 0], rest[:, 2]
SHARE = (numpy.cosh(K) + numpy.cos(K)) / (numpy.sinh(K) + numpy.sin(K))


def combine(even, odd):
    """cosh + even cos - SHARE (sinh + odd sin), of K x."""
    u = K * along
    return numpy.cosh(u) + even * numpy.cos(u) - SHARE * (numpy.sinh(u) + odd * numpy.sin(u))


def swing(amplitude):
    """The mode's deflection, the turn of the cross-sections with its slope, the stress with its curvature."""
    slope = K * (numpy.sinh(K * along) + numpy.sin(K * along) - SHARE * (numpy.cosh(K * along) - numpy.cos(K * along)))
    moved = vtk_to_numpy(points)
    moved[:, 2] = height + amplitude * combine(-1.0, -1.0)
    moved[:, 0] = along - amplitude * height * slope
    vtk_to_numpy(stress)[:] = 0.5 - 0.5 * amplitude / 0.1 * combine(1.0, 1.0) * height / 0.06 / 2.0
    points.Modified()
    stress.Modified()


window, renderer = scene.make_window(*arguments.size)
mapper = vtkBarycentricShellMapper()
scene.add_volume(renderer, mapper, grid, scene.make_emission(STRESS, 0.1))
scene.set_camera(renderer, (0.9, -2.3, 0.8), (0.53, 0.0, 0.0), 19.0)
for i in range(arguments.frames):
    swing(0.1 * numpy.cos(2.0 * numpy.pi * (i + 1) / arguments.frames))
    window.Render()
    if arguments.sequence:
        print(scene.save(window, arguments.sequence / f"beam_{i:03}.png"))
print(scene.save(window, arguments.output))
