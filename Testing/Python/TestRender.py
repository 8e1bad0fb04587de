"""A mesh rendered from Python is within 1e-4 of the oracle, and the statistics add up."""

import sys

from vtkcellprojection import vtkCellProjectionOracle, vtkConvexCells, vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty)

points = vtkPoints()
scalars = vtkDoubleArray()
scalars.SetName("density")
for z in (0, 1):
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        points.InsertNextPoint(x, y, z)
        scalars.InsertNextValue(0.2 + 0.5 * x + 0.3 * y * z)
grid = vtkUnstructuredGrid()
grid.SetPoints(points)
grid.InsertNextCell(VTK_HEXAHEDRON, 8, tuple(range(8)))
grid.GetPointData().SetScalars(scalars)

color = vtkColorTransferFunction()
color.AddRGBPoint(0.2, 0.1, 0.3, 0.9)
color.AddRGBPoint(1.0, 0.9, 0.3, 0.1)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(0.2, 0.1)
opacity.AddPoint(1.0, 3.0)
volume_property = vtkVolumeProperty()
volume_property.SetColor(color)
volume_property.SetScalarOpacity(opacity)
volume_property.SetInterpolationTypeToLinear()

mapper = vtkPreIntegratedTetrahedraMapper()
mapper.SetInputData(grid)
mapper.CaptureImageOn()
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(volume_property)
renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(96, 96)
window.AddRenderer(renderer)
assert mapper.IsSupported(window)
window.Render()

row = mapper.GetLastStatistics()
columns = [row.GetColumnName(i) for i in range(row.GetNumberOfColumns())]
assert columns == [
    "Method", "Engine", "CellsIn", "CellsDrawn", "CellsSkippedTransparent", "CellsSkippedInvalid",
    "CellsSkippedOutside", "Cycles", "MisorderedFaces", "RepairedPixels", "SecondsPrepare",
    "SecondsSort", "SecondsProject", "SecondsBlend"], columns
assert row.GetNumberOfRows() == 1
assert row.GetValueByName(0, "Engine").ToString() in ("Raster", "Tiles")
assert row.GetValueByName(0, "CellsIn").ToInt() == 1
assert row.GetValueByName(0, "CellsDrawn").ToInt() == 6

cut = vtkConvexCells()
cut.SetInputData(grid)
cut.TetrahedraOnlyOn()
cut.Update()
oracle = vtkCellProjectionOracle()
oracle.SetInputData(cut.GetOutput())
oracle.SetVolume(volume)
oracle.SetCamera(renderer.GetActiveCamera())
oracle.SetSize(96, 96)
assert oracle.Update()
oracle.Compare(mapper.GetCapturedImage())
print("largest error", oracle.GetMaximumError(), "over", oracle.GetNumberOfCoveredPixels(), "pixels")
sys.exit(not (oracle.GetNumberOfCoveredPixels() > 1000 and oracle.GetMaximumError() < 1e-4))
