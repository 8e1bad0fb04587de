"""Ground fog does not pop: no pixel changes more than at full resolution where a mesh without geomorphing jumps.

Measured on these steps, of 255: emission 0.8 with geomorphing, 24.4 without, 2.4 at full resolution; maximum 0.7, 28.3, 1.0.
"""

import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples"))

import flight  # noqa: E402
import scene  # noqa: E402
import terrain  # noqa: E402


def check_mesh(foggy, eye, tolerance):
    """Every edge is shared by two triangles, save those on the rectangle's sides; the triangles fill it, all upwards."""
    mesh = foggy.terrain.make_mesh(eye, tolerance)
    edges = numpy.sort(numpy.concatenate([mesh.triangles[:, pair] for pair in ((0, 1), (1, 2), (2, 0))]), axis=1)
    edges, uses = numpy.unique(edges, axis=0, return_counts=True)
    ends = mesh.points[edges[uses == 1]][:, :, :2]
    on_side = ((ends[:, 0] == ends[:, 1]) & ((ends[:, 0] == 0.0) | (ends[:, 0] == foggy.lengths))).any(axis=1)
    a, b, c = (mesh.points[mesh.triangles[:, corner], :2] for corner in range(3))
    (x1, y1), (x2, y2) = (b - a).T, (c - a).T
    areas = 0.5 * (x1 * y2 - x2 * y1)
    print(len(mesh.triangles), "triangles,", (~on_side).sum(), "cracks")
    assert uses.max() == 2 and on_side.all() and areas.min() > 0.0
    assert abs(areas.sum() / foggy.lengths.prod() - 1.0) < 1e-12
    return len(mesh.triangles)


heights = terrain.make_heights()
for maximum in (False, True):
    window, renderer = scene.make_window(480, 360)
    foggy = flight.FoggyScene(renderer, heights, 60.0, numpy.percentile(heights, 40.0), 220.0, maximum)
    path = flight.Flight(foggy, 0.02, 200.0, 401)
    counts = [check_mesh(foggy, path.eyes[0], tolerance) for tolerance in (0.0, 0.003, 0.02)]
    assert counts[0] == 2 * 128 * 128 > 2 * counts[1] > 4 * counts[2], counts

    morphed, popped, full = path.compare(window, path.find_pops(6))
    print(f"largest change of 255: {morphed:.2f} with geomorphing, {popped:.2f} without, {full:.2f} at full resolution")
    assert popped > 10.0, "nothing pops: the test looks at the wrong steps"
    assert morphed <= 0.1 * popped and morphed <= 2.0 * full
