"""Options --symmetry and --seam-smoothness, and what the report says of symmetry and seams."""

import math

from support import Case, cut_edges, main, sphere, to_off


def mirrored():
    """A body with two arms, which x -> -x maps to itself; moved off the origin along x."""
    points, faces = sphere(3)
    size = max(max(map(abs, p)) for p in points)

    def place(p):
        x, y, z = (c / size for c in p)
        reach = 1 + 1.5 * math.exp(-12 * (1 - abs(x))) + 0.4 * math.exp(-9 * (1 - y))
        return x * reach, y * reach, z * reach

    return [(x + 5, y, z) for x, y, z in map(place, points)], faces


class Symmetry(Case):
    def test_automatic(self):
        points, _ = mirrored()
        self.write("arms.off", to_off(mirrored()))
        for choice in ("auto", "x"):
            exit_code, report = self.report("arms.off", "--symmetry", choice)
            self.assertEqual(exit_code, 0, report["message"])
            self.assertEqual(report["overlaps"], 0)
            plane = report["symmetry"]
            self.assertEqual(list(plane), ["normal", "offset", "matched"])
            self.assertEqual(plane["matched"], 1)
            if choice == "x":
                self.assertLess(abs(plane["offset"] - 5), 1e-9)
                keys = {tuple(round(c, 6) + 0 for c in p): v for v, p in enumerate(points)}
                image = [keys[round(10 - x, 6) + 0, round(y, 6) + 0, round(z, 6) + 0] for x, y, z in points]
                cut = cut_edges(self.folder / "arms.uv.obj")
                self.assertGreater(len(cut), 10)
                self.assertEqual(cut, {frozenset(image[v] for v in edge) for edge in cut})

    def test_none(self):
        points, faces = mirrored()
        points = [(x + 0.8 * y * z * z + 0.7 * max(0, x - 5) * z, y + 0.5 * x * z, z + 0.3 * y * y) for x, y, z in points]
        self.write("skew.off", to_off((points, faces)))
        exit_code, report = self.report("skew.off", "--symmetry", "auto")
        self.assertEqual((exit_code, report["symmetry"]), (0, None))
        self.assertTrue(any("98 % are needed" in warning for warning in report["warnings"]), report["warnings"])
        self.assertIsNone(self.report("skew.off")[1]["symmetry"])

    def test_smoothness(self):
        self.write("arms.off", to_off(mirrored()))
        plain, smooth = (self.report("arms.off", "--seam-smoothness", s)[1] for s in ("0", "5"))
        self.assertLessEqual(smooth["seams"]["jaggedness"], plain["seams"]["jaggedness"])
        self.assertLessEqual(smooth["cut_length"], 1.05 * plain["cut_length"] + 1e-9)
        self.assertLessEqual(smooth["E_iso"], plain["E_iso"] + 0.0031)
        self.assertEqual(self.report("arms.off")[1]["seams"], self.report("arms.off", "--seam-smoothness", "1")[1]["seams"])

    def test_seams(self):
        self.write("arms.off", to_off(mirrored()))
        seams = self.report("arms.off")[1]["seams"]
        self.assertEqual(list(seams), ["jaggedness", "compactness", "convexity", "on_hard_edges", "hidden"])
        for key, value in seams.items():
            self.assertTrue(0 <= value <= (math.pi if key == "jaggedness" else 1), key)

    def test_usage(self):
        self.write("arms.off", to_off(sphere(1)))
        for options in (["--symmetry", "w"], ["--symmetry"], ["--seam-smoothness", "-1"], ["--seam-smoothness", "101"]):
            self.assert_refused(2, "arms.off", *options)


main()
