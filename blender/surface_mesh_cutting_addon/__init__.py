# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender add-on: unwraps meshes along short cuts, which the program `unwrap` finds.

The modules, each using only those before it: `surface` (meshes as arrays), `seams` (what is cut where corners differ),
`angles` (hard edges), `files` (what the program reads and writes), `stretch` (distortion in percent), `settings` (what the user
chooses), `command` (the call of the program),
`run` (its process), `task` (one run after the other), `write_back` (results into meshes), `messages` (reports in words),
`preferences`, `operator`."""

import bpy

from . import operator, preferences

bl_info = {
    "name": "Unwrap with Shortest Cuts",
    "author": "The authors of Surface_mesh_cutting",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "Edit Mode > UV > Unwrap with Shortest Cuts; Object Mode > Object > Unwrap with Shortest Cuts",
    "description": "Finds short seams that let meshes unwrap with little stretch, and unwraps along them",
    "category": "UV",
}

_CLASSES = (preferences.SurfaceMeshCuttingPreferences, operator.UV_OT_unwrap_with_shortest_cuts)
_MENUS = ("VIEW3D_MT_uv_map", "IMAGE_MT_uvs", "VIEW3D_MT_object")


def register():
    for each in _CLASSES:
        bpy.utils.register_class(each)
    for menu in _MENUS:
        getattr(bpy.types, menu).append(operator.draw_menu_item)


def unregister():
    for menu in _MENUS:
        getattr(bpy.types, menu).remove(operator.draw_menu_item)
    for each in reversed(_CLASSES):
        bpy.utils.unregister_class(each)
