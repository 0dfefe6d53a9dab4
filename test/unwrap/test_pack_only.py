"""--pack-only: charts of the input are moved, turned and scaled, and nothing else."""

import math
import random

from atlas import charts_of, check_atlas
from support import Case, main, read_obj, sphere, to_off

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def patches(number, seed, is_mirrored=lambda i: False):
    """Quadrilaterals in space with texture coordinates anywhere, on top of each other."""
    numbers = random.Random(seed)
    lines, corners = [], []
    for i in range(number):
        size, angle, place = numbers.uniform(0.3, 2), numbers.uniform(0, 7), (numbers.uniform(-3, 3), numbers.uniform(-3, 3))
        for x, y in SQUARE:
            x, y = x * size * numbers.uniform(0.9, 1), y * size
            lines.append(f"v {x + 5 * i!r} {y!r} 0")
            u, v = math.cos(angle) * x - math.sin(angle) * y, math.sin(angle) * x + math.cos(angle) * y
            corners.append(f"vt {(-u if is_mirrored(i) else u) + place[0]!r} {v + place[1]!r}")
    lines += corners
    for i in range(number):
        lines.append("f " + " ".join(f"{4 * i + k + 1}/{4 * i + k + 1}" for k in range(4)))
    return "\n".join(lines) + "\n"


class PackOnly(Case):
    def check_similar(self, before, after, scale=None):
        """All distances of each chart are scaled by the same number, and no side changes; returns that number."""
        (_, uvs, faces), (_, moved, moved_faces) = read_obj(self.folder / before), read_obj(self.folder / after)
        chart = charts_of(moved_faces)
        self.assertEqual(len(set(charts_of(faces))), len(set(chart)))
        corners = {}
        for f, (face, other) in enumerate(zip(faces, moved_faces)):
            self.assertEqual([v for v, _ in face], [v for v, _ in other])
            corners.setdefault(chart[f], []).extend((uvs[a[1]], moved[b[1]]) for a, b in zip(face, other))
        for pairs in corners.values():
            (p, q), far = pairs[0], max(pairs, key=lambda pair: math.dist(pair[0], pairs[0][0]))
            number = math.dist(q, far[1]) / math.dist(p, far[0])
            scale = scale or number
            for r, s in pairs:
                self.assertAlmostEqual(math.dist(q, s), scale * math.dist(p, r), places=9)
                side = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
                self.assertAlmostEqual(side(q, far[1], s), scale ** 2 * side(p, far[0], r), places=9)
        return scale

    def test_patches(self):
        for is_mirrored in (lambda i: False, lambda i: i % 3 == 0):
            self.write("a.obj", patches(12, 1, is_mirrored))
            code, report = self.report("a.obj", "-o", "b.obj", "--pack-only")
            self.assertEqual((code, report["charts"], report["components"]), (0, 12, 12), report["message"])
            self.check_similar("a.obj", "b.obj")
            _, uvs, faces = read_obj(self.folder / "b.obj")
            check_atlas(self, uvs, faces, [0] * len(faces), 2, 1024)
            mirrored = 2 * sum(map(is_mirrored, range(12)))  # triangles
            self.assertEqual((report["flips"], report["overlaps"]), (mirrored, 0))
            self.assertEqual(any("clockwise" in warning for warning in report["warnings"]), mirrored > 0)

    def test_many_on_one_place(self):
        """They have millions of overlaps with each other, none of which counts."""
        self.write("a.obj", patches(5000, 3))
        code, report = self.report("a.obj", "-o", "b.obj", "--pack-only", "--effort", "fast")
        self.assertEqual((code, report["charts"], report["overlaps"]), (0, 5000, 0), report["message"])

    def test_given_density(self):
        """The texels of a unit of length on the surface, whatever the scale of the texture coordinates."""
        self.write("a.obj", patches(12, 2))
        code, report = self.report("a.obj", "-o", "b.obj", "--pack-only", "--texels-per-unit", "300", "--udim")
        self.assertEqual(code, 0, report["message"])
        self.assertGreater(report["pages"], 1)
        self.assertAlmostEqual(self.check_similar("a.obj", "b.obj") * 1024, 300, places=2)
        self.assertAlmostEqual(report["texels_per_unit"], 300, places=2)
        self.assertAlmostEqual(report["E_iso"], 4, places=6)

    def test_layout_of_the_program(self):
        self.write("a.off", to_off(sphere(2)))
        first = self.report("a.off", "-o", "a.obj")[1]
        code, again = self.report("a.obj", "-o", "b.obj", "--pack-only", "--margin", "20")
        self.assertEqual(code, 0, again["message"])
        self.check_similar("a.obj", "b.obj")
        self.assertAlmostEqual(again["cut_length"], first["cut_length"], places=9)
        self.assertAlmostEqual(again["E_iso"], first["E_iso"], delta=1e-3)
        self.assertLess(again["uv_scale"], first["uv_scale"])
        self.assertEqual((again["flips"], again["overlaps"], again["genus"], again["borders"]), (0, 0, 0, 0))

    def test_folded(self):
        """A chart that lies on itself stays so, and others keep away from all of it."""
        lines = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v 1 1 0", "v 5 0 0", "v 6 0 0", "v 5 1 0",
                 "vt 0 0", "vt 1 0", "vt 0 1", "vt 0.3 0.3", "f 1/1 2/2 3/3", "f 3/3 2/2 4/4", "f 5/1 6/2 7/3"]
        self.write("a.obj", "\n".join(lines) + "\n")
        code, report = self.report("a.obj", "-o", "b.obj", "--pack-only")
        self.assertEqual((code, report["charts"], report["flips"]), (0, 2, 1), report["message"])
        self.assertIsNone(report["E_iso"])
        self.check_similar("a.obj", "b.obj")
        _, uvs, faces = read_obj(self.folder / "b.obj")
        check_atlas(self, uvs, faces, [0] * len(faces), 2, 1024)

    def test_errors(self):
        self.write("a.off", to_off(sphere(1)))
        self.assert_refused(4, "a.off", "--pack-only")
        self.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 3 2 4\n")
        self.assertEqual(self.assert_refused(4, "a.obj", "--pack-only")["witness"], {"kind": "faces", "indices": [1]})
        self.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
        self.assert_refused(4, "b.obj", "--pack-only")
        self.assert_refused(2, "a.obj", "--pack-only", "--uv-scale", "surface")
        self.assert_refused(2, "a.obj", "--pack-only", "--must-cut", "uv")


main()
