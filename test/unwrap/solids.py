"""Simple solids with flat polygons as faces: points and faces, counterclockwise from outside."""

import itertools
import math


def extruded(outline, height, top=1):
    """A prism over a counterclockwise outline; its top face is scaled about the centroid of the corners."""
    n = len(outline)
    center = [sum(p[k] for p in outline) / n for k in (0, 1)]
    points = [(x, y, 0) for x, y in outline]
    points += [tuple(c + top * (p - c) for c, p in zip(center, q)) + (height,) for q in outline]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return points, [tuple(reversed(range(n))), tuple(range(n, 2 * n)), *sides]


def box(x, y, z):
    return extruded([(0, 0), (x, 0), (x, y), (0, y)], z)


def star(n, inner=1):
    """Corners on two circles in turn; a regular polygon if both are the same."""
    return [(r * math.cos(math.pi * i / n), r * math.sin(math.pi * i / n)) for i in range(2 * n)
            for r in ((1, inner)[i % 2],)]


def polygon(n):
    return [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]


def pyramid(n, height):
    points = [(x, y, 0) for x, y in polygon(n)] + [(0, 0, height)]
    return points, [tuple(reversed(range(n))), *((i, (i + 1) % n, n) for i in range(n))]


def stairs(n):
    outline = [(0, 0), (n, 0)]
    for i in range(n):
        outline += [(n - i, i + 1), (n - i - 1, i + 1)]
    return outline


def tetrahedron():
    return [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)]


def octahedron():
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = []
    for x, y, z in itertools.product((0, 1), (2, 3), (4, 5)):
        faces.append((x, y, z) if (x + y + z) % 2 == 0 else (y, x, z))
    return points, faces


L = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)]
T = [(0, 0), (3, 0), (3, 1), (2, 1), (2, 3), (1, 3), (1, 1), (0, 1)]
U = [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
CROSS = [(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)]

SOLIDS = {
    "cube": box(1, 1, 1), "tetrahedron": tetrahedron(), "octahedron": octahedron(),
    **{f"box {x} {y} {z}": box(x, y, z) for x, y, z in ((1, 1, 4), (1, 1, 0.2), (1, 2, 3), (5, 4, 1), (1, 1, 20),
                                                        (100, 60, 0.5))},
    **{f"prism {n} {h}": extruded(polygon(n), h) for n, h in ((3, 1.5), (5, 1.5), (6, 1.5), (6, 0.2), (6, 5), (8, 1.5),
                                                              (12, 1.5))},
    **{f"pyramid {n} {h}": pyramid(n, h) for n, h in ((3, 1.2), (4, 1), (4, 3), (5, 1), (8, 1.5))},
    **{f"frustum {n} {t}": extruded(polygon(n), 1, t) for n, t in ((3, 0.5), (4, 0.5), (6, 0.6), (4, 0.2))},
    "L": extruded(L, 1), "T": extruded(T, 1), "U": extruded(U, 1.5), "cross": extruded(CROSS, 0.7),
    **{f"stairs {n}": extruded(stairs(n), 2) for n in (3, 6)},
    **{f"star {n}": extruded(star(n, r), 0.6) for n, r in ((5, 0.5), (6, 0.6), (8, 0.7))},
}
