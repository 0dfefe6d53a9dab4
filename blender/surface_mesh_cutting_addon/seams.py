# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a layout is cut."""

import numpy as np


def cut_edges(surface, corner_uvs):
    """Whether each edge is cut: whether faces at it have different texture points at one of its ends.

    `corner_uvs` holds the index of a texture point for each corner. Takes linear time."""
    following = surface.next_corners()
    ends = np.stack([corner_uvs, corner_uvs[following]], axis=1)
    is_backward = surface.corner_vertices > surface.corner_vertices[following]
    ends[is_backward] = ends[is_backward, ::-1]
    ends_of_edge = np.empty((len(surface.edge_vertices), 2), ends.dtype)
    ends_of_edge[surface.corner_edges] = ends  # of one of its faces
    is_cut = np.zeros(len(surface.edge_vertices), bool)
    is_cut[surface.corner_edges[(ends != ends_of_edge[surface.corner_edges]).any(axis=1)]] = True
    return is_cut
