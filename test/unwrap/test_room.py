"""Maps without overlaps are about as good as maps with them, and keep bounds, also where the plane is crowded."""

import math
from fractions import Fraction

from support import Case, main, read_obj, sphere, to_off

TOLERANCE = 0.02  # of the energy, between a map without overlaps and one with them


def plate(holes, step=3):
    """A wavy plate with `holes` x `holes` square windows: as many handles."""
    size = (2 * holes + 1) * step
    points, numbers, faces = [], {}, []

    def is_solid(i, j):
        return 0 <= i < size and 0 <= j < size and not (i // step % 2 and j // step % 2)

    def vertex(i, j, side):
        if (i, j, side) not in numbers:
            numbers[i, j, side] = len(points)
            x, y = i / step, j / step
            points.append((x, y, math.sin(1.3 * x) * math.cos(0.9 * y) + 0.4 * side))
        return numbers[i, j, side]

    for i in range(size):
        for j in range(size):
            if not is_solid(i, j):
                continue
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            for side in (1, -1):
                a, b, c, d = (vertex(*corner, side) for corner in corners[::side])
                faces += [(a, b, c), (a, c, d)]
            for k, (di, dj) in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)]):
                if not is_solid(i + di, j + dj):
                    p, q = corners[k], corners[(k + 1) % 4]
                    a, b, c, d = vertex(*p, 1), vertex(*q, 1), vertex(*q, -1), vertex(*p, -1)
                    faces += [(b, a, d), (b, d, c)]
    return points, faces


def limbs(number, length):
    """A ball with thin limbs in all directions, which bend."""
    points, faces = sphere(5)
    golden = math.pi * (3 - math.sqrt(5))
    axes = []
    for i in range(number):
        z = 1 - (2 * i + 1) / number
        axes.append((math.sqrt(1 - z * z) * math.cos(golden * i), math.sqrt(1 - z * z) * math.sin(golden * i), z))
    result = []
    for point in points:
        norm = math.hypot(*point)
        direction = [x / norm for x in point]
        cosine = max(sum(x * y for x, y in zip(direction, axis)) for axis in axes)
        rise = length * math.exp(-((1 - cosine) / 0.02))
        x, y, z = ((1 + rise) * d for d in direction)
        angle = 0.4 * rise
        result.append((x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle), z))
    return result, faces


def cross_product(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def crosses(uvs, faces):
    """Whether two border edges without a common end cross. Exact, over all pairs whose boxes meet."""
    edges = {(face[k][1], face[(k + 1) % 3][1]) for face in faces for k in range(3)}
    border = sorted((min(uvs[a][0], uvs[b][0]), a, b) for a, b in edges if (b, a) not in edges)
    exact = [tuple(map(Fraction, uv)) for uv in uvs]
    for i, (_, a, b) in enumerate(border):
        right = max(uvs[a][0], uvs[b][0])
        for left, c, d in border[i + 1:]:
            if left > right:
                break
            if len({a, b, c, d}) < 4 or max(uvs[a][1], uvs[b][1]) < min(uvs[c][1], uvs[d][1]) \
               or max(uvs[c][1], uvs[d][1]) < min(uvs[a][1], uvs[b][1]):
                continue
            p, q, r, s = exact[a], exact[b], exact[c], exact[d]
            if cross_product(p, q, r) * cross_product(p, q, s) <= 0 \
               and cross_product(r, s, p) * cross_product(r, s, q) <= 0:
                return True
    return False


def energy(points, uvs, faces):
    """The symmetric Dirichlet energy, averaged by area."""
    total = area = 0
    for face in faces:
        a, b, c = (points[corner[0]] for corner in face)
        p, q, r = (uvs[corner[1]] for corner in face)
        u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
        uu, uv, vv = (sum(x * y for x, y in zip(*pair)) for pair in ((u, u), (u, v), (v, v)))
        s, t = [y - x for x, y in zip(p, q)], [y - x for x, y in zip(p, r)]
        ss, st, tt = (sum(x * y for x, y in zip(*pair)) for pair in ((s, s), (s, t), (t, t)))
        squared = uu * vv - uv * uv
        norm = (vv * ss - 2 * uv * st + uu * tt) / squared
        ratio = (ss * tt - st * st) / squared
        total += math.sqrt(squared) * norm * (1 + 1 / ratio)
        area += math.sqrt(squared)
    return total / area


class Room(Case):
    def unwrapped(self, *options):
        exit_code, report = self.report("a.off", "-o", "out.obj", "--effort", "fast", "--uv-scale", "surface", *options)
        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
        points, uvs, faces = read_obj(self.folder / "out.obj")
        self.assertAlmostEqual(energy(points, uvs, faces), report["E_iso"], delta=1e-6)
        return report, crosses(uvs, faces)

    def test_without_overlaps_as_good_as_with_them(self):
        has_overlap = False
        for name, mesh in (("plate", plate(3)), ("limbs", limbs(12, 3))):
            with self.subTest(mesh=name):
                self.write("a.off", to_off(mesh))
                free, free_crosses = self.unwrapped("--allow-overlap")
                report, is_crossing = self.unwrapped()
                self.assertEqual((is_crossing, report["overlaps"]), (False, 0))
                self.assertLess(report["E_iso"], free["E_iso"] + TOLERANCE)
                self.assertLess(report["cut_length"], 1.25 * free["cut_length"])
                has_overlap = has_overlap or free_crosses
        self.assertTrue(has_overlap)  # otherwise the test is too easy

    def test_bounds_are_kept(self):
        self.write("a.off", to_off(plate(2)))
        for bound in (4.2, 4.1, 4.05):
            with self.subTest(bound=bound):
                report, is_crossing = self.unwrapped("--max-distortion", bound)
                self.assertFalse(is_crossing)
                self.assertLessEqual(report["E_iso"], bound)

    def test_threads_find_the_same(self):
        self.write("a.off", to_off(plate(2)))
        for bound in (4.1, 4.05):
            found = set()
            for threads in (1, 2, 3):
                report, _ = self.unwrapped("--threads", threads, "--max-distortion", bound)
                found.add(((self.folder / "out.obj").read_bytes(), str(report["tradeoff"])))
            self.assertEqual(len(found), 1, bound)

    def test_work_for_room_belongs_to_a_phase(self):
        self.write("a.off", to_off(plate(2)))
        report, _ = self.unwrapped("--threads", 1, "--max-distortion", 4.1)
        unknowns = dict(report["factorized_unknowns"])
        self.assertEqual(unknowns.pop("total"), sum(unknowns.values()))


if __name__ == "__main__":
    main()
