"""A height field under fog, at a level of detail that changes continuously with the eye.

Roettger et al., "Real-time generation of continuous levels of detail for height fields", 1998. The field has
(a s + 1) x (b s + 1) points, s a power of two: a x b quadtrees whose nodes are squares of s, s/2 .. 2 intervals. A node is
a fan around its centre. It exists where its error, seen from the eye, is above a tolerance, and where a smaller node needs
it: neighbours differ by one level at most, so no edge has a crack. Its centre and the middles of its edges move from where
the coarser mesh has them (blend 0, when the node appears) to their own heights (blend 1, at half that distance); the middle
of an edge takes the smaller blend of its two nodes. So the surface, and all that is stacked on it, is a continuous
function of the eye: nothing pops. The levels are kept as arrays, the finest first.
"""

import collections

import meshes
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_WEDGE, vtkCellArray, vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkDEMReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTexture

# Points (n, 3), thickness of the fog over each, triangles (m, 3), counterclockwise from above.
Mesh = collections.namedtuple("Mesh", "points thickness triangles")


def corners(values, size):
    """The four corners of each node, [row, column]: lower left, lower right, upper left, upper right."""
    lattice = values[..., ::size, ::size]
    return lattice[..., :-1, :-1], lattice[..., :-1, 1:], lattice[..., 1:, :-1], lattice[..., 1:, 1:]


def middle_of_diagonal(values, size):
    """What the coarser mesh has at each node's centre: its fan's edge there runs from centre to corner."""
    a, b, c, d = corners(values, size)
    j, i = numpy.indices(a.shape[-2:])
    return numpy.where((i + j) % 2 == 0, 0.5 * (a + d), 0.5 * (b + c))


def middle_of_edges(values, size):
    """The same in the middles of the edges along x and along y."""
    lattice = values[..., ::size, ::size]
    return 0.5 * (lattice[..., :-1] + lattice[..., 1:]), 0.5 * (lattice[..., :-1, :] + lattice[..., 1:, :])


def smaller_of_neighbours(nodes):
    """For the edges along x and along y, the smaller value of the nodes on both sides."""
    x_edges, y_edges = (numpy.pad(nodes, pad, constant_values=1) for pad in (((1, 1), (0, 0)), ((0, 0), (1, 1))))
    return numpy.minimum(x_edges[:-1], x_edges[1:]), numpy.minimum(y_edges[:, :-1], y_edges[:, 1:])


class Terrain:
    def __init__(self, heights, thickness, spacing, root=64):
        self.fields = numpy.array((heights, thickness), dtype=float)
        self.spacing = spacing
        self.sizes = [2 ** n for n in range(1, root.bit_length())]
        assert all((extent - 1) % root == 0 for extent in heights.shape)
        self.errors = []
        for size in self.sizes:
            self.errors.append(self.find_errors(size))

    def find_errors(self, size):
        """The largest distance between the field and a mesh that has no node of this size or smaller."""
        half = size // 2
        error = abs(self.fields[:, half::size, half::size] - middle_of_diagonal(self.fields, size)).max(axis=0)
        x_edges, y_edges = middle_of_edges(self.fields, size)
        x_error = abs(self.fields[:, ::size, half::size] - x_edges).max(axis=0)
        y_error = abs(self.fields[:, half::size, ::size] - y_edges).max(axis=0)
        for neighbour in (x_error[:-1], x_error[1:], y_error[:, :-1], y_error[:, 1:]):
            error = numpy.maximum(error, neighbour)
        if self.errors:
            finer = self.errors[-1]
            for j, i in ((0, 0), (0, 1), (1, 0), (1, 1)):
                error = numpy.maximum(error, finer[j::2, i::2])
        return error

    def find_blends(self, eye, tolerance, morph=True):
        """For each level which nodes exist and how far each has moved to its own heights."""
        existing, blends = [], []
        for size, error in zip(self.sizes, self.errors):
            x, y, z = self.find_points(self.fields[0])[:, size // 2::size, size // 2::size]
            distance = numpy.sqrt((x - eye[0]) ** 2 + (y - eye[1]) ** 2 + (z - eye[2]) ** 2)
            blend = numpy.clip(2.0 - 2.0 * tolerance * distance / numpy.maximum(error, 1e-9), 0.0, 1.0)
            exists = blend > 0.0
            if existing:
                require_neighbours(existing[-1], exists)
            existing.append(exists)
            blends.append(blend if morph else exists.astype(float))
        existing[-1][:] = True
        blends[-1][:] = 1.0
        return existing, blends

    def find_points(self, heights):
        j, i = numpy.indices(heights.shape)
        return numpy.array((self.spacing * i, self.spacing * j, heights))

    def move(self, blends):
        """The fields with each vertex between the coarser mesh and its own value, from the largest nodes down."""
        fields = self.fields.copy()
        for size, blend in reversed(list(zip(self.sizes, blends))):
            half = size // 2
            x_blend, y_blend = smaller_of_neighbours(blend)
            x_edges, y_edges = middle_of_edges(fields, size)
            for blend_here, coarse, here in (
                    (blend, middle_of_diagonal(fields, size), fields[:, half::size, half::size]),
                    (x_blend, x_edges, fields[:, ::size, half::size]),
                    (y_blend, y_edges, fields[:, half::size, ::size])):
                here[:] = coarse + blend_here * (here - coarse)
        return fields

    def triangulate(self, existing):
        """Fans of all nodes but their quarters where a smaller node is; an edge is halved if both its nodes are there."""
        triangles = []
        columns = self.fields.shape[2]
        for level, (size, exists) in enumerate(zip(self.sizes, existing)):
            half = size // 2
            smaller = existing[level - 1] if level else numpy.zeros([2 * n for n in exists.shape], dtype=bool)
            x_halved, y_halved = smaller_of_neighbours(exists)
            j, i = numpy.nonzero(exists)
            centre = (size * j + half) * columns + size * i + half
            # Corners counterclockwise, as steps from the centre, and whether the edge to the next one is halved.
            turns = ((-1, -1), (-1, 1), (1, 1), (1, -1))
            halved = (x_halved[j, i], y_halved[j, i + 1], x_halved[j + 1, i], y_halved[j, i])
            for turn, cut in enumerate(halved):
                (y0, x0), (y1, x1) = turns[turn], turns[(turn + 1) % 4]
                first, last = (centre + half * (y * columns + x) for y, x in ((y0, x0), (y1, x1)))
                middle = (first + last) // 2
                first_open, last_open = (~smaller[2 * j + (y > 0), 2 * i + (x > 0)] for y, x in ((y0, x0), (y1, x1)))
                for keep, a, b in ((~cut, first, last), (cut & first_open, first, middle), (cut & last_open, middle, last)):
                    triangles.append(numpy.stack((centre, a, b), axis=1)[keep])
        return numpy.concatenate(triangles)

    def find_fields(self, eye, tolerance, morph=True):
        """Which nodes exist, and the heights and thicknesses of the mesh at every point of the field that is its vertex."""
        existing, blends = self.find_blends(eye, tolerance, morph)
        return existing, self.move(blends)

    def make_mesh(self, eye, tolerance, morph=True):
        """The mesh for this eye; the tolerance is an angle, 0 gives every point of the field."""
        existing, (heights, thickness) = self.find_fields(eye, tolerance, morph)
        used, triangles = numpy.unique(self.triangulate(existing), return_inverse=True)
        points = self.find_points(heights).reshape(3, -1).T[used]
        return Mesh(points, thickness.ravel()[used], triangles.reshape(-1, 3))


def require_neighbours(children, parents):
    """A node needs its parent and the two neighbours of the parent that its quarter touches."""
    left, right = (children[:, side::2].reshape(len(parents), 2, -1).any(axis=1) for side in (0, 1))
    lower, upper = (children[side::2].reshape(len(parents), -1, 2).any(axis=2) for side in (0, 1))
    parents |= left | right
    parents[:, :-1] |= left[:, 1:]
    parents[:, 1:] |= right[:, :-1]
    parents[:-1] |= lower[1:]
    parents[1:] |= upper[:-1]


def make_points(points):
    result = vtkPoints()
    result.SetDataTypeToDouble()
    result.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    return result


def make_cells(ids):
    cells = vtkCellArray()
    offsets = numpy.arange(0, ids.size + 1, ids.shape[1])
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    return cells


def make_surface(mesh, lengths):
    """The ground; its texture spans the lengths along x and y."""
    surface = vtkPolyData()
    surface.SetPoints(make_points(mesh.points))
    surface.SetPolys(make_cells(mesh.triangles))
    surface.GetPointData().SetTCoords(numpy_to_vtk(mesh.points[:, :2] / lengths, deep=True))
    return surface


def make_prisms(mesh, bottom, top):
    """A wedge over each triangle that has fog; bottom and top are the scalars there, numbers or one per point."""
    foggy = mesh.triangles[(mesh.thickness[mesh.triangles] > 0.0).any(axis=1)]
    used, base = numpy.unique(foggy, return_inverse=True)
    # VTK's order: the first triangle looks away from the second.
    base = base.reshape(-1, 3)[:, ::-1]
    lower = mesh.points[used]
    upper = lower + mesh.thickness[used, None] * (0.0, 0.0, 1.0)
    scalars = [numpy.broadcast_to(value, len(mesh.points))[used] for value in (bottom, top)]
    prisms = vtkUnstructuredGrid()
    prisms.SetPoints(make_points(numpy.concatenate((lower, upper))))
    prisms.SetCells(VTK_WEDGE, make_cells(numpy.concatenate((base, base + len(used)), axis=1)))
    density = numpy_to_vtk(numpy.concatenate(scalars), deep=True)
    density.SetName("density")
    prisms.GetPointData().SetScalars(density)
    return prisms


def make_texture(heights, spacing, colors, sun=(-0.6, -0.35, 0.72)):
    """The ground's colours, by height, lit by the sun: seen through any mesh they are the same. Colours: rows of height, r, g, b."""
    slope_y, slope_x = numpy.gradient(heights, spacing)
    light = (sun[2] - slope_x * sun[0] - slope_y * sun[1]) / numpy.sqrt(1.0 + slope_x ** 2 + slope_y ** 2)
    light = 0.25 + 0.75 * numpy.clip(light, 0.0, 1.0)
    nodes = numpy.array(colors)
    texels = [255.0 * light * numpy.interp(heights, nodes[:, 0], nodes[:, channel]) for channel in (1, 2, 3)]
    image, texture = vtkImageData(), vtkTexture()
    image.SetDimensions(*heights.shape[::-1], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(numpy.stack(texels, axis=-1).reshape(-1, 3).clip(0, 255).astype(numpy.uint8), deep=True))
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    # Software OpenGL takes seconds for more.
    texture.SetMaximumAnisotropicFiltering(1)
    return texture


def make_actor(texture, surface=None):
    """The ground as its texture is, in no other light."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    if surface:
        mapper.SetInputData(surface)
    actor.SetMapper(mapper)
    actor.SetTexture(texture)
    actor.GetProperty().LightingOff()
    return actor


def make_heights(count=129, spacing=60.0):
    """Mountains from Perlin noise, in metres: count x count points."""
    j, i = numpy.indices((count, count)) * (spacing / 7700.0)
    valleys = abs(meshes.make_noise(i + 0.23, j + 0.41, 0.5, 1.7, 5))
    return 700.0 + 1500.0 * valleys * (0.6 + 0.8 * numpy.clip(meshes.make_noise(i, j, 2.5, 2.0) + 0.4, 0.0, 1.0))


def load_heights():
    """Mount St. Helens in metres and the distance of its points, else generated mountains."""
    path = meshes.find_data("SainteHelens.dem")
    if not path:
        print("SainteHelens.dem is not here: this is a generated terrain.")
        return make_heights(), 60.0
    reader = vtkDEMReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    heights = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns)
    # The largest part that is whole quadtrees of 64 intervals.
    return heights[:(rows - 1) // 64 * 64 + 1, :(columns - 1) // 64 * 64 + 1].astype(float), image.GetSpacing()[0]


def make_fog(heights, spacing, level, depth):
    """A map of the fog's thickness: it fills what lies below the level, up to the depth, with the noise of its top."""
    j, i = numpy.indices(heights.shape) * (spacing / 2000.0)
    noise = meshes.make_noise(i, j, 0.3, 1.0, 3)
    fill = numpy.clip((level + 0.35 * depth * noise - heights) / depth, 0.0, 1.0)
    return depth * fill * (2.0 - fill) * (0.6 + 0.5 * noise).clip(0.1, 1.0)
