# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the add-on share: meshes, snapshots of all data, and runs of the program by hand.

Tests run in Blender: scripts/test_blender.sh."""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import bpy
import numpy as np

ADDON = "surface_mesh_cutting_addon"
ARCHIVE, PROGRAM, *WORDS = sys.argv[sys.argv.index("--") + 1:]
ARCHIVE, PROGRAM = os.path.abspath(ARCHIVE), os.path.abspath(PROGRAM)
TIME_LIMIT = 60  # seconds, of any run


def install():
    """Installs the archive as a user does."""
    bpy.ops.preferences.addon_install(filepath=ARCHIVE)
    bpy.ops.preferences.addon_enable(module=ADDON)
    preferences().program = PROGRAM


def preferences():
    return bpy.context.preferences.addons[ADDON].preferences


def unwrap(**settings):
    """Calls the operator as a menu does, with a step of undo, but without the dialog; settings that are not given have
    their defaults, and not the values of the last call."""
    operator = bpy.ops.uv.unwrap_with_shortest_cuts
    defaults = {p.identifier: p.default for p in operator.get_rna_type().properties if p.identifier != "rna_type"}
    return operator('EXEC_DEFAULT', True, **{**defaults, **settings})


def unwrap_anew(**settings):
    """The same, without regard to seams of calls before."""
    return unwrap(**{"marked_seams": 'IGNORE', "clear_seams": True, **settings})


# ------------------------------------------------------------------------------------------------------------- meshes

def add_monkey():
    bpy.ops.mesh.primitive_monkey_add()
    return bpy.context.object


def add_sphere(name="Sphere", radius=1.0, location=(0, 0, 0)):
    """Quads, with triangles at both ends of the z axis. No two axes are alike, so that results have no ties. (That of
    Blender has its faces in another order every time.)"""
    segments, rings = 16, 8
    points = [(0, 0, -1.5 * radius), (0, 0, 1.5 * radius)]
    for ring in range(1, rings):
        height = math.pi * (ring / rings - 0.5)
        for segment in range(segments):
            angle = 2 * math.pi * segment / segments
            points.append((radius * math.cos(height) * math.cos(angle), 1.25 * radius * math.cos(height) * math.sin(angle),
                           1.5 * radius * math.sin(height)))
    faces = []
    for i in range(segments):
        j = (i + 1) % segments
        lowest, highest = 2, 2 + segments * (rings - 2)
        faces += [(0, lowest + j, lowest + i), (1, highest + i, highest + j)]
        faces += [(a + i, a + j, a + segments + j, a + segments + i) for a in range(lowest, highest, segments)]
    sphere = add_mesh(name, points, faces)
    sphere.location = location
    bpy.context.view_layer.update()
    return sphere


def add_mesh(name, points, faces):
    """Nothing is validated."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    result = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(result)
    select(result)
    return result


def select(*objects):
    bpy.ops.object.select_all(action='DESELECT')
    for each in objects:
        each.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]


def set_mode(mode):
    bpy.ops.object.mode_set(mode=mode)


def array(collection, name, width=1, dtype=np.float64):
    result = np.empty(len(collection) * width, dtype)
    collection.foreach_get(name, result)
    return result.reshape(-1, width) if width > 1 else result


def faces_of(mesh):
    return [tuple(polygon.vertices) for polygon in mesh.polygons]


def uvs_of(mesh):
    """The coordinates in the active UV map, by corner."""
    return array(mesh.uv_layers.active.data, "uv", 2, np.float32)


def seams_of(mesh):
    """Pairs of vertices."""
    return {frozenset(edge.vertices) for edge in mesh.edges if edge.use_seam}


def mark_seams(mesh, pairs):
    for edge in mesh.edges:
        edge.use_seam = frozenset(edge.vertices) in pairs


def equator(mesh):
    """The edges of the sphere on the plane z = 0."""
    return {frozenset(edge.vertices) for edge in mesh.edges
            if all(abs(mesh.vertices[v].co.z) < 1e-6 for v in edge.vertices)}


# ---------------------------------------------------------------------------------------------------------- snapshots

_ATTRIBUTES = {"FLOAT": ("value", 1), "INT": ("value", 1), "INT8": ("value", 1), "BOOLEAN": ("value", 1),
               "FLOAT_VECTOR": ("vector", 3), "FLOAT2": ("vector", 2), "FLOAT_COLOR": ("color", 4), "BYTE_COLOR": ("color", 4),
               "INT32_2D": ("value", 2), "INT16_2D": ("value", 2), "QUATERNION": ("value", 4), "FLOAT4X4": ("value", 16)}
_ELEMENTS = {"vertices": {"co": 3, "hide": 1, "select": 1},
             "edges": {"vertices": 2, "use_edge_sharp": 1, "use_seam": 1, "crease": 1, "bevel_weight": 1, "hide": 1, "select": 1},
             "loops": {"vertex_index": 1, "edge_index": 1, "normal": 3},
             "polygons": {"loop_start": 1, "loop_total": 1, "material_index": 1, "use_smooth": 1, "hide": 1, "select": 1}}


def _values(owner):
    """The plain properties of anything in Blender."""
    return {p.identifier: repr(getattr(owner, p.identifier)) for p in owner.bl_rna.properties
            if p.type in {'BOOLEAN', 'INT', 'FLOAT', 'STRING', 'ENUM'} and not getattr(p, "is_array", False)}


def snapshot(object):
    """All data of an object and of its mesh by name. Needs object mode."""
    mesh = object.data
    if hasattr(mesh, "calc_normals_split"):
        mesh.calc_normals_split()
    data = {"matrix": [list(row) for row in object.matrix_world], "custom normals": mesh.has_custom_normals,
            "mode": object.mode, "materials": [slot.name for slot in object.material_slots],
            "active layer": mesh.uv_layers.active_index}
    for kind, names in _ELEMENTS.items():
        collection = getattr(mesh, kind)
        for name, width in names.items():
            if len(collection) == 0 or hasattr(collection[0], name):
                data[kind, name] = array(collection, name, width).tolist()
    for attribute in mesh.attributes:
        name, width = _ATTRIBUTES[attribute.data_type]
        data["attribute", attribute.name] = array(attribute.data, name, width).tolist()
    for layer in mesh.uv_layers:
        data["uv", layer.name] = array(layer.data, "uv", 2).tolist()
        data["uv flags", layer.name] = array(layer.data, "pin_uv").tolist()
    for key in mesh.shape_keys.key_blocks if mesh.shape_keys else ():
        data["key", key.name] = array(key.data, "co", 3).tolist(), _values(key)
    for modifier in object.modifiers:
        data["modifier", modifier.name] = modifier.type, _values(modifier)
    data["groups"] = [[(g.group, g.weight) for g in vertex.groups] for vertex in mesh.vertices]
    data["group names"] = [group.name for group in object.vertex_groups]
    return data


# ------------------------------------------------------------------------------------------------- the program itself

class Reference:
    """What the program says about faces when it is called by hand, with a file that the add-on does not write."""

    def __init__(self, points, faces, *arguments, edges=None):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            lines = ["v " + " ".join(map(repr, map(float, point))) for point in points]
            lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
            (folder / "mesh.obj").write_text("\n".join(lines) + "\n")
            if edges is not None:
                (folder / "edges").write_text("\n\n" + " ".join(f"{a} {b}" for a, b in edges) + "\n")
            margin = [] if {"--margin", "--lightmap"} & set(arguments) else ["--margin", "4"]  # the add-on's default
            run = subprocess.run([PROGRAM, "mesh.obj", "-o", "out.obj", "--obj-cut", "cut.obj", "--json", "report.json",
                                  *margin, *arguments], cwd=folder, check=False, capture_output=True, timeout=TIME_LIMIT)
            assert run.returncode in (0, 7), run.stderr
            self.report = json.loads((folder / "report.json").read_text())
            self._read_layout((folder / "out.obj").read_text())
            self._read_cut((folder / "cut.obj").read_text(), points)

    def _read_layout(self, text):
        texture_points, self.uvs = [], []
        for keyword, *words in map(str.split, text.splitlines()):
            if keyword == "vt":
                texture_points.append(tuple(map(float, words)))
            elif keyword == "f":
                self.uvs += [texture_points[int(word.split("/")[1]) - 1] for word in words]
        self.uvs = np.array(self.uvs, np.float32)

    def _read_cut(self, text, points):
        """Its lines name points; vertices at the same one count as the first of them."""
        vertex = {}
        self.first_vertices = [vertex.setdefault(tuple(map(float, point)), i) for i, point in enumerate(points)]
        ends, self.cut = [], set()
        for keyword, *words in map(str.split, text.splitlines()):
            if keyword == "v":
                ends.append(vertex[tuple(map(float, words))])
            elif keyword == "l":
                self.cut.add(frozenset(ends[int(word) - 1] for word in words))


def world_points(object):
    matrix = np.array(object.matrix_world)
    return array(object.data.vertices, "co", 3) @ matrix[:3, :3].T + matrix[:3, 3]


def reference(object, *arguments, **keywords):
    """The program on the whole mesh of an object."""
    return Reference(world_points(object), faces_of(object.data), *arguments, **keywords)


class Case(unittest.TestCase):
    """A test in an empty scene."""

    def setUp(self):
        if bpy.context.mode != 'OBJECT':
            set_mode('OBJECT')
        for each in list(bpy.data.objects):
            bpy.data.objects.remove(each)
        for mesh in list(bpy.data.meshes):
            bpy.data.meshes.remove(mesh)
        bpy.context.tool_settings.mesh_select_mode = (True, False, False)
        preferences().program = PROGRAM

    def assert_same(self, before, after, *except_for):
        """Two snapshots agree in all but these names."""
        self.assertEqual(set(before) - set(except_for), set(after) - set(except_for))
        for name in set(before) - set(except_for):
            self.assertTrue(before[name] == after[name], name)  # assertEqual() would describe a difference for minutes

    def assert_like(self, object, expected):
        """UV map and seams are those of the program."""
        np.testing.assert_array_equal(uvs_of(object.data), expected.uvs)
        seams = {frozenset(expected.first_vertices[v] for v in edge) for edge in seams_of(object.data)}
        self.assertEqual(seams, expected.cut)

    def assert_refused(self, text, **settings):
        with self.assertRaisesRegex(RuntimeError, text):
            unwrap(**settings)
