# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be done is told and shown, and changes nothing else."""

import os
import shutil
import sys
import tempfile
import types
from pathlib import Path

import bpy

from support import (ADDON, PROGRAM, Case, add_mesh, add_sphere, preferences, reference, select, set_mode, snapshot,
                     unwrap)

messages = sys.modules[ADDON + ".messages"]

SELECTION = tuple((kind, "select") for kind in ("vertices", "edges", "polygons"))


class Failures(Case):
    def replace_program(self, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        program = Path(folder.name, "program")
        program.write_text("#!/bin/sh\n" + text)
        os.chmod(program, 0o755)
        preferences().program = str(program)

    def assert_unchanged(self, object, before):
        set_mode('OBJECT')
        after = snapshot(object)
        selection = [name for name in before if isinstance(name, tuple) and (name in SELECTION or ".select" in name[1])]
        self.assert_same(before, after, *selection, *(name for name in after if isinstance(name, tuple) and ".select" in name[1]))

    def test_infeasible_constraints_select_what_is_in_the_way(self):
        """No seam is allowed on a closed surface."""
        sphere = add_sphere()
        other = add_mesh("Other", [(9, 0, 0), (10, 0, 0), (9, 1, 0)], [(0, 1, 2)])
        sphere.vertex_groups.new(name="All").add(range(len(sphere.data.vertices)), 1, 'REPLACE')
        select(other, sphere)
        before = snapshot(sphere)
        self.assert_refused("fewer seams to keep", vertex_group="All", group_use='NEVER')
        self.assertEqual(bpy.context.mode, 'EDIT_MESH')
        self.assertEqual(bpy.context.objects_in_mode[:], [sphere])
        set_mode('OBJECT')
        selected = sum(p.select for p in sphere.data.polygons) + sum(e.select for e in sphere.data.edges)
        self.assertGreater(selected, 0)
        self.assert_unchanged(sphere, before)

    def test_a_bad_point_is_selected(self):
        """The second of two objects has a point that is not finite; its number there is 4, in the file 7."""
        good = add_mesh("Good", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        points = [(0, 0, 9)] + [(float(i), float(i % 2), 1.0) for i in range(5)]
        bad = add_mesh("Bad", points, [(1, 2, 3), (3, 2, 4), (3, 4, 5)])
        bad.data.vertices[4].co.y = float("nan")
        select(good, bad)
        for mode in ('OBJECT', 'EDIT'):
            with self.subTest(mode=mode):
                set_mode('OBJECT')
                select(good, bad)
                set_mode(mode)
                self.assert_refused("A vertex has a coordinate that is infinite", only_selected=False)
                self.assertEqual(bpy.context.mode, 'EDIT_MESH')
                set_mode('OBJECT')
                self.assertEqual([v.index for v in bad.data.vertices if v.select], [4])
                self.assertFalse(mode == 'EDIT' and any(v.select for v in good.data.vertices))
                self.assertEqual([len(good.data.uv_layers), len(bad.data.uv_layers)], [0, 0])

    def test_one_of_two_fails(self):
        """With squares of their own, the other gets its layout."""
        good = add_sphere()
        bad = add_mesh("Bad", [(0, 0, 0), (1, 0, 0), (0, float("inf"), 0)], [(0, 1, 2)])
        select(good, bad)
        self.assertEqual(unwrap(is_shared=False), {'FINISHED'})
        self.assertEqual([len(good.data.uv_layers), len(bad.data.uv_layers)], [1, 0])
        self.assertEqual(bpy.context.objects_in_mode[:], [bad])

    def test_nothing_to_do(self):
        add_mesh("Empty", [(0, 0, 0)], [])
        self.assert_refused("have no faces")
        add_sphere()
        set_mode('EDIT')
        bpy.ops.mesh.select_all(action='DESELECT')
        self.assert_refused("No face is selected")
        bpy.ops.mesh.select_all(action='SELECT')
        self.assertEqual(unwrap(), {'FINISHED'})

    def test_bad_settings(self):
        sphere = add_sphere()
        before = snapshot(sphere)
        self.assert_refused("margin must be less", margin=40, texture_size=64)
        self.assert_unchanged(sphere, before)

    def test_removed_and_installed_again(self):
        bpy.ops.preferences.addon_disable(module=ADDON)
        self.assertFalse(hasattr(bpy.types, "UV_OT_unwrap_with_shortest_cuts"))
        bpy.ops.preferences.addon_enable(module=ADDON)
        self.assertEqual(preferences().program, "")
        preferences().program = PROGRAM
        add_sphere()
        self.assertEqual(unwrap(), {'FINISHED'})

    def test_missing_program(self):
        add_sphere()
        preferences().program = "no_such_program"
        self.assert_refused("set its path in the preferences")

    def test_bundled_program(self):
        """Without a path in the preferences: that of the add-on, which an installation takes the right to run away from, and
        else that on PATH."""
        module = sys.modules[ADDON + ".preferences"]
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        bundled, module.BUNDLED = module.BUNDLED, Path(folder.name, "unwrap")
        self.addCleanup(setattr, module, "BUNDLED", bundled)
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        preferences().program = ""
        os.environ["PATH"] = "/nowhere"
        self.assertIsNone(preferences().find_program())
        os.environ["PATH"] = os.path.dirname(PROGRAM)
        self.assertEqual(preferences().find_program(), PROGRAM)
        shutil.copyfile(PROGRAM, module.BUNDLED)
        self.assertEqual(preferences().find_program(), str(module.BUNDLED))
        add_sphere()
        self.assertEqual(unwrap(), {'FINISHED'})

    def test_other_programs(self):
        sphere = add_sphere()
        before = snapshot(sphere)
        for text, message in (("exit 0", "Exit code 0 without a message"), ("echo Ouch >&2; exit 9", "Ouch"),
                              ("exit 2", "of different versions"), ("kill -SEGV $$", "Exit code -11"), ('echo "{" > report.json; exit 5', "Exit code 5")):
            with self.subTest(program=text):
                self.replace_program(text)
                self.assert_refused(message)
                self.assert_unchanged(sphere, before)

    def test_time_limit(self):
        """No result by then."""
        sphere = add_sphere()
        before = snapshot(sphere)
        self.assert_refused("Allow more time", time_limit=1e-6)
        self.assert_unchanged(sphere, before)

    def test_bound_that_is_not_reached(self):
        """No seam may go where it would have to. What there is gets written."""
        sphere = add_sphere()
        upper = {vertex.index for vertex in sphere.data.vertices if vertex.co.z > 1e-6}
        sphere.vertex_groups.new(name="Upper").add(sorted(upper), 1, 'REPLACE')
        edges = [tuple(edge.vertices) for edge in sphere.data.edges if upper.issuperset(edge.vertices)]
        expected = reference(sphere, "--max-distortion", "4.009848", "--never-cut", "edges", edges=edges)
        self.assertEqual(expected.report["status"], "bound_not_reached")
        self.assertEqual(unwrap(limits_stretch=True, stretch=3.57, vertex_group="Upper", group_use='NEVER'), {'FINISHED'})
        self.assert_like(sphere, expected)
        for arguments, words in ((["--max-distortion", "4.009848"], "The stretch is"),
                                 (["--max-face-distortion", "4.009848"], "Some faces or islands")):
            missed = reference(sphere, *arguments, "--never-cut", "edges", edges=edges)
            texts = messages.warnings(types.SimpleNamespace(report=missed.report, exit_code=7))
            self.assertTrue(texts[-1].startswith(words), texts)

    def test_no_files_stay(self):
        add_sphere()
        unwrap()
        self.replace_program("exit 5")
        self.assert_refused("Exit code 5")
        self.assertEqual([each for each in os.listdir(bpy.app.tempdir) if each.startswith("unwrap_")], [])
