# SPDX-License-Identifier: GPL-3.0-or-later
"""All that an unwrap does not concern stays as it was, and undo brings back the rest."""

import bpy

from support import Case, add_monkey, add_sphere, select, set_mode, snapshot, unwrap_anew


def decorate(object):
    """Gives an object some of each kind of data that a mesh can have."""
    mesh = object.data
    object.modifiers.new("Subdivision", 'SUBSURF').levels = 2
    object.modifiers.new("Mirror", 'MIRROR').use_axis[1] = True
    object.shape_key_add(name="Basis")
    key = object.shape_key_add(name="Wide")
    for point in key.data:
        point.co.x *= 1.5
    key.value = 0.25
    group = object.vertex_groups.new(name="Group")
    group.add([1, 3, 5, 7], 0.5, 'REPLACE')
    for name in ("Red", "Green"):
        mesh.materials.append(bpy.data.materials.new(name))
    for polygon in mesh.polygons:
        polygon.material_index = polygon.index % 2
        polygon.use_smooth = polygon.index % 3 == 0
    for name, kind, domain in (("number", 'INT', 'FACE'), ("length", 'FLOAT', 'EDGE'), ("direction", 'FLOAT_VECTOR', 'POINT')):
        mesh.attributes.new(name, kind, domain)
    mesh.attributes["number"].data.foreach_set("value", range(len(mesh.polygons)))
    mesh.color_attributes.new("Paint", 'BYTE_COLOR', 'CORNER').data[3].color = (1, 0, 0, 1)
    while mesh.uv_layers:
        mesh.uv_layers.remove(mesh.uv_layers[0])
    for name in ("First", "Second", "Third"):
        mesh.uv_layers.new(name=name).data[5].uv = (0.5, 0.25)
    mesh.uv_layers.active_index = 1
    mesh.uv_layers["Second"].data[2].pin_uv = True
    for edge in mesh.edges:
        edge.use_edge_sharp = edge.index % 7 == 0
    mesh.polygons[4].hide = True
    if hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices([vertex.normal for vertex in mesh.vertices])


CHANGED = (("uv", "Second"), ("edges", "use_seam"), ("attribute", "Second"), ("attribute", ".uv_seam"))


class Untouched(Case):
    def setUp(self):
        super().setUp()
        self.object = add_monkey()
        decorate(self.object)

    def in_mode(self, mode, do):
        set_mode(mode)
        result = do()
        self.assertEqual(self.object.mode, mode)
        set_mode('OBJECT')
        return result

    def test_all_else(self):
        for mode in ('OBJECT', 'EDIT'):
            with self.subTest(mode=mode):
                self.in_mode(mode, lambda: None)  # a visit of edit mode may change normals
                self.object.data.edges.foreach_set("use_seam", [i % 5 == 0 for i in range(len(self.object.data.edges))])
                before = snapshot(self.object)
                self.in_mode(mode, lambda: unwrap_anew(only_selected=False, margin=5 if mode == 'EDIT' else 2))
                after = snapshot(self.object)
                self.assert_same(before, after, *CHANGED)
                self.assertNotEqual(before["uv", "Second"], after["uv", "Second"])
                self.assertNotEqual(before["edges", "use_seam"], after["edges", "use_seam"])

    def test_undo(self):
        """One step brings back everything, in both modes; another UV map goes, too."""
        name = self.object.name
        for mode in ('OBJECT', 'EDIT'):
            for target in ('ACTIVE', 'NEW'):
                with self.subTest(mode=mode, target=target):
                    set_mode(mode)
                    bpy.ops.ed.undo_push(message="Before")
                    set_mode('OBJECT')
                    before = snapshot(self.object)
                    set_mode(mode)
                    bpy.ops.ed.undo_push(message="Before")
                    unwrap_anew(target=target, only_selected=False)
                    bpy.ops.ed.undo()
                    self.object = bpy.data.objects[name]
                    self.assertEqual(self.object.mode, mode)
                    set_mode('OBJECT')
                    self.assert_same(before, snapshot(self.object))

    def test_undo_of_two_objects(self):
        other = add_sphere()
        names = [self.object.name, other.name]
        select(self.object, other)
        before = [snapshot(each) for each in (self.object, other)]
        bpy.ops.ed.undo_push(message="Before")
        unwrap_anew()
        bpy.ops.ed.undo()
        for name, data in zip(names, before):
            self.assert_same(data, snapshot(bpy.data.objects[name]))
