"""One mesh, four transfer functions: what ParaView calls "color map" and "opacity" is exact here.

    python3 02_choose_the_transfer_function.py [-o picture.png]
"""

import argparse
import pathlib

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("-o", "--output", default=meshes.ROOT / "build" / "demo" / "transfer_functions.png")
arguments = parser.parse_args()

structured, name = meshes.load()
append = vtkAppendFilter()
append.SetInputData(structured)
append.Update()
grid = append.GetOutput()
low, high = grid.GetScalarRange()

smooth = scene.make_property((low, high), grid.GetLength())
# Thin layers: each spike is drawn at its true width, however far apart the mesh's points are.
layers = ((0.13, 0.2, 0.5, 1.0), (0.25, 0.3, 0.9, 0.4), (0.4, 1.0, 0.8, 0.1), (0.6, 1.0, 0.2, 0.1))
spikes = [(center + offset, *rgb, alpha) for center, *rgb in layers
          for offset, alpha in ((-0.01, 0.0), (0.0, 4.0), (0.01, 0.0))]
spiky = scene.make_property((low, high), grid.GetLength(), spikes)

# ParaView's default colour space; it is refined until it is exact to 1e-4.
diverging = scene.make_property((low, high), grid.GetLength())
color = diverging.GetRGBTransferFunction()
color.RemoveAllPoints()
color.AddRGBPoint(low, 0.23, 0.30, 0.75)
color.AddRGBPoint(0.5 * high, 0.71, 0.02, 0.15)
color.SetColorSpaceToDiverging()

# Opacity is meant per unit distance: a quarter of it makes the same air four times as dense.
dense = scene.make_property((low, high), grid.GetLength())
dense.SetScalarOpacityUnitDistance(0.25 * dense.GetScalarOpacityUnitDistance())

window, first = scene.make_window(960, 640)
window.RemoveRenderer(first)
for i, volume_property in enumerate((smooth, spiky, diverging, dense)):
    mapper = vtkPreIntegratedTetrahedraMapper()
    mapper.SetInputData(grid)
    volume, renderer = vtkVolume(), vtkRenderer()
    volume.SetMapper(mapper)
    volume.SetProperty(volume_property)
    renderer.SetBackground(first.GetBackground())
    renderer.SetViewport(0.5 * (i % 2), 0.5 - 0.5 * (i // 2), 0.5 + 0.5 * (i % 2), 1.0 - 0.5 * (i // 2))
    renderer.AddVolume(volume)
    scene.look_at(renderer, grid.GetBounds())
    window.AddRenderer(renderer)
window.Render()
print(scene.save(window, pathlib.Path(arguments.output)))
