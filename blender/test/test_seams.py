# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams marked by hand, edges marked as sharp, and vertex groups."""

from support import (Case, add_sphere, array, equator, mark_seams, reference, seams_of, set_mode, unwrap)


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
        unwrap(marked_seams='KEEP')
        self.assert_like(self.sphere, expected)
        self.assertLessEqual(equator(self.mesh), seams_of(self.mesh))
        self.assertEqual(expected.report["charts"], 2)

    def test_start(self):
        """What is drawn by hand and not needed is left out."""
        drawn = set(map(frozenset, pairs(equator(self.mesh))[:5]))
        mark_seams(self.mesh, drawn)
        expected = reference(self.sphere, "--initial-cut", "edges", edges=pairs(drawn))
        unwrap(marked_seams='START')
        self.assert_like(self.sphere, expected)

    def test_ignored(self):
        expected = reference(self.sphere)
        mark_seams(self.mesh, equator(self.mesh))
        unwrap(marked_seams='IGNORE', clear_seams=False)
        self.assertEqual(seams_of(self.mesh), expected.cut | equator(self.mesh))
        unwrap(marked_seams='IGNORE')
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

    def test_marked_as_sharp(self):
        """A ring of a fifth of its cost is followed where the seam can."""
        for edge in self.mesh.edges:
            edge.use_edge_sharp = frozenset(edge.vertices) in equator(self.mesh)
        unwrap()
        without = len(seams_of(self.mesh) & equator(self.mesh))
        unwrap(marked_sharp=True)
        self.assertGreater(len(seams_of(self.mesh) & equator(self.mesh)), without)

    def test_group_to_avoid_and_to_prefer(self):
        upper = self.upper_group()
        lengths = {}
        for use in ('AVOID', 'PREFER'):
            unwrap(vertex_group="Upper", group_use=use)
            lengths[use] = self.length(edge for edge in seams_of(self.mesh) if edge <= upper)
        unwrap()
        without = self.length(edge for edge in seams_of(self.mesh) if edge <= upper)
        self.assertLess(lengths['AVOID'], without)
        self.assertGreaterEqual(lengths['PREFER'], without)
        self.assertLess(2 * lengths['AVOID'], lengths['PREFER'])

    def test_group_without_seams(self):
        upper = self.upper_group()
        unwrap()
        self.assertTrue(any(edge <= upper for edge in seams_of(self.mesh)))
        unwrap(vertex_group="Upper", group_use='NEVER')
        self.assertFalse(any(edge <= upper for edge in seams_of(self.mesh)))
        self.assertGreater(len(seams_of(self.mesh)), 3)

    def test_light_weights_do_not_forbid(self):
        upper = self.upper_group(0.4)
        unwrap(vertex_group="Upper", group_use='NEVER')
        self.assertTrue(any(edge <= upper for edge in seams_of(self.mesh)))

    def test_no_such_group(self):
        self.assert_refused('No object has a vertex group "Lower"', vertex_group="Lower")
