"""Meshes whose topology is known."""

import numpy as np


def tetrahedron():
    return (np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]),
            np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))


def sphere(levels):
    """An octahedron whose faces are split; no two axes are alike."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    points = [np.array(p, float) for p in points]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(levels):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                point = points[a] + points[b]
                middles[key] = len(points)
                points.append(point / np.linalg.norm(point))
            return middles[key]

        split = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = split
    return np.array(points) * [1, 1.25, 1.5], np.array(faces)


def torus_of_quads(n=16, m=8):
    """An n x m grid, bent."""
    u, v = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    points = np.stack([(2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    after_i, after_j = (i + 1) % n, (j + 1) % m
    return points, np.stack([m * i + j, m * after_i + j, m * after_i + after_j, m * i + after_j], axis=-1)


def prism(n):
    """A drum: two faces with n corners and n with four. Flat corners and offsets."""
    angle = 2 * np.pi * np.arange(n) / n
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(n)], axis=-1)
    points = np.concatenate([ring, ring + [0, 0, 1]])
    sides = [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    faces = [list(range(n))[::-1], list(range(n, 2 * n)), *sides]
    return points, np.concatenate(faces), np.cumsum([0, *map(len, faces)])


def edges(faces):
    """Each edge once, the lower point first."""
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    return np.unique(np.sort(sides, axis=1), axis=0)


def disks_of(faces, cut_edges):
    """The Euler characteristics of the parts into which a cut opens a surface, found without the library."""
    cut = set(map(tuple, cut_edges.tolist()))
    k = faces.shape[1]
    parent = list(range(faces.size + len(faces)))  # of corners, and of faces

    def find(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    sides, count = {}, {}
    for f, face in enumerate(faces.tolist()):
        for s in range(k):
            a, b = face[s], face[(s + 1) % k]
            sides.setdefault((min(a, b), max(a, b)), []).append((f, k * f + s, k * f + (s + 1) % k))
    opened_edges = []
    for edge, at_edge in sides.items():
        if len(at_edge) == 2 and edge not in cut:
            (f, a, b), (g, c, d) = at_edge
            for one, other in ((a, d), (b, c), (faces.size + f, faces.size + g)):
                parent[find(one)] = find(other)
            opened_edges.append(f)
        else:
            opened_edges += [side[0] for side in at_edge]
    for f in range(len(faces)):
        part = find(faces.size + f)
        count[part] = count.get(part, 0) + 1
    for f in opened_edges:
        count[find(faces.size + f)] -= 1
    for corner in {find(c) for c in range(faces.size)}:
        count[find(faces.size + corner // k)] += 1
    return sorted(count.values())
