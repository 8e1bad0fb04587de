"""A camp fire of 3,375 hexahedra: Perlin noise that rises through a flame; a film strip, or a file per frame.

    python3 06_camp_fire.py [-o picture.png] [--size WIDTH HEIGHT] [--frames N] [--sequence FOLDER]
"""

import pathlib

import meshes
import numpy
import scene
from vtkcellprojection import vtkProjectedPolyhedraMapper
from vtkmodules.vtkCommonDataModel import vtkPerlinNoise
from vtkmodules.vtkRenderingCore import vtkRenderer

parser = scene.make_parser(__doc__, "camp_fire.png", (1200, 480))
parser.add_argument("--frames", type=int, default=5)
parser.add_argument("--sequence", type=pathlib.Path, help="writes fire_000.png and so on there, one per frame")
arguments = parser.parse_args()

FLAME = ((0.0, 1.0, 0.15, 0.02, 0.0), (0.25, 1.0, 0.25, 0.03, 0.5), (0.6, 1.0, 0.45, 0.08, 1.6), (1.0, 1.0, 0.6, 0.2, 4.0))
side = numpy.linspace(-1.0, 1.0, 16)
z, y, x = numpy.meshgrid(2.6 * numpy.linspace(0.0, 1.0, 16), side, side, indexing="ij")
taper = 1.0 - 0.28 * z


def make_fire(time):
    noise = vtkPerlinNoise()
    noise.SetFrequency(1.5, 1.5, 1.1)
    noise.SetPhase(0.0, 0.0, -1.1 * time)
    turbulence = numpy.reshape([noise.EvaluateFunction(p) for p in zip(x.flat, y.flat, z.flat)], x.shape)
    distance = numpy.sqrt(x ** 2 + y ** 2) + (0.2 + 0.35 * z) * turbulence
    flame = (1.0 - (distance / 0.95) ** 2) * (1.0 - z / 2.6 + 0.55 * turbulence) * numpy.minimum(1.0, 0.3 + 3.0 * z)
    flame[:, [0, -1], :] = flame[:, :, [0, -1]] = flame[-1] = 0.0
    return meshes.make_hexahedra(taper * x, taper * y, z, temperature=numpy.clip(flame, 0.0, 1.0))


def make_scene(frame):
    renderer = vtkRenderer()
    scene.add_volume(renderer, vtkProjectedPolyhedraMapper(), make_fire(frame / 4.0), scene.make_emission(FLAME))
    scene.add_fireplace(renderer)
    scene.set_camera(renderer, (0.0, -8.0, 2.4), (0.0, 0.0, 1.15), 26.0)
    return renderer


window, first = scene.make_window(*arguments.size)
window.RemoveRenderer(first)
for i in range(arguments.frames):
    renderer = make_scene(i)
    window.AddRenderer(renderer)
    if arguments.sequence:
        window.Render()
        print(scene.save(window, arguments.sequence / f"fire_{i:03}.png"))
        window.RemoveRenderer(renderer)
    else:
        renderer.SetViewport(i / arguments.frames, 0.0, (i + 1) / arguments.frames, 1.0)
if not arguments.sequence:
    window.Render()
    print(scene.save(window, arguments.output))
