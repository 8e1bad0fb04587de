"""A rank for every cell, in two lines of Python."""

import vtkcellprojection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkCamera

source = vtkRTAnalyticSource()
source.SetWholeExtent(0, 5, 0, 5, 0, 5)
cells = vtkAppendFilter()
cells.SetInputConnection(source.GetOutputPort())
camera = vtkCamera()

order = vtkcellprojection.vtkVisibilityOrderFilter()
order.SetInputConnection(cells.GetOutputPort())
order.SetCamera(camera)


def ranks():
    order.Update()
    return vtk_to_numpy(order.GetOutput().GetCellData().GetArray("VisibilityOrder")).copy()


# Seen along the first axis, the layers of the lattice come in its order.
for sign in (1, -1):
    camera.SetFocalPoint(2.5, 2.5, 2.5)
    camera.SetPosition(2.5 + 50 * sign, 2.5, 2.5)
    found = ranks()
    assert sorted(found) == list(range(125)), found
    lattice = found.reshape(5, 5, 5)
    steps = lattice[:, :, 1:] - lattice[:, :, :-1]
    assert (sign * steps > 0).all(), steps
    assert order.IsOrderProven() and order.GetNumberOfMisorderedFaces() == 0

assert order.GetSortMethodUsed() in ("Power", "MPVO")
order.SetSortMethodToCellCenter()
assert sorted(ranks()) == list(range(125)) and order.GetSortMethodUsed() == "CellCenter"
