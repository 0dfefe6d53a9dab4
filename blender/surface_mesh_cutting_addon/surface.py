# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces to unwrap as arrays, and where in which mesh each of their elements is."""

from dataclasses import dataclass

import bpy
import numpy as np


@dataclass(frozen=True, eq=False)
class Part:
    """The faces of one mesh. Elements are numbered anew, from 0 and without gaps, in the order of the mesh."""

    name: str  # of the object
    mesh_size: tuple  # see mesh_size()
    # Indices in the mesh, for each of the part's own.
    faces: np.ndarray
    corners: np.ndarray
    vertices: np.ndarray
    edges: np.ndarray
    # By the part's own indices.
    points: np.ndarray  # n x 3, in the space of the world
    face_sizes: np.ndarray
    materials: np.ndarray  # indices, by face
    corner_vertices: np.ndarray
    corner_edges: np.ndarray  # the edge from this corner to the next of the face
    edge_vertices: np.ndarray  # m x 2
    is_seam: np.ndarray  # marked, by edge
    is_sharp: np.ndarray
    is_inside: np.ndarray  # whether all faces of the edge belong to the part

    @property
    def object(self):
        """The object, or None if it is gone. What Blender hands out does not survive an undo in another window."""
        return bpy.data.objects.get((self.name, None))

    def is_up_to_date(self):
        """Whether the indices still mean the same."""
        return self.object is not None and mesh_size(_present_mesh(self.object)) == self.mesh_size


def values(collection, name, dtype, width=1):
    """The property `name` of all elements of a collection of Blender, one row for each if `width` is above 1."""
    result = np.empty(len(collection) * width, dtype)
    collection.foreach_get(name, result)
    return result.reshape(-1, width) if width > 1 else result


def mesh_size(mesh):
    """The numbers of elements: as long as they stay, indices mean the same."""
    return len(mesh.vertices), len(mesh.edges), len(mesh.loops), len(mesh.polygons)


def _present_mesh(object):
    """The mesh, in edit mode as it is being edited."""
    if object.mode == 'EDIT':
        object.update_from_editmode()
    return object.data


def _ranges(starts, sizes):
    """The indices start, start + 1, ... of each range, one range after the other."""
    firsts = np.cumsum(sizes) - sizes
    return np.repeat(starts - firsts, sizes) + np.arange(sizes.sum())


def _in_world(object, points):
    matrix = np.array(object.matrix_world, np.float64)
    with np.errstate(invalid="ignore"):  # the program tells which points are not finite
        return points @ matrix[:3, :3].T + matrix[:3, 3]


def read_part(object, only_selected):
    """The selected faces of the mesh of `object`, or all. In edit mode, those of the mesh as it is being edited."""
    mesh = _present_mesh(object)
    sizes = values(mesh.polygons, "loop_total", np.int32)
    starts = values(mesh.polygons, "loop_start", np.int32)
    is_chosen = values(mesh.polygons, "select", bool) if only_selected else np.ones(len(sizes), bool)
    faces = np.flatnonzero(is_chosen)
    corners = _ranges(starts[faces], sizes[faces])
    all_edges = values(mesh.loops, "edge_index", np.int32)
    vertices, corner_vertices = np.unique(values(mesh.loops, "vertex_index", np.int32)[corners], return_inverse=True)
    edges, corner_edges = np.unique(all_edges[corners], return_inverse=True)
    new_vertex = np.full(len(mesh.vertices), -1)
    new_vertex[vertices] = np.arange(len(vertices))
    return Part(
        name=object.name, mesh_size=mesh_size(mesh), faces=faces, corners=corners, vertices=vertices, edges=edges,
        points=_in_world(object, values(mesh.vertices, "co", np.float32, 3)[vertices].astype(np.float64)),
        face_sizes=sizes[faces], materials=values(mesh.polygons, "material_index", np.int32)[faces],
        corner_vertices=corner_vertices, corner_edges=corner_edges,
        edge_vertices=new_vertex[values(mesh.edges, "vertices", np.int32, 2)[edges]],
        is_seam=values(mesh.edges, "use_seam", bool)[edges],
        is_sharp=values(mesh.edges, "use_edge_sharp", bool)[edges],
        is_inside=np.bincount(corner_edges, minlength=len(edges))
        == np.bincount(all_edges, minlength=len(mesh.edges))[edges])


def group_weights(part, name):
    """The weights of the vertices of a part in the vertex group `name`, 0 outside; None if there is no such group."""
    group = part.object.vertex_groups.get(name)
    if group is None:
        return None
    weights = np.zeros(len(part.vertices))
    vertices = part.object.data.vertices
    for i, vertex in enumerate(part.vertices.tolist()):
        for element in vertices[vertex].groups:
            if element.group == group.index:
                weights[i] = element.weight
    return weights


class Surface:
    """Parts that are unwrapped together. Elements are numbered through, one part after the other."""

    def __init__(self, parts):
        self.parts = parts
        self.first_vertices = self._firsts("vertices")
        self.first_faces = self._firsts("faces")
        self.first_corners = self._firsts("corners")
        self.first_edges = self._firsts("edges")
        self.points = self._joined("points")
        self.face_sizes = self._joined("face_sizes")
        self.materials = self._joined("materials")
        self.corner_vertices = self._joined("corner_vertices", self.first_vertices)
        self.corner_edges = self._joined("corner_edges", self.first_edges)
        self.edge_vertices = self._joined("edge_vertices", self.first_vertices)
        self.is_seam = self._joined("is_seam")
        self.is_sharp = self._joined("is_sharp")

    def _firsts(self, name):
        """For each part the number of its first element, and at the end the number of all elements."""
        return np.cumsum([0] + [len(getattr(part, name)) for part in self.parts])

    def _joined(self, name, firsts=None):
        arrays = [getattr(part, name) for part in self.parts]
        if firsts is not None:
            arrays = [array + first for array, first in zip(arrays, firsts)]
        return np.concatenate(arrays)

    def group_weights(self, name):
        """The weights in the vertex groups of this name, 0 where there is none; None if no part has one."""
        weights = [group_weights(part, name) for part in self.parts]
        if all(each is None for each in weights):
            return None
        return np.concatenate([np.zeros(len(part.vertices)) if each is None else each
                               for part, each in zip(self.parts, weights)])

    def is_between_materials(self):
        """For each edge, whether it has faces of different materials."""
        materials = np.repeat(self.materials, self.face_sizes)
        least, largest = np.full(len(self.edge_vertices), np.iinfo(np.int32).max), np.full(len(self.edge_vertices), -1)
        np.minimum.at(least, self.corner_edges, materials)
        np.maximum.at(largest, self.corner_edges, materials)
        return least < largest

    def next_corners(self):
        """For each corner, the next one of its face."""
        ends = np.cumsum(self.face_sizes)
        following = np.arange(1, len(self.corner_vertices) + 1)
        following[ends - 1] = ends - self.face_sizes
        return following
