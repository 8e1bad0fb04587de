"""The blocks of an Exodus file go into the mapper as they are: one volume with one order.

    python3 18_exodus_blocks.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import meshes
import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkCommonDataModel import vtkBoundingBox

arguments = scene.make_parser(__doc__, "exodus_blocks.png", (960, 720)).parse_args()
NODES = ((0.0, 0.1, 0.2, 0.9, 0.1), (0.3, 0.2, 0.7, 0.9, 0.15), (0.6, 0.9, 0.8, 0.3, 0.5), (1.0, 1.0, 0.3, 0.1, 2.0))

data, scalar, name = meshes.load_blocks()
blocks, box, ranges = [], vtkBoundingBox(), []
iterator = data.NewIterator()
while not iterator.IsDoneWithTraversal():
    block = iterator.GetCurrentDataObject()
    blocks.append(block)
    box.AddBounds(block.GetBounds())
    ranges.append(block.GetPointData().GetArray(scalar).GetRange())
    print(f"{name}: block {len(blocks)} of {block.GetNumberOfCells()} cells, {scalar} from %g to %g" % ranges[-1])
    iterator.GoToNextItem()

(window, renderer), mapper = scene.make_window(*arguments.size), vtkPreIntegratedTetrahedraMapper()
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectScalarArray(scalar)
whole = min(low for low, high in ranges), max(high for low, high in ranges)
scene.add_volume(renderer, mapper, data, scene.make_property(whole, box.GetDiagonalLength(), NODES))
bounds = mapper.GetBounds()
for block in blocks:
    renderer.AddActor(scene.make_outline(block))
scene.look_at(renderer, bounds, (-0.6, -1.0, 0.6), 1.0)
window.Render()
print(scene.save(window, arguments.output))
