# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams marked by hand, edges marked as sharp, and vertex groups."""

import math

import bpy

from support import (Case, add_mesh, add_sphere, array, equator, mark_seams, reference, seams_of, set_mode, snapshot, unwrap,
                     unwrap_anew)


def pairs(edges):
    return sorted(tuple(sorted(edge)) for edge in edges)


class Seams(Case):
    def setUp(self):
        super().setUp()
        self.sphere = add_sphere()
        self.mesh = self.sphere.data

    def length(self, edges):
        points = array(self.mesh.vertices, "co", 3)
        return sum(((points[a] - points[b]) ** 2).sum() ** 0.5 for a, b in edges)

    def upper_group(self, weight=1.0):
        """The vertices above the equator."""
        group = self.sphere.vertex_groups.new(name="Upper")
        upper = [v.index for v in self.mesh.vertices if v.co.z > 1e-6]
        group.add(upper, weight, 'REPLACE')
        return set(upper)

    def test_kept(self):
        mark_seams(self.mesh, equator(self.mesh))
        expected = reference(self.sphere, "--must-cut", "edges", edges=pairs(equator(self.mesh)))
        self.assertEqual(len(equator(self.mesh)), 16)
        unwrap()
        self.assert_like(self.sphere, expected)
        self.assertLessEqual(equator(self.mesh), seams_of(self.mesh))
        self.assertEqual(expected.report["charts"], 2)

    def test_start(self):
        """What is drawn by hand and not needed is left out."""
        drawn = set(map(frozenset, pairs(equator(self.mesh))[:5]))
        mark_seams(self.mesh, drawn)
        expected = reference(self.sphere, "--initial-cut", "edges", edges=pairs(drawn))
        unwrap(marked_seams='START', clear_seams=True)
        self.assert_like(self.sphere, expected)
        self.assertFalse(drawn <= expected.cut)
        mark_seams(self.mesh, drawn)
        unwrap(marked_seams='START')
        self.assertEqual(seams_of(self.mesh), expected.cut | drawn)

    def test_ignored(self):
        expected = reference(self.sphere)
        mark_seams(self.mesh, equator(self.mesh))
        unwrap(marked_seams='IGNORE')
        self.assertEqual(seams_of(self.mesh), expected.cut | equator(self.mesh))
        unwrap(marked_seams='IGNORE', clear_seams=True)
        self.assert_like(self.sphere, expected)
        self.assertFalse(equator(self.mesh) <= expected.cut)

    def test_marks_can_stay(self):
        mark_seams(self.mesh, equator(self.mesh))
        for mode in ('OBJECT', 'EDIT'):
            set_mode(mode)
            unwrap(mark_seams=False, only_selected=False)
            set_mode('OBJECT')
            self.assertEqual(seams_of(self.mesh), equator(self.mesh))

    def test_same_in_edit_mode(self):
        mark_seams(self.mesh, equator(self.mesh))
        set_mode('EDIT')
        unwrap(marked_seams='KEEP', only_selected=False)
        set_mode('OBJECT')
        kept = seams_of(self.mesh)
        mark_seams(self.mesh, equator(self.mesh))
        unwrap(marked_seams='KEEP')
        self.assertEqual(seams_of(self.mesh), kept)

    def test_seams_only(self):
        """What a layout would mark; no UV map changes or is added."""
        expected = reference(self.sphere)
        set_mode('EDIT')  # a visit changes how selections are stored
        set_mode('OBJECT')
        for mode in ('OBJECT', 'EDIT'):
            for target in ("mark_seams", "no mark_seams"):
                mark_seams(self.mesh, set())
                before = snapshot(self.sphere)
                set_mode(mode)
                unwrap(target='SEAMS', mark_seams=target == "mark_seams", only_selected=False)
                set_mode('OBJECT')
                self.assertEqual(seams_of(self.mesh), expected.cut)
                self.assert_same(before, snapshot(self.sphere), ("edges", "use_seam"), ("attribute", ".uv_seam"))

    def test_hard_edges(self):
        """A box whose lid is bent by 30 degrees in the middle."""
        height = math.tan(math.radians(15))
        points = [(x, y, z) for z in (0, 2) for y in (0, 1) for x in (-1, 0, 1)]
        points = [(x, y, z + height * (z > 0 and x == 0)) for x, y, z in points]
        faces = [(0, 3, 4, 1), (1, 4, 5, 2), (6, 7, 10, 9), (7, 8, 11, 10), (0, 1, 7, 6), (1, 2, 8, 7), (3, 9, 10, 4),
                 (4, 10, 11, 5), (0, 6, 9, 3), (2, 5, 11, 8)]
        ring = ((0, 1), (1, 2), (2, 5), (4, 5), (3, 4), (0, 3))
        corners = {frozenset(edge) for a, b in ring for edge in ((a, b), (a + 6, b + 6))}
        corners |= {frozenset((a, a + 6)) for a in (0, 2, 3, 5)}
        box = add_mesh("Box", points, faces)
        for degrees, is_bend_hard in ((29.99, True), (30.01, False), (45, False)):
            with self.subTest(degrees=degrees):
                mark_seams(box.data, set())
                unwrap(cut_sharp=True, sharp_angle=math.radians(degrees))
                self.assertEqual(seams_of(box.data), corners | ({frozenset((7, 10))} if is_bend_hard else set()))
        box.data.flip_normals()
        box.data.polygons[3].flip()
        mark_seams(box.data, set())
        unwrap(cut_sharp=True, sharp_angle=math.radians(29.99))
        self.assertEqual(seams_of(box.data), corners | {frozenset((7, 10))})

    def test_edges_marked_as_sharp_become_seams(self):
        """Beside marked seams, and where those are a start only."""
        for edge in self.mesh.edges:
            edge.use_edge_sharp = frozenset(edge.vertices) in equator(self.mesh)
        expected = reference(self.sphere, "--must-cut", "edges", edges=pairs(equator(self.mesh)))
        unwrap(cut_marked_sharp=True)
        self.assert_like(self.sphere, expected)
        marked = next(edge for edge in map(frozenset, pairs(map(lambda e: e.vertices, self.mesh.edges)))
                      if edge not in expected.cut)
        for marked_seams in ('KEEP', 'START'):
            mark_seams(self.mesh, {marked})
            unwrap(cut_marked_sharp=True, marked_seams=marked_seams)
            self.assertLessEqual(equator(self.mesh) | {marked}, seams_of(self.mesh))

    def test_edges_between_materials_become_seams(self):
        for name in ("North", "South"):
            self.mesh.materials.append(bpy.data.materials.new(name))
        for polygon in self.mesh.polygons:
            polygon.material_index = int(polygon.center.z < 0)
        expected = reference(self.sphere, "--must-cut", "edges", edges=pairs(equator(self.mesh)))
        unwrap(cut_materials=True)
        self.assert_like(self.sphere, expected)

    def test_marked_as_sharp(self):
        """A ring of a fifth of its cost is followed where the seam can."""
        for edge in self.mesh.edges:
            edge.use_edge_sharp = frozenset(edge.vertices) in equator(self.mesh)
        unwrap_anew()
        without = len(seams_of(self.mesh) & equator(self.mesh))
        unwrap_anew(marked_sharp=True)
        self.assertGreater(len(seams_of(self.mesh) & equator(self.mesh)), without)

    def test_group_to_avoid_and_to_prefer(self):
        upper = self.upper_group()
        lengths = {}
        for use in ('AVOID', 'PREFER'):
            unwrap_anew(vertex_group="Upper", group_use=use)
            lengths[use] = self.length(edge for edge in seams_of(self.mesh) if edge <= upper)
        unwrap_anew()
        without = self.length(edge for edge in seams_of(self.mesh) if edge <= upper)
        self.assertLess(lengths['AVOID'], without)
        self.assertGreaterEqual(lengths['PREFER'], without)
        self.assertLess(2 * lengths['AVOID'], lengths['PREFER'])

    def test_group_without_seams(self):
        upper = self.upper_group()
        unwrap_anew()
        self.assertTrue(any(edge <= upper for edge in seams_of(self.mesh)))
        unwrap_anew(vertex_group="Upper", group_use='NEVER')
        self.assertFalse(any(edge <= upper for edge in seams_of(self.mesh)))
        self.assertGreater(len(seams_of(self.mesh)), 3)

    def test_light_weights_do_not_forbid(self):
        upper = self.upper_group(0.4)
        unwrap_anew(vertex_group="Upper", group_use='NEVER')
        self.assertTrue(any(edge <= upper for edge in seams_of(self.mesh)))

    def test_no_such_group(self):
        self.assert_refused('No object has a vertex group "Lower"', vertex_group="Lower")
