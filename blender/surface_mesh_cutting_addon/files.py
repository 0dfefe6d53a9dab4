# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that the program `unwrap` reads and writes."""

import numpy as np


def write_ply(path, surface):
    """Binary, with faces of any size. The sizes are as wide as the indices, so that all faces are one array."""
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(surface.points)}\n"
              "property double x\nproperty double y\nproperty double z\n"
              f"element face {len(surface.face_sizes)}\nproperty list int int vertex_indices\nend_header\n")
    firsts = np.cumsum(surface.face_sizes) - surface.face_sizes
    faces = np.insert(surface.corner_vertices, firsts, surface.face_sizes)
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(surface.points.astype("<f8").tobytes())
        file.write(faces.astype("<i4").tobytes())


def write_edges(path, edge_vertices):
    """A selection of edges, as CGAL's .selection.txt."""
    with open(path, "w", encoding="ascii") as file:
        file.write("\n\n" + " ".join(map(str, edge_vertices.ravel().tolist())) + "\n")


def write_edge_factors(path, edge_vertices, factor):
    """The same factor for the cost of each of these edges."""
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"{a} {b} {factor}\n" for a, b in edge_vertices.tolist())


def write_vertex_factors(path, factors):
    """A factor for each vertex."""
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"{factor}\n" for factor in factors.tolist())


def read_obj(path):
    """The texture points (n x 2), and for each corner the index of its point in the file and of its texture point."""
    points, faces = [], []
    with open(path, "rb") as file:
        for line in file:
            if line.startswith(b"vt "):
                points.append(line[3:])
            elif line.startswith(b"f "):
                faces.append(line[2:])
    texture_points = np.array(b" ".join(points).split(), np.float64).reshape(-1, 2)
    corners = np.array(b" ".join(faces).replace(b"/", b" ").split(), np.int64).reshape(-1, 2) - 1
    return texture_points, corners[:, 0], corners[:, 1]
