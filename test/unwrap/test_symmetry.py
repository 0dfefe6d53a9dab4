"""Options --symmetry and --seam-smoothness, and what the report says of symmetry and seams."""

import math

from support import Case, cut_edges, main, read_obj, selection, sphere, to_off


def mirrored():
    """A body with two arms, which x -> -x maps to itself; moved off the origin along x."""
    points, faces = sphere(3)
    size = max(max(map(abs, p)) for p in points)

    def place(p):
        x, y, z = (c / size for c in p)
        reach = 1 + 1.5 * math.exp(-12 * (1 - abs(x))) + 0.4 * math.exp(-9 * (1 - y))
        return x * reach, y * reach, z * reach

    return [(x + 5, y, z) for x, y, z in map(place, points)], faces


def images_of(points, center=5):
    """The point to which x -> 2 * center - x takes each one."""
    keys = {tuple(round(c, 6) + 0 for c in p): v for v, p in enumerate(points)}
    return [keys[round(2 * center - x, 6) + 0, round(y, 6) + 0, round(z, 6) + 0] for x, y, z in points]


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
                image = images_of(points)
                cut = cut_edges(self.folder / "arms.uv.obj")
                self.assertGreater(len(cut), 10)
                self.assertEqual(cut, {frozenset(image[v] for v in edge) for edge in cut})

    def mirrored_uvs(self, name):
        """The UVs of each corner and of that to which it is mirrored."""
        points, uvs, faces = read_obj(self.folder / name)
        image = images_of(points)
        corners = {frozenset(v for v, _ in face): dict(face) for face in faces}
        return [(uvs[uv], uvs[corners[frozenset(image[w] for w, _ in face)][image[v]]]) for face in faces for v, uv in face]

    def plane(self):
        points, faces = mirrored()
        is_in_plane = [abs(x - 5) < 1e-9 for x, _, _ in points]
        edges = {frozenset(pair) for a, b, c in faces for pair in ((a, b), (b, c), (c, a)) if all(is_in_plane[v] for v in pair)}
        return [tuple(edge) for edge in edges]

    def test_upright(self):
        """One chart with a vertical axis; if it is divided there, two side by side."""
        self.write("arms.off", to_off(mirrored()))
        self.write("plane.selection.txt", selection(edges=self.plane()))
        for options, charts in (([], 1), (["--must-cut", "plane.selection.txt"], 2)):
            exit_code, report = self.report("arms.off", "--symmetry", "x", "--rotate", "upright", "--effort", "fast", *options)
            self.assertEqual((exit_code, report["charts"]), (0, charts), report["message"])
            pairs = self.mirrored_uvs("arms.uv.obj")
            middle = sum(pairs[0][k][0] for k in (0, 1)) / 2
            for (u, v), (other_u, other_v) in pairs:
                self.assertAlmostEqual(u + other_u, 2 * middle, delta=1e-6)
                self.assertAlmostEqual(v, other_v, delta=1e-6)
            if charts == 2:
                gap = 2 * min(abs(u - middle) for (u, _), _ in pairs)
                self.assertTrue(2 / 1024 <= gap < 5 / 1024, gap)

    def test_stacked_halves(self):
        points, faces = mirrored()
        self.write("arms.off", to_off((points, faces)))
        exit_code, report = self.report("arms.off", "--symmetry", "x", "--stack")
        self.assertEqual((exit_code, report["stacked"], report["charts"]), (0, [[0, 1]], 1), report["message"])
        self.assertEqual([report[key] for key in ("components", "genus", "borders", "overlaps")], [1, 0, 0, 0])
        self.assertEqual((report["symmetry"]["normal"], report["warnings"]), ([1, 0, 0], []))
        self.assertTrue(all(uv == other for uv, other in self.mirrored_uvs("arms.uv.obj")))
        cut, image = cut_edges(self.folder / "arms.uv.obj"), images_of(points)
        self.assertEqual(cut, {frozenset(image[v] for v in edge) for edge in cut})
        self.assertTrue({frozenset(edge) for edge in self.plane()} <= cut)
        _, uvs, faces = read_obj(self.folder / "arms.uv.obj")
        turns = set()  # of the faces on each side
        for face in faces:
            a, b, c = (uvs[uv] for _, uv in face)
            is_clockwise = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0
            turns.add((is_clockwise, sum(points[v][0] for v, _ in face) < 15))
        self.assertIn(turns, ({(False, False), (True, True)}, {(False, True), (True, False)}))
        whole = self.report("arms.off", "--symmetry", "x")[1]
        self.assertGreater(report["uv_scale"], 1.15 * whole["uv_scale"])

    def test_plane_never_to_cut(self):
        self.write("arms.off", to_off(mirrored()))
        self.write("plane.selection.txt", selection(edges=self.plane()[:1]))
        self.assert_refused(4, "arms.off", "--symmetry", "x", "--stack", "--never-cut", "plane.selection.txt")

    def test_nothing_to_stack(self):
        """No plane, and one that crosses faces."""
        points, faces = mirrored()
        points = [(x + 0.8 * y * z * z + 0.7 * max(0, x - 5) * z, y + 0.5 * x * z, z + 0.3 * y * y) for x, y, z in points]
        self.write("skew.off", to_off((points, faces)))
        exit_code, report = self.report("skew.off", "--symmetry", "auto", "--stack", "--effort", "fast")
        self.assertEqual((exit_code, report["stacked"], report["symmetry"]), (0, [], None))
        box = [(x, y, z) for z in (0, 1) for y in (0, 2) for x in (0, 3)]
        quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.write("box.off", to_off((box, quads)))
        exit_code, report = self.report("box.off", "--symmetry", "auto", "--stack")
        self.assertEqual((exit_code, report["stacked"], report["charts"]), (0, [], 1))
        self.assertTrue(any("crosses faces" in warning for warning in report["warnings"]), report["warnings"])

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
