"""Overlaps of triangles, decided exactly: by hand, and by clipping one with the other in rational numbers."""

import random
import unittest
from fractions import Fraction

from comparison import flat, grid
from support import main

import numpy as np
from uv_overlaps import box_pairs, overlapping_pairs


def clipped_area(p, q):
    """The area that two counterclockwise triangles have in common."""
    polygon = p
    for a, b in zip(q, q[1:] + q[:1]):
        def side(c):
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        kept = []
        for c, d in zip(polygon, polygon[1:] + polygon[:1]):
            if side(c) >= 0:
                kept.append(c)
            if side(c) * side(d) < 0:
                t = side(c) / (side(c) - side(d))
                kept.append((c[0] + t * (d[0] - c[0]), c[1] + t * (d[1] - c[1])))
        polygon = kept
    return sum(c[0] * d[1] - c[1] * d[0] for c, d in zip(polygon, polygon[1:] + polygon[:1]))


def exact(triangle):
    points = [tuple(map(Fraction, point)) for point in triangle.tolist()]
    (ax, ay), (bx, by), (cx, cy) = points
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return None if area == 0 else points if area > 0 else points[::-1]


class Overlaps(unittest.TestCase):
    def test_neighbors(self):
        """Triangles that share sides, parts of sides, or corners."""
        points, faces = grid(9, 9)
        turn = np.array([(np.cos(0.3), np.sin(0.3)), (-np.sin(0.3), np.cos(0.3))])
        for uv in (flat(points, faces), flat(points, faces) @ turn):
            self.assertEqual(len(overlapping_pairs(uv)), 0)
        apart = np.array([[(0, 0), (1, 0), (0, 1)], [(1, -2), (1, 2), (2, 0)], [(0.25, 0), (0.5, -1), (0.75, 0)]], float)
        self.assertEqual(len(overlapping_pairs(apart)), 0)

    def test_one_digit(self):
        """Two triangles at a common line that floating point numbers cannot tell from it, and the next ones."""
        first = np.array([(0.1, 0.1), (0.7, 0.3), (0.1, 0.9)])
        middle = (first[0] + first[1]) / 2
        found = set()
        for steps in range(-3, 4):
            corner = np.array([middle[0], middle[1] + steps * np.spacing(middle[1])])
            pair = np.array([first, [corner, (0.5, -1), (0.6, -1)]])
            area = clipped_area(exact(pair[0]), exact(pair[1]))
            self.assertEqual(len(overlapping_pairs(pair)), int(area > 0), steps)
            found.add(area > 0)
        self.assertEqual(found, {False, True})

    def test_random(self):
        for seed in range(8):
            numbers = random.Random(seed)
            unit = numbers.choice([1.0, 0.1, 1 / 3])
            triangles = unit * np.array([[(numbers.randrange(12), numbers.randrange(12)) for _ in range(3)] for _ in range(25)])
            shapes = [exact(triangle) for triangle in triangles]
            expected = {(i, j) for i in range(25) for j in range(i)
                        if shapes[i] and shapes[j] and clipped_area(shapes[i], shapes[j]) > 0}
            found = [(max(pair), min(pair)) for pair in overlapping_pairs(triangles).tolist()]
            self.assertEqual(len(found), len(set(found)), f"seed {seed}")
            self.assertEqual(set(found), expected, f"seed {seed}")

    def test_boxes(self):
        numbers = np.random.default_rng(1)
        low = numbers.random((300, 2))
        high = low + numbers.random((300, 2)) ** 4
        expected = {(i, j) for i in range(300) for j in range(i)
                    if (np.maximum(low[i], low[j]) < np.minimum(high[i], high[j])).all()}
        found = [(int(max(pair)), int(min(pair))) for i, j in box_pairs(low, high) for pair in zip(i, j)]
        self.assertEqual(len(found), len(set(found)))
        self.assertEqual(set(found), expected)


if __name__ == "__main__":
    main()
