"""What the examples share: arguments, the window, the camera, transfer functions, volumes, surfaces, the PNG."""

import argparse
import math
import pathlib
import random

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (makes the classes below concrete)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPiecewiseFunction, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter, vtkFeatureEdges
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume,
    vtkVolumeProperty, vtkWindowToImageFilter)

# Share of the scalar range, red, green, blue, opacity.
NODES = ((0.00, 0.15, 0.10, 0.75, 0.45), (0.12, 0.10, 0.45, 1.00, 0.22), (0.17, 0.25, 0.80, 0.85, 0.07),
         (0.26, 0.55, 0.95, 0.45, 0.30), (0.40, 1.00, 0.85, 0.20, 0.60), (0.60, 1.00, 0.40, 0.10, 1.60),
         (1.00, 0.85, 0.02, 0.05, 4.00))


ROOT = pathlib.Path(__file__).resolve().parents[1]


def make_parser(text, picture, size=(960, 640)):
    """An example's arguments: where its picture goes and how large it is."""
    parser = argparse.ArgumentParser(description=text.splitlines()[0])
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "build" / "demo" / picture)
    parser.add_argument("--size", type=int, nargs=2, default=size, metavar=("WIDTH", "HEIGHT"))
    return parser


def make_property(scalar_range, length, nodes=NODES):
    """Colours and opacities over the scalar range; opacities are per twentieth of the mesh."""
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for share, red, green, blue, alpha in nodes:
        scalar = scalar_range[0] + share * (scalar_range[1] - scalar_range[0])
        color.AddRGBPoint(scalar, red, green, blue)
        opacity.AddPoint(scalar, alpha)
    result = vtkVolumeProperty()
    result.SetColor(color)
    result.SetScalarOpacity(opacity)
    result.SetScalarOpacityUnitDistance(length / 20.0)
    result.SetInterpolationTypeToLinear()
    return result


def make_emission(nodes, unit=1.0):
    """Light of a gas: scalar, red, green, blue, emission; the emission is per unit of length."""
    return make_property((0.0, 1.0), 20.0 * unit, nodes)


def add_volume(renderer, mapper, grid, volume_property):
    volume = vtkVolume()
    mapper.SetInputData(grid)
    volume.SetMapper(mapper)
    volume.SetProperty(volume_property)
    renderer.AddVolume(volume)
    return volume


def add_surface(renderer, source, color):
    """An opaque actor of what the source gives."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)
    return actor


def add_stars(renderer, count, distance):
    """Points in the half space above the ground, dimmer ones more often."""
    sky = random.Random(1)
    for brightness in (0.25, 0.4, 0.6, 0.9):
        points, vertices, mapper, actor = vtkPoints(), vtkCellArray(), vtkPolyDataMapper(), vtkActor()
        for _ in range(int(count * (1.0 - brightness) ** 2)):
            direction = [sky.gauss(0.0, 1.0) for _ in range(3)]
            shift = distance / math.hypot(*direction)
            vertices.InsertNextCell(1, (points.InsertNextPoint(*(shift * abs(c) if axis == 2 else shift * c
                                                                for axis, c in enumerate(direction))),))
        stars = vtkPolyData()
        stars.SetPoints(points)
        stars.SetVerts(vertices)
        mapper.SetInputData(stars)
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(brightness, brightness, brightness)
        actor.GetProperty().LightingOff()
        renderer.AddActor(actor)


def add_fireplace(renderer):
    """Ground and logs, and the light that a fire among them throws on them."""
    light, ground, log = vtkLight(), vtkPlaneSource(), vtkCylinderSource()
    light.SetPositional(True)
    light.SetConeAngle(180.0)
    light.SetPosition(0.0, -0.4, 0.9)
    light.SetColor(1.0, 0.5, 0.18)
    light.SetAttenuationValues(0.7, 0.0, 0.35)
    renderer.AddLight(light)
    add_surface(renderer, ground, (0.5, 0.42, 0.33)).SetScale(60.0, 60.0, 1.0)
    log.SetRadius(0.12)
    log.SetHeight(2.4)
    log.SetResolution(24)
    for turn in (15.0, 75.0, 135.0):
        wood = add_surface(renderer, log, (0.45, 0.28, 0.16))
        wood.SetPosition(0.0, 0.0, 0.15 + 0.002 * turn)
        wood.RotateZ(turn)


def make_outline(grid):
    """The edges of the mesh's own boundary, curved where it is."""
    surface, edges = vtkDataSetSurfaceFilter(), vtkFeatureEdges()
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    surface.SetInputData(grid)
    edges.SetInputConnection(surface.GetOutputPort())
    edges.SetFeatureAngle(50.0)
    edges.ColoringOff()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.7, 0.75, 0.8)
    return actor


def add_cut(renderer, grid, origin, normal):
    """The cells in a plane, as lines."""
    plane, cutter, mapper, actor = vtkPlane(), vtkCutter(), vtkPolyDataMapper(), vtkActor()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.SetInputData(grid)
    mapper.SetInputConnection(cutter.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetRepresentationToWireframe()
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(0.35, 0.42, 0.5)
    renderer.AddActor(actor)


def make_window(width, height):
    window, renderer = vtkRenderWindow(), vtkRenderer()
    window.SetOffScreenRendering(1)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    renderer.SetBackground(0.05, 0.06, 0.09)
    return window, renderer


def set_camera(renderer, position, focal_point, view_angle=30.0):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focal_point)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(view_angle)
    renderer.ResetCameraClippingRange()


def set_sky(renderer, horizon, zenith):
    renderer.SetBackground(horizon)
    renderer.SetBackground2(zenith)
    renderer.GradientBackgroundOn()


def look_at(renderer, bounds, direction=(-0.9, 1.0, 0.55), zoom=1.3):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*direction)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera(bounds)
    camera.Zoom(zoom)


def save(window, path):
    """Writes the window to a PNG and returns its full path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    return path.resolve()
