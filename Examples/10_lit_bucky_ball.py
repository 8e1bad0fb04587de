"""Opaque iso-surfaces inside single tetrahedra: ambient light alone, diffuse, with highlights; no surface is extracted.

    python3 10_lit_bucky_ball.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

arguments = scene.make_parser(__doc__, "lit_bucky_ball.png", (1200, 420)).parse_args()

# Share of the scalar range, colour, opacity: spikes so thin and high that each is a surface.
SURFACES = ((0.33, 0.2, 0.5, 1.0), (0.62, 1.0, 0.55, 0.1))
THICKNESS, OPACITY = 0.012, 400.0


def make_nodes():
    nodes = [(0.0, *SURFACES[0][1:], 0.0)]
    for share, *color in SURFACES:
        for step, opacity in ((-1.0, 0.0), (0.0, OPACITY), (1.0, 0.0)):
            nodes.append((share + step * THICKNESS, *color, opacity))
    return nodes + [(1.0, *SURFACES[-1][1:], 0.0)]


def draw(renderer, grid, ambient, diffuse, specular):
    mapper, light = vtkPreIntegratedTetrahedraMapper(), vtkLight()
    look = scene.make_property(grid.GetScalarRange(), grid.GetLength(), make_nodes())
    look.ShadeOn()
    look.SetAmbient(ambient)
    look.SetDiffuse(diffuse)
    look.SetSpecular(specular)
    look.SetSpecularPower(30.0)
    light.SetLightTypeToCameraLight()
    light.SetPosition(0.6, 0.8, 1.0)
    renderer.AddLight(light)
    scene.add_volume(renderer, mapper, grid, look)
    scene.look_at(renderer, grid.GetBounds(), (0.7, -1.0, 0.45), 1.6)


window, left = scene.make_window(*arguments.size)
structured, name = meshes.load_bucky_ball()
append = vtkAppendFilter()
append.SetInputData(structured)
append.Update()
for index, light in enumerate(((1.0, 0.0, 0.0), (0.25, 0.75, 0.0), (0.2, 0.6, 0.6))):
    renderer = left if index == 0 else vtkRenderer()
    renderer.SetBackground(left.GetBackground())
    renderer.SetViewport(index / 3.0, 0.0, (index + 1) / 3.0, 1.0)
    window.AddRenderer(renderer)
    draw(renderer, append.GetOutput(), *light)
window.Render()
print(name + ": ambient, diffuse, specular")
print(scene.save(window, arguments.output))
