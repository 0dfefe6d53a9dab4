"""Unwraps the triangles of an OFF file and draws the surface with its cut, and its layout.

usage: unwrap_and_draw.py MESH.off PICTURE.png
"""

import sys

import matplotlib
import numpy as np

import surface_mesh_cutting

matplotlib.use("Agg")  # no window
from matplotlib import pyplot  # noqa: E402


def read_off(path):
    """Points, of which the second coordinate leads upward in the file, and triangles."""
    with open(path, encoding="ascii") as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    number_of_points, number_of_faces = map(int, words[1:3])
    numbers = np.array(words[4:4 + 3 * number_of_points + 4 * number_of_faces], float)
    points, faces = np.split(numbers, [3 * number_of_points])
    return points.reshape(-1, 3)[:, [2, 0, 1]], faces.reshape(-1, 4)[:, 1:].astype(int)


points, faces = read_off(sys.argv[1])
result = surface_mesh_cutting.unwrap(points, faces, effort="fast")
print(f"cut of {result.cut_length / result.bounding_box_diagonal:.2f} bounding box diagonals, "
      f"mean energy {result.average_distortion:.3f} (4: no distortion)")

# How much larger each triangle is in the layout than on the surface, at the layout's scale.
sides = np.diff(points[faces], axis=1)
normals = np.cross(sides[:, 0], sides[:, 1])
areas = np.linalg.norm(normals, axis=1) * result.uv_scale**2
(a, b), (c, d) = np.moveaxis(np.diff(result.corner_uv, axis=1), 0, -1)
stretch = np.log2((a * d - b * c) / np.maximum(areas, 1e-300)).clip(-1, 1)
colors = pyplot.get_cmap("coolwarm")((stretch + 1) / 2)

figure = pyplot.figure(figsize=(9, 4.2))
space = figure.add_subplot(1, 2, 1, projection="3d", computed_zorder=False)
surface = space.plot_trisurf(*points.T, triangles=faces, linewidth=0)
surface.set_facecolor(colors)
space.set_box_aspect(np.ptp(points, axis=0), zoom=1.25)
space.view_init(elev=15, azim=20)
height, side = np.radians([space.elev, space.azim])
to_viewer = [np.cos(height) * np.cos(side), np.cos(height) * np.sin(side), np.sin(height)]
point_normals = np.zeros_like(points)
np.add.at(point_normals, faces, normals[:, None])
for edge in result.cut_edges:  # matplotlib does not hide what lies behind
    if point_normals[edge].sum(axis=0) @ to_viewer > 0:
        space.plot(*points[edge].T, color="black", linewidth=1.2)
space.set_axis_off()

plane = figure.add_subplot(1, 2, 2)
plane.tripcolor(*result.uv.T, result.uv_faces, facecolors=stretch, cmap="coolwarm", vmin=-1, vmax=1)
plane.set_aspect("equal")
plane.set_xlim(0, 1)
plane.set_ylim(0, 1)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=90)
