"""What is not quite a surface: repeated corners, holes with bridges, sheets with two sides, and points to be welded."""

import math
from fractions import Fraction

from support import Case, main, read_obj, selection, to_glb, to_obj, to_off

CUBE = [(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
CUBE_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
PLATE = ([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0)],
         [(0, 1, 2, 3, 0, 4, 7, 6, 5, 4)])


def area(outline):
    return sum(Fraction(p[0]) * Fraction(q[1]) - Fraction(q[0]) * Fraction(p[1])
               for p, q in zip(outline, outline[1:] + outline[:1])) / 2


def halved_quads(m, n):
    """A sheet that is not flat."""
    points = [(i, j, 0.1 * i * j) for i in range(m + 1) for j in range(n + 1)]
    faces = []
    for i in range(m):
        for j in range(n):
            a, b = (n + 1) * i + j, (n + 1) * (i + 1) + j
            faces += [(a, b, b + 1), (a, b + 1, a + 1)]
    return points, faces


def flat_shaded_torus(m, n):
    """Each quadrilateral has points of its own, which its two triangles share."""
    def point(i, j):
        a, b = 2 * math.pi * (i % m) / m, 2 * math.pi * (j % n) / n
        return ((2 + math.cos(b)) * math.cos(a), (2 + math.cos(b)) * math.sin(a), math.sin(b))

    points, faces = [], []
    for i in range(m):
        for j in range(n):
            k = len(points)
            points += [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)]
            faces += [(k, k + 1, k + 2), (k, k + 2, k + 3)]
    return points, faces


class Soups(Case):
    def layout(self, mesh, *options):
        """The report, and the texture points of the corners of all faces, by an own reading of the output."""
        self.write("in.obj", to_obj(mesh))
        exit_code, report = self.report("in.obj", "-o", "out.obj", *options)
        self.assertEqual((exit_code, report["flips"], report["overlaps"]), (0, 0, 0), report["message"])
        points, uvs, faces = read_obj(self.folder / "out.obj")
        self.assertEqual(len(points), len(mesh[0]))
        self.assertEqual([tuple(v for v, _ in face) for face in faces], [tuple(face) for face in mesh[1]])
        return report, [[uvs[uv] for _, uv in face] for face in faces]

    def interpreted(self, report):
        return {found["what"]: found["elements"] for found in report["interpreted"]}

    def test_triangles_written_as_quadrilaterals(self):
        tetrahedron = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
                       [(0, 2, 1, 1), (0, 1, 3, 3), (1, 1, 2, 3), (2, 0, 0, 3)])
        report, faces = self.layout(tetrahedron)
        self.assertEqual(self.interpreted(report), {"repeated_corners": [0, 1, 2, 3]})
        cube = (CUBE, [(0, 3, 2, 2), (0, 2, 1, 1, 1)] + CUBE_FACES[1:])
        report, others = self.layout(cube)
        self.assertEqual((report["borders"], self.interpreted(report)), (0, {"repeated_corners": [0, 1]}))
        for mesh, layout in ((tetrahedron, faces), (cube, others)):
            for face, outline in zip(mesh[1], layout):
                self.assertGreater(area(outline), 0)
                for k, v in enumerate(face):
                    if v == face[k - 1]:
                        self.assertEqual(outline[k], outline[k - 1])
        self.assert_refused(4, "in.obj", "--strict")

    def test_hole_with_a_bridge(self):
        report, [outline] = self.layout(PLATE, "--uv-scale", "surface")
        self.assertEqual((report["components"], report["borders"], self.interpreted(report)), (1, 2, {}))
        self.assertAlmostEqual(report["E_iso"], 4)
        self.assertAlmostEqual(float(area(outline)), 12)
        self.write("bridge.txt", selection(edges=[(0, 4)]))
        for option, cut in (("--never-cut", []), ("--must-cut", [(0, 4)])):
            with self.subTest(option=option):
                self.write("in.obj", to_obj(PLATE))
                exit_code, report = self.report("in.obj", "-o", "out.obj", option, "bridge.txt", "--html", "a.html")
                if option == "--never-cut":  # the bridge is the only edge
                    self.assertEqual(exit_code, 4)
                else:
                    self.assertEqual((exit_code, report["charts"]), (0, 1), report["message"])
        # A box whose top and bottom have a hole each, with walls between these.
        points = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (3, 1), (3, 3), (1, 3))]
        top = tuple(v + 8 for v in PLATE[1][0])
        faces = [top, PLATE[1][0][::-1]]
        for k in range(4):
            after = (k + 1) % 4
            faces += [(k, after, 8 + after, 8 + k), (4 + after, 4 + k, 12 + k, 12 + after)]
        report, layout = self.layout((points, faces))
        self.assertEqual((report["genus"], report["borders"], self.interpreted(report)), (1, 0, {}))
        self.assertTrue(all(area(outline) > 0 for outline in layout))

    def test_visits_of_a_vertex(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 0, 0), (-1, -1, 0)]
        report, [outline] = self.layout((points, [(0, 1, 2, 0, 3, 4)]))
        self.assertEqual(self.interpreted(report)["divided_faces"], [0])
        self.assertGreater(area(outline[:3]), 0)
        self.assertGreater(area(outline[3:]), 0)
        report, layout = self.layout((points, [(0, 1, 2), (1, 0, 1, 3), (2, 2, 1)]))
        self.assertEqual(self.interpreted(report), {"degenerate_faces": [1, 2]})
        report, layout = self.layout((points, [(0, 1, 2), (0, 3, 4), (1, 2, 0)]))
        self.assertEqual(self.interpreted(report)["duplicate_faces"], [2])
        self.assertIn("1 face repeats a former one and lies on the same texture coordinates; the first is face 2",
                      report["warnings"])
        self.assertEqual(layout[2], layout[0][1:] + layout[0][:1])

    def test_front_and_back(self):
        points, faces = halved_quads(8, 4)
        for back in ([face[::-1] for face in faces], [(b, a, c) for a, b, c in reversed(faces)]):
            report, layout = self.layout((points, faces + back))
            self.assertEqual((report["charts"], report["components"]), (2, 2))
            self.assertTrue(all(area(outline) > 0 for outline in layout))
            self.assertEqual([w for w in report["warnings"] if "same point" in w], [])
        self.write("cape.glb", to_glb(points, faces + back))
        self.assertEqual(self.report("cape.glb", "-o", "out.glb")[1]["charts"], 2)

    def test_flat_shading_is_welded(self):
        mesh = flat_shaded_torus(12, 8)
        report, _ = self.layout(mesh, "--effort", "fast")
        self.assertEqual((report["components"], report["genus"]), (1, 1))
        report, _ = self.layout(mesh, "--effort", "fast", "--weld", "off")
        self.assertEqual(report["components"], 96)
        self.assertEqual([w for w in report["warnings"] if "--weld" in w],
                         ["288 vertices are at the same point as another one; with --weld on, the surface has "
                          "1 piece instead of 96"])
        # Two halves of a sheet that were separated on purpose stay apart, with a word on it.
        points, faces = halved_quads(6, 6)
        copies = len(points)
        apart = [face if k < 36 else tuple(v + copies for v in face) for k, face in enumerate(faces)]
        report, _ = self.layout((points + points, apart))
        self.assertEqual(report["components"], 2)
        self.assertTrue(any("with --weld on, the surface has 1 piece instead of 2" in w for w in report["warnings"]))

    def test_tolerance(self):
        points, faces = flat_shaded_torus(12, 8)
        moved = [tuple(x + 1e-7 * math.sin(1e3 * k + i) for i, x in enumerate(p)) for k, p in enumerate(points)]
        report, _ = self.layout((moved, faces), "--effort", "fast")
        self.assertEqual(report["components"], 96)
        self.assertTrue(any("with --weld-tolerance 1e-07, the surface has 1 piece instead of 96" in w
                            for w in report["warnings"]), report["warnings"])
        for tolerance, components in (("1e-9", 96), ("1e-6", 1), ("0.001", 1)):
            report, _ = self.layout((moved, faces), "--effort", "fast", "--weld-tolerance", tolerance)
            self.assertEqual(report["components"], components)
        for arguments in (("--weld-tolerance", "-1"), ("--weld-tolerance", "nan"), ("--weld-tolerance", "0.5"),
                          ("--weld-tolerance", "1e-6", "--weld", "off")):
            self.assert_refused(2, "in.obj", *arguments)

    def test_points_that_no_face_uses(self):
        for x in ("nan", "inf", "-inf"):
            text = to_obj((CUBE, CUBE_FACES)).replace("f ", f"v {x} 0 {x}\nf ", 1)
            self.write("in.obj", text)
            exit_code, report = self.report("in.obj", "-o", "out.obj", "--html", "a.html", "--svg", "a.svg")
            self.assertEqual((exit_code, report["vertices"]), (0, 9), report["message"])
            lines = (self.folder / "out.obj").read_text().splitlines()
            self.assertEqual([line for line in lines if line.startswith("v ")][8].split()[1].lower(), x)
            self.write("in.off", to_off((CUBE + [(1, 2, 3)], CUBE_FACES)).replace("1 2 3\n", f"1 {x} 3\n", 1))
            self.assertEqual(self.report("in.off", "-o", "out.obj")[0], 0)
            self.write("used.obj", text.replace("f 1 ", "f 9 1 ", 1))
            self.assert_refused(4, "used.obj", "-o", "other.obj")


main()
