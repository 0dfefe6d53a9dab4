"""Unusual meshes are unwrapped, with a warning that says what is unusual about them."""

import math

from support import EFFORTS, Case, joined, main, scaled, sphere

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


class Unusual(Case):
    def test_usual(self):
        self.assertEqual(self.assert_unwrapped(SPHERE)["warnings"], [])

    def test_unusual(self):
        for warning, mesh in UNUSUAL.items():
            for options in EFFORTS:
                with self.subTest(warning=warning, options=options):
                    report = self.assert_unwrapped(mesh, *options)
                    self.assertIn(warning, "\n".join(report["warnings"]))

    def test_many_neighbors(self):
        """Tutte's embedding collapses in floating point here."""
        for n in (30, 100, 300):
            for options in EFFORTS:
                with self.subTest(n=n, options=options):
                    self.assert_unwrapped(bipyramid(n), *options)

    def test_faces_at_a_point(self):
        for options in EFFORTS:
            with self.subTest(options=options):
                self.assert_unwrapped(with_patch_at_point(SPHERE), *options)

    def test_isolated_vertices_do_not_matter(self):
        isolated = self.assert_unwrapped(UNUSUAL["isolated vertices"])
        self.assertEqual(isolated["cut_length"], self.assert_unwrapped(SPHERE)["cut_length"])


main()
