"""Ground fog over a terrain in a scene, flights over it, and how much a picture changes from one frame to the next."""

import numpy
import scene
import terrain
from vtkcellprojection import vtkMaximumProjectionMapper, vtkProjectedPolyhedraMapper
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

# Height in metres, red, green, blue: meadows, woods, scree, snow.
GROUND = ((650.0, 0.20, 0.26, 0.12), (1000.0, 0.16, 0.24, 0.10), (1400.0, 0.25, 0.27, 0.15), (1800.0, 0.42, 0.36, 0.30),
          (2100.0, 0.55, 0.50, 0.46), (2300.0, 0.95, 0.96, 1.0), (3000.0, 1.0, 1.0, 1.0))
# Light of the fog per kilometre, and its colour and opacity where the greatest density decides.
EMISSION = ((0.0, 0.75, 0.82, 1.0, 0.0), (1.0, 0.75, 0.82, 1.0, 1.2))
MAXIMUM = ((0.0, 0.8, 0.85, 0.95, 0.0), (0.25, 0.8, 0.85, 0.95, 0.12), (1.0, 0.95, 0.96, 1.0, 0.85))


class FoggyScene:
    """The ground and its fog in a renderer. The fog shines, less the higher it is over the ground; or, as a maximum, its
    density is 0 at the bottom and goes with its thickness at the top."""

    def __init__(self, renderer, heights, spacing, level, depth, maximum=False):
        thickness = terrain.make_fog(heights, spacing, level, depth)
        self.terrain = terrain.Terrain(heights, thickness, spacing)
        self.renderer, self.depth, self.maximum = renderer, depth, maximum
        self.lengths = spacing * (numpy.array(heights.shape[::-1]) - 1.0)
        self.fog = vtkMaximumProjectionMapper() if maximum else vtkProjectedPolyhedraMapper()
        self.property = scene.make_emission(MAXIMUM) if maximum else scene.make_emission(EMISSION, 1000.0)
        self.ground = terrain.make_actor(terrain.make_texture(heights, spacing, GROUND))
        renderer.AddActor(self.ground)
        scene.add_volume(renderer, self.fog, vtkUnstructuredGrid(), self.property)
        scene.set_sky(renderer, (0.62, 0.70, 0.82), (0.16, 0.28, 0.52))

    def show(self, eye, focal_point, tolerance, morph=True, view_angle=40.0):
        """Looks from the eye, in metres, at a mesh made for it; gives the number of triangles."""
        mesh = self.terrain.make_mesh(eye, tolerance, morph)
        share = mesh.thickness / self.depth
        # Both are linear in the height over the ground, so that a prism and the prisms it is cut into hold the same fog.
        densities = (0.0, share) if self.maximum else (1.0, 1.0 - 0.8 * share)
        self.fog.SetInputData(terrain.make_prisms(mesh, *densities))
        self.ground.GetMapper().SetInputData(terrain.make_surface(mesh, self.lengths))
        scene.set_camera(self.renderer, eye, focal_point, view_angle)
        return len(mesh.triangles)


def grab(window, block):
    """The window's colours, each the mean of block x block pixels, so that an edge that moves a little changes a little."""
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    columns, rows, _ = image.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).astype(float)
    return pixels.reshape(rows // block, block, columns // block, block, 3).mean(axis=(1, 3))


class Flight:
    """Eyes on a straight line, all looking along the same direction, in metres: steeply down, so that no ridge hides another."""

    def __init__(self, foggy, tolerance, length, frames):
        width, depth = foggy.lengths
        self.foggy, self.tolerance = foggy, tolerance
        self.direction = numpy.array((0.0, 1.0, -2.0)) / numpy.sqrt(5.0)
        start = numpy.array((0.5 * width, 0.15 * depth, foggy.terrain.fields[0].max() + 1000.0))
        self.eyes = start + numpy.linspace(0.0, length, frames)[:, None] * self.direction

    def find_pops(self, count):
        """The steps, by their first frame, at which most would change in the middle of the view without geomorphing."""
        moved = []
        points = self.foggy.terrain.find_points(self.foggy.terrain.fields[0])
        depth = self.eyes[0][2] - points[2]
        in_view = (abs(points[0] - self.eyes[0][0]) < 0.4 * depth)
        in_view &= abs(points[1] - self.eyes[0][1] - 0.5 * depth) < 0.3 * depth
        before = None
        for eye in self.eyes:
            now = self.foggy.terrain.find_fields(eye, self.tolerance, morph=False)[1]
            if before is not None:
                moved.append((abs(now - before) * in_view).max())
            before = now
        return numpy.sort(numpy.argsort(moved)[::-1][:count])

    def largest_change(self, window, steps, tolerance, morph=True, block=4):
        """Over these steps the largest change of any colour of any pixel, of 255."""
        largest, last, before = 0.0, None, None
        for step in steps:
            for frame in (step, step + 1):
                if frame != last:
                    self.foggy.show(self.eyes[frame], self.eyes[frame] + self.direction, tolerance, morph)
                    window.Render()
                    before, now = (now if last is not None else None), grab(window, block)
                last = frame
            largest = max(largest, abs(now - before).max())
        return largest

    def compare(self, window, steps):
        """The largest change with geomorphing, without it, and with every point of the field in the mesh."""
        return [self.largest_change(window, steps, tolerance, morph)
                for tolerance, morph in ((self.tolerance, True), (self.tolerance, False), (0.0, True))]
