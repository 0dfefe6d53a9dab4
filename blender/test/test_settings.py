# SPDX-License-Identifier: GPL-3.0-or-later
"""Stretch in percent, presets, and words."""

import sys
import types

import bpy

from support import ADDON, Case, add_sphere, unwrap

settings = sys.modules[ADDON + ".settings"]
stretch = sys.modules[ADDON + ".stretch"]


class Settings(Case):
    def test_stretch(self):
        """Of a map that makes all lengths longer, the energy is the sum of the squares of its singular values and their inverses."""
        for percent in (0, 0.1, 5, 12, 100):
            s = 1 + percent / 100
            energy = sum(x * x + 1 / (x * x) for x in (s, 1 / s))
            self.assertAlmostEqual(stretch.energy_of(percent), energy, places=12)
            self.assertAlmostEqual(stretch.percent_of(energy), percent, places=5)
        self.assertEqual(stretch.percent_of(4 - 1e-12), 0)

    def test_presets(self):
        """All they set are settings; each leaves nothing of another."""
        properties = bpy.ops.uv.unwrap_with_shortest_cuts.get_rna_type().properties
        names = {item.identifier for item in properties["preset"].enum_items}
        self.assertEqual(names, set(settings.PRESETS))
        for name in settings.BALANCED:
            self.assertAlmostEqual(properties[name].default, settings.BALANCED[name])
        chosen = types.SimpleNamespace(preset='CHARACTER')
        settings.apply_preset(chosen)
        self.assertTrue(chosen.hidden and chosen.limits_stretch)
        chosen.preset = 'HARD_SURFACE'
        settings.apply_preset(chosen)
        self.assertTrue(chosen.cut_sharp and not chosen.hidden and not chosen.limits_stretch)
        for values in settings.PRESETS.values():
            self.assertLessEqual(set(values), set(settings.BALANCED))
            add_sphere()
            self.assertEqual(unwrap(effort='fast', **values), {'FINISHED'})
