"""Renders a mesh to a PNG: a .vtu, or with no argument NASA's Blunt Fin.

    python3 01_render_a_file.py [mesh.vtu] [-o picture.png]
"""

import argparse
import pathlib

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkVolume

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("mesh", nargs="?")
parser.add_argument("-o", "--output")
arguments = parser.parse_args()

name = "mesh"
if arguments.mesh:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(arguments.mesh)
    reader.Update()
    grid = reader.GetOutput()
else:
    # Structured data becomes an unstructured grid of hexahedra through vtkAppendFilter.
    structured, name = meshes.load()
    append = vtkAppendFilter()
    append.SetInputData(structured)
    append.Update()
    grid = append.GetOutput()
    print(f"{name}: {grid.GetNumberOfCells()} hexahedra")

mapper = vtkPreIntegratedTetrahedraMapper()
mapper.SetInputData(grid)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(scene.make_property(grid.GetScalarRange(), grid.GetLength()))

window, renderer = scene.make_window(960, 640)
renderer.AddVolume(volume)
renderer.AddActor(scene.make_outline(grid))
scene.look_at(renderer, grid.GetBounds())
window.Render()

row = mapper.GetLastStatistics()
print(f"{row.GetValueByName(0, 'CellsDrawn').ToInt()} tetrahedra drawn")
default = meshes.ROOT / "build" / "demo" / (name.lower().replace(" ", "_") + ".png")
print(scene.save(window, pathlib.Path(arguments.output or default)))
