"""The evaluator of the comparison on maps whose measures are worked out by hand, and against the report of unwrap."""

import json
import math
import unittest

from comparison import flat, grid
from support import Case, joined, main, scaled, sphere, to_off

import numpy as np
from surface_files import read_result, read_surface
from uv_measures import Invalid, measure


class ByHand(unittest.TestCase):
    def assert_measures(self, found, **expected):
        for key, value in expected.items():
            self.assertAlmostEqual(found[key], value, places=9, msg=key)

    def test_identity(self):
        points, faces = grid(2, 1)
        self.assert_measures(measure(points, faces, flat(points, faces)), charts=1, seam=0, uv_seam=6 / 2, E_mean=4, E_99=4,
                             E_max=4, flipped=0, overlaps=0, fill=0.5, area_discrepancy=0, angle_discrepancy=0, partuv_angle=1,
                             partuv_area=1, partuv_worst_chart=1)

    def test_stretched(self):
        """By 2 along one axis: 5 s + 1.25 / s is least at s = 1/2."""
        points, faces = grid(1, 1)
        angle = 2 * (math.atan(2) - math.pi / 4)
        self.assert_measures(measure(points, faces, flat(points, faces) * (2, 1)), E_mean=5, E_max=5, fill=0.5, uv_seam=3,
                             flipped=0, area_discrepancy=0, angle_discrepancy=angle, partuv_angle=1, partuv_area=1)

    def test_sheared(self):
        """(x + y, y): the images of the axes on the surface meet at 45 degrees; its norm is 3, its determinant 1."""
        points, faces = grid(1, 1)
        uv = flat(points, faces)
        uv[:, :, 0] += uv[:, :, 1]
        self.assert_measures(measure(points, faces, uv), E_mean=6, partuv_angle=1 - math.sqrt(0.5), area_discrepancy=0)

    def test_two_charts(self):
        """One square twice as large as the other: at the best common scale, both have the energy 5."""
        points, faces = grid(2, 1)
        uv = flat(points, faces)
        uv[2:] = 2 * uv[2:] + (1, 0)
        self.assert_measures(measure(points, faces, uv), charts=2, seam=1 / math.sqrt(5), uv_seam=12 / 5, E_mean=5, E_max=5,
                             overlaps=0, fill=5 / 25, area_discrepancy=0.6, angle_discrepancy=0, partuv_area=(2.5 + 1.6) / 2,
                             partuv_worst_chart=1)

    def test_quantile(self):
        """One of 100 squares is stretched: its two triangles have 1 % of the area."""
        points, faces = grid(100, 1)
        uv = flat(points, faces)
        uv[-2:] = (uv[-2:] - (99, 0)) * (1, 3) + (200, 0)
        found = measure(points, faces, uv)
        self.assertLess(found["E_99"], 4.1)
        self.assertGreater(found["E_max"], 6)

    def test_flips(self):
        """A fan whose center leaves its square has one triangle less that is not flipped; a mirrored chart has none."""
        points = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 0)], float)
        faces = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])
        moved = points.copy()
        moved[4] = (0.5, 1.5, 0)
        found = measure(points, faces, flat(moved, faces))
        self.assert_measures(found, charts=1, flipped=1)
        self.assertGreater(found["overlaps"], 0)
        for mirrored in (flat(points, faces) * (-1, 1), np.where(np.arange(4)[:, None, None] < 2, 1, -1) * flat(points, faces)):
            self.assert_measures(measure(points, faces, mirrored), flipped=0, E_mean=4)
        moved[4] = (0.5, 0, 0)
        self.assert_measures(measure(points, faces, flat(moved, faces)), flipped=1, overlaps=0)

    def test_opposite_faces(self):
        """A face that is given from its back is part of the chart, and not flipped."""
        points, faces = grid(2, 1)
        faces[1] = faces[1][::-1]
        self.assert_measures(measure(points, faces, flat(points, faces)), charts=1, flipped=0, seam=0, E_mean=4)

    def test_three_faces_at_an_edge(self):
        """Two of them stay together, so that the edge is cut once; the wing is a chart of its own."""
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], float)
        faces = np.array([(0, 1, 2), (1, 0, 3), (0, 1, 4)])
        uv = flat(points, faces)
        uv[2] = [(3, 0), (4, 0), (3, 1)]
        self.assert_measures(measure(points, faces, uv), charts=2, seam=1 / math.sqrt(1 + 4 + 1), overlaps=0, E_mean=4)

    def test_no_map(self):
        points, faces = grid(1, 1)
        for uv in (flat(points, faces) * 0, flat(points, faces) * np.nan):
            with self.assertRaises(Invalid):
                measure(points, faces, uv)


class AgainstTheReport(Case):
    """Whose measures come from the library."""

    def test_spheres(self):
        self.write("a.off", to_off(joined(sphere(3), scaled(sphere(2), 2))))
        run = self.unwrap("a.off", "-o", "out.obj", "--quiet", "--effort", "fast", "--json", "-")
        self.assertEqual(run.returncode, 0)
        report = json.loads(run.stdout)
        points, faces = read_surface(self.folder / "a.off")
        found = measure(points, faces, read_result(self.folder / "out.obj", faces))
        self.assertEqual((found["charts"], found["flipped"], found["overlaps"]), (report["charts"], 0, 0))
        self.assertEqual(found["charts"], 2)
        for key, expected in (("seam", report["cut_length"]), ("E_mean", report["E_iso"]), ("E_max", report["E_max"]),
                              ("E_chart", max(chart["mean"] for chart in report["charts_distortion"])),
                              ("E_99", report["E_quantiles"]["0.99"]),
                              ("area_discrepancy", report["distortion"]["average_area_discrepancy"]),
                              ("angle_discrepancy", report["distortion"]["average_angle_discrepancy"])):
            self.assertAlmostEqual(found[key] / expected, 1, places=9, msg=key)


if __name__ == "__main__":
    main()
