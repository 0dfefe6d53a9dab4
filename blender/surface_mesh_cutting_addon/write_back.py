# SPDX-License-Identifier: GPL-3.0-or-later
"""Results into meshes: texture coordinates, seams, and the selection of elements that a message is about.

In edit mode, Blender keeps the mesh in another structure, which has no access by arrays."""

import bmesh
import bpy
import numpy as np

from .surface import values

LAYER_NAME = "Shortest Cuts"
NAMED_TARGETS = ('NAMED', 'LIGHT_MAP')
MAXIMUM_LAYERS = 8  # a limit of Blender


def _existing_layer(mesh, settings):
    """The UV map to replace, if it is there."""
    return (mesh.uv_layers.active if settings.target == 'ACTIVE' else
            mesh.uv_layers.get(settings.uv_map) if settings.target in NAMED_TARGETS else None)


def has_place(mesh, settings):
    """Whether the mesh can take the UV map."""
    return (settings.target == 'SEAMS' or len(mesh.uv_layers) < MAXIMUM_LAYERS
            or _existing_layer(mesh, settings) is not None)


def _make_layer(mesh, settings):
    """The UV map to write to becomes the active one."""
    name = settings.uv_map if settings.target in NAMED_TARGETS else LAYER_NAME
    mesh.uv_layers.active = _existing_layer(mesh, settings) or mesh.uv_layers.new(name=name)


def _write_uvs(mesh, part, uvs):
    data = mesh.uv_layers.active.data
    all_uvs = values(data, "uv", np.float32, 2)
    all_uvs[part.corners] = uvs
    data.foreach_set("uv", all_uvs.ravel())


def _write_uvs_in_edit_mode(mesh, part, uvs):
    edited = bmesh.from_edit_mesh(mesh)
    edited.faces.ensure_lookup_table()
    layer = edited.loops.layers.uv[mesh.uv_layers.active.name]
    coordinates = iter(uvs.tolist())
    for face in part.faces.tolist():
        for loop in edited.faces[face].loops:
            loop[layer].uv = next(coordinates)


def _write_seams(mesh, part, is_seam):
    all_seams = values(mesh.edges, "use_seam", bool)
    all_seams[part.edges] = is_seam
    mesh.edges.foreach_set("use_seam", all_seams)


def _write_seams_in_edit_mode(mesh, part, is_seam):
    edited = bmesh.from_edit_mesh(mesh)
    edited.edges.ensure_lookup_table()
    for i in np.flatnonzero(is_seam != part.is_seam).tolist():
        edited.edges[part.edges[i]].seam = bool(is_seam[i])


def _seams(part, is_cut, may_clear):
    """Old seams at the border to faces that are not unwrapped belong to these, too."""
    return is_cut | (part.is_seam & ~(part.is_inside & may_clear))


def write_result(result, settings):
    """Writes the layout of a result into the UV maps of its meshes, its cut into their seams, or one of both."""
    surface = result.surface
    for i, part in enumerate(surface.parts):
        mesh = part.object.data
        uvs = result.corner_uvs[surface.first_corners[i]:surface.first_corners[i + 1]]
        is_cut = result.is_cut[surface.first_edges[i]:surface.first_edges[i + 1]]
        if settings.target != 'SEAMS':
            _make_layer(mesh, settings)
            (_write_uvs_in_edit_mode if mesh.is_editmode else _write_uvs)(mesh, part, uvs)
        if settings.mark_seams or settings.target == 'SEAMS':
            is_seam = _seams(part, is_cut, settings.clear_seams)
            (_write_seams_in_edit_mode if mesh.is_editmode else _write_seams)(mesh, part, is_seam)
        if mesh.is_editmode:
            bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)
        else:
            mesh.update()


def _enter_edit_mode(context, objects):
    if context.mode == 'EDIT_MESH':
        return
    for each in context.selected_objects:
        each.select_set(False)
    for each in objects:
        each.select_set(True)
    context.view_layer.objects.active = objects[0]
    bpy.ops.object.mode_set(mode='EDIT')


def _witnesses(surface, witness):
    """For each part its elements in the report's `witness`, by their indices in the mesh. Edges are pairs of vertices."""
    kind, indices = witness["kind"], np.array(witness["indices"], np.int64)
    firsts = surface.first_faces if kind == "faces" else surface.first_vertices
    if kind == "edges":
        indices = indices.reshape(-1, 2)
    leaders = indices[:, 0] if kind == "edges" else indices
    for i, part in enumerate(surface.parts):
        own = indices[(leaders >= firsts[i]) & (leaders < firsts[i + 1])] - firsts[i]
        yield part, (part.faces if kind == "faces" else part.vertices)[own]


def _select_in_edit_mode(mesh, kind, indices):
    edited = bmesh.from_edit_mesh(mesh)
    for table in (edited.verts, edited.edges, edited.faces):
        table.ensure_lookup_table()
        for element in table:
            element.select = False
    for index in indices.tolist():
        element = (edited.verts[index] if kind == "vertices" else edited.faces[index] if kind == "faces"
                   else edited.edges.get([edited.verts[end] for end in index]))
        if element is not None:
            element.hide_set(False)
            element.select_set(True)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def select_witness(context, surface, witness):
    """Shows the elements that a message is about: enters edit mode and selects them alone."""
    kind = witness["kind"]
    witnesses = list(_witnesses(surface, witness))
    _enter_edit_mode(context, [part.object for part, indices in witnesses if len(indices) > 0])
    context.tool_settings.mesh_select_mode = (kind == "vertices", kind == "edges", kind == "faces")
    for part, indices in witnesses:
        if part.object.data.is_editmode:
            _select_in_edit_mode(part.object.data, kind, indices)
