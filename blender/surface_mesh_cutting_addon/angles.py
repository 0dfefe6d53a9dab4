# SPDX-License-Identifier: GPL-3.0-or-later
"""Angles between faces."""

import numpy as np


def _normals(surface):
    """Of the faces, by the area vector of each polygon; NaN where it has none."""
    firsts = np.cumsum(surface.face_sizes) - surface.face_sizes
    starts, ends = surface.corner_vertices, surface.corner_vertices[surface.next_corners()]
    origins = np.repeat(surface.points[surface.corner_vertices[firsts]], surface.face_sizes, axis=0)
    with np.errstate(invalid="ignore", over="ignore"):  # the program tells which points are not finite
        sums = np.add.reduceat(np.cross(surface.points[starts] - origins, surface.points[ends] - origins), firsts)
        return sums / np.linalg.norm(sums, axis=1, keepdims=True)


def at_edges(surface):
    """By how much the faces at each edge turn away from each other, in radians; NaN unless there are two."""
    normals = np.repeat(_normals(surface), surface.face_sizes, axis=0)
    is_backward = surface.corner_vertices > surface.corner_vertices[surface.next_corners()]
    normals[is_backward] *= -1  # those of two faces that agree about what is outside point to opposite sides now
    order = np.argsort(surface.corner_edges, kind="stable")
    edges, firsts, numbers = np.unique(surface.corner_edges[order], return_index=True, return_counts=True)
    firsts, edges = firsts[numbers == 2], edges[numbers == 2]
    result = np.full(len(surface.edge_vertices), np.nan)
    cosines = -(normals[order[firsts]] * normals[order[firsts + 1]]).sum(axis=1)
    result[edges] = np.arccos(np.clip(cosines, -1, 1))
    return result
