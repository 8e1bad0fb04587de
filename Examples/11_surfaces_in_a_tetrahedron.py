"""Three iso-surfaces in each of seven tetrahedra: opaque; half transparent by table, one sample a segment; then four.

    python3 11_surfaces_in_a_tetrahedron.py [-o picture.png] [--size WIDTH HEIGHT]
"""

import scene
from vtkcellprojection import vtkPreIntegratedTetrahedraMapper
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

arguments = scene.make_parser(__doc__, "surfaces_in_a_tetrahedron.png", (1200, 420)).parse_args()

# Share of the scalar range and colour of each surface.
SURFACES = ((0.4, 1.0, 0.75, 0.15), (0.66, 0.9, 0.25, 0.2), (0.92, 0.2, 0.5, 1.0))


def make_octahedron():
    """An octahedron about its middle, where the scalar is 0, without the part in front."""
    points, scalars, grid = vtkPoints(), vtkFloatArray(), vtkUnstructuredGrid()
    for axis in range(7):
        points.InsertNextPoint(*((1.0 if axis % 2 else -1.0) if axis and (axis - 1) // 2 == i else 0.0 for i in range(3)))
        scalars.InsertNextValue(1.0 if axis else 0.0)
    grid.SetPoints(points)
    grid.GetPointData().SetScalars(scalars)
    for x, y, z in ((x, y, z) for x in (1, 2) for y in (3, 4) for z in (5, 6)):
        if (x, y, z) != (1, 4, 5):
            grid.InsertNextCell(VTK_TETRA, 4, (0, x, y, z))
    return grid


def make_nodes(thickness, opacity):
    nodes = [(0.0, *SURFACES[0][1:], 0.0)]
    for share, *color in SURFACES:
        nodes += [(share + step * thickness, *color, opacity * (1 - abs(step))) for step in (-1, 0, 1)]
    return nodes


window, left = scene.make_window(*arguments.size)
for index, (thickness, opacity, samples) in enumerate(((0.012, 400.0, 0), (0.12, 3.0, 1), (0.12, 3.0, 4))):
    renderer, mapper, light = left if index == 0 else vtkRenderer(), vtkPreIntegratedTetrahedraMapper(), vtkLight()
    if samples:
        mapper.SetIntegrationToTable()
        mapper.SetSamplesPerSegment(samples)
    grid = make_octahedron()
    look = scene.make_property((0.0, 1.0), grid.GetLength(), make_nodes(thickness, opacity))
    look.ShadeOn()
    look.SetAmbient(0.25)
    look.SetSpecular(0.7)
    light.SetLightTypeToCameraLight()
    light.SetPosition(0.5, 0.4, 1.0)
    renderer.SetBackground(left.GetBackground())
    renderer.SetViewport(index / 3.0, 0.0, (index + 1) / 3.0, 1.0)
    renderer.AddLight(light)
    window.AddRenderer(renderer)
    scene.add_volume(renderer, mapper, grid, look)
    scene.look_at(renderer, grid.GetBounds(), (1.0, -0.6, 0.35), 1.9)
window.Render()
print(scene.save(window, arguments.output))
