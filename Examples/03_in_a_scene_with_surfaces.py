"""A volume among surfaces: hidden by them pixel for pixel, and cut by a clipping plane.

    python3 03_in_a_scene_with_surfaces.py [-o picture.png]
"""

import argparse
import pathlib

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeometry import vtkStructuredGridGeometryFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkVolume

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("-o", "--output", default=meshes.ROOT / "build" / "demo" / "surfaces.png")
arguments = parser.parse_args()

structured, name = meshes.load()
append = vtkAppendFilter()
append.SetInputData(structured)
append.Update()
grid = append.GetOutput()

mapper = vtkPreIntegratedTetrahedraMapper()
mapper.SetInputData(grid)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(scene.make_property(grid.GetScalarRange(), grid.GetLength()))

# Only what lies behind this plane is drawn; up to six planes may clip.
plane = vtkPlane()
plane.SetOrigin(grid.GetCenter())
plane.SetNormal(0.0, 0.0, -1.0)
mapper.AddClippingPlane(plane)

window, renderer = scene.make_window(960, 640)
renderer.AddVolume(volume)
renderer.AddActor(scene.make_outline(grid))

# A sheet of the grid as an opaque surface: the volume ends where a ray meets it.
sheet = vtkStructuredGridGeometryFilter()
sheet.SetInputData(structured)
sheet.SetExtent(0, 39, 6, 6, 0, 31)
surface = vtkPolyDataMapper()
surface.SetInputConnection(sheet.GetOutputPort())
surface.ScalarVisibilityOff()
actor = vtkActor()
actor.SetMapper(surface)
actor.GetProperty().SetColor(0.85, 0.82, 0.75)
renderer.AddActor(actor)

scene.look_at(renderer, grid.GetBounds())
window.Render()
print(scene.save(window, pathlib.Path(arguments.output)))
