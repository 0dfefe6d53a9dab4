"""Unusual meshes are unwrapped, with a warning that says what is unusual about them."""

import math
from fractions import Fraction

from support import Case, joined, main, read_obj, sphere, to_off

SPHERE = sphere(2)


def with_point(mesh, vertex, point):
    points = list(mesh[0])
    points[vertex] = tuple(point)
    return points, mesh[1]


def between(p, q, share=0.5):
    return tuple(s + share * (t - s) for s, t in zip(p, q))


def split(mesh, share):
    """The first face is split at a point next to its first corner, on an edge up to `share` of its length."""
    points, (first, *faces) = mesh
    a, b, c = first
    new = between(between(points[a], points[b], share), points[c], share)
    v = len(points)
    return [*points, new], faces + [(a, b, v), (b, c, v), (c, a, v)]


def scaled(mesh, factor):
    return [tuple(factor * x for x in p) for p in mesh[0]], mesh[1]


def bipyramid(n):
    ring = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), 0) for i in range(n)]
    fans = [((i, (i + 1) % n, n), ((i + 1) % n, i, n + 1)) for i in range(n)]
    return ring + [(0, 0, 1), (0, 0, -1)], [face for fan in fans for face in fan]


def with_patch_at_point(mesh):
    """The neighbors of a vertex and their neighbors move to its place."""
    patch = {0}
    for _ in range(2):
        patch |= {v for face in mesh[1] if patch & set(face) for v in face}
    return [mesh[0][0] if v in patch else p for v, p in enumerate(mesh[0])], mesh[1]


def reversed_faces(mesh):
    return mesh[0], [(a, c, b) for a, b, c in mesh[1]]


def squashed(mesh, factor):
    return [(x, y, factor * z) for x, y, z in mesh[0]], mesh[1]


A, B, C = SPHERE[1][0]
UNUSUAL = {
    "isolated vertices": ([*SPHERE[0], (1e300, 0, 0)], SPHERE[1]),
    "edges of length zero": with_point(SPHERE, A, SPHERE[0][B]),
    "faces of (nearly) no area": with_point(SPHERE, A, between(SPHERE[0][B], SPHERE[0][C])),
    "angle below 0.01 degrees": split(SPHERE, 1e-5),
    "shorter than 1e-5": split(SPHERE, 1e-6),
    "at the same point": joined(SPHERE, ([(x - 10, y, z) for x, y, z in SPHERE[0]], SPHERE[1])),
    "1000 neighbors": bipyramid(1000),
    "inside out": reversed_faces(SPHERE),
    "extreme coordinates": scaled(SPHERE, 1e200),
}
OPTIONS = (["--effort", "fast"], [], ["--bijective"], ["--faithful"])


class Limits(Case):
    def assert_unwrapped(self, mesh, *options):
        """Exact and independent of the program: every triangle is counterclockwise."""
        self.write("a.off", to_off(mesh))
        exit_code, report = self.report("a.off", "-o", "out.obj", *options)
        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
        _, uvs, faces = read_obj(self.folder / "out.obj")
        exact = [tuple(map(Fraction, uv)) for uv in uvs]
        for face in faces:
            a, b, c = (exact[corner[1]] for corner in face)
            self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)
        return report

    def test_usual(self):
        self.assertEqual(self.assert_unwrapped(SPHERE)["warnings"], [])

    def test_unusual(self):
        for warning, mesh in UNUSUAL.items():
            for options in OPTIONS:
                with self.subTest(warning=warning, options=options):
                    report = self.assert_unwrapped(mesh, *options)
                    self.assertIn(warning, "\n".join(report["warnings"]))

    def test_many_neighbors(self):
        """Tutte's embedding collapses in floating point here."""
        for n in (30, 100, 300):
            for options in OPTIONS:
                with self.subTest(n=n, options=options):
                    self.assert_unwrapped(bipyramid(n), *options)

    def test_faces_at_a_point(self):
        for options in OPTIONS:
            with self.subTest(options=options):
                self.assert_unwrapped(with_patch_at_point(SPHERE), *options)

    def test_without_extent(self):
        """There is no map to be found, but the search for one ends."""
        for mesh in (scaled(SPHERE, 0), joined(SPHERE, scaled(SPHERE, 0))):
            for options in OPTIONS:
                with self.subTest(options=options):
                    self.write("a.off", to_off(mesh))
                    self.assertIn(self.unwrap("a.off", "-o", "out.obj", *options).returncode, (0, 5))

    def test_without_area(self):
        """Next to the size of the whole, all edges but those at one vertex vanish."""
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1e304)]
        for options in OPTIONS:
            with self.subTest(options=options):
                self.write("a.off", to_off((points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])))
                report = self.assert_refused(5, "a.off", "-o", "out.obj", *options)
                self.assertIsNone(report["E_iso"])

    def test_parts_of_different_size(self):
        """Next to the large one's, the UVs of the small one are held as long as they differ in their digits."""
        for factor, expected in ((1e-3, 0), (1e-9, 0), (1e-20, 4), (1e-150, 4)):
            for options in OPTIONS:
                with self.subTest(factor=factor, options=options):
                    self.write("a.off", to_off(joined(scaled(SPHERE, factor), SPHERE)))
                    if expected == 0:
                        exit_code, report = self.report("a.off", "-o", "out.obj", *options)
                        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
                    else:
                        report = self.assert_refused(4, "a.off", "-o", "out.obj", *options)
                        self.assertEqual(report["witness"], {"kind": "vertices", "indices": list(range(len(SPHERE[0])))})
                        self.assertEqual(report["seconds"]["filter"], 0)

    def test_scale_does_not_matter(self):
        expected = self.assert_unwrapped(SPHERE)
        for exponent in (-1000, -664, 664, 1000):
            with self.subTest(exponent=exponent):
                report = self.assert_unwrapped(scaled(SPHERE, 2.0 ** exponent))
                for key in ("E_iso", "E_max", "cut_length", "features"):
                    self.assertEqual(report[key], expected[key])

    def test_isolated_vertices_do_not_matter(self):
        isolated = self.assert_unwrapped(UNUSUAL["isolated vertices"])
        self.assertEqual(isolated["cut_length"], self.assert_unwrapped(SPHERE)["cut_length"])

    def test_squashed(self):
        for factor in (1e-3, 1e-6, 1e-12, 1e-30, 0):
            for options in OPTIONS:
                with self.subTest(factor=factor, options=options):
                    self.assert_unwrapped(squashed(SPHERE, factor), *options)

    def test_subnormal_numbers(self):
        for factor in (1e-309, 1e-315):
            with self.subTest(factor=factor):
                self.assert_unwrapped(scaled(SPHERE, factor))

    def test_failed_certificate(self):
        """The texture coordinates overflow: the certificate says so, and nothing is written."""
        self.write("a.off", to_off(scaled(SPHERE, 1e308)))
        report = self.assert_refused(5, "a.off", "-o", "out.obj", "--svg", "a.svg")
        self.assertIn("infinite", report["message"])
        self.assertEqual(report["witness"]["kind"], "faces")


main()
