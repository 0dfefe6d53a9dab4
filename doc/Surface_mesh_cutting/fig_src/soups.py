"""Small polygon soups, each with one thing that needs an interpretation."""

import math

from mesh_files import fan


def grid(columns, rows, point):
    """quadrilaterals over [0, 1] x [0, 1]"""
    points = [point(i / columns, j / rows) for i in range(columns + 1) for j in range(rows + 1)]
    corner = lambda i, j: i * (rows + 1) + j
    faces = [(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))
             for i in range(columns) for j in range(rows)]
    return points, faces


def welded(*soups):
    """several soups as one, equal points as one; corners that repeat the one before are dropped"""
    indices, faces = {}, []
    for points, polygons in soups:
        for polygon in polygons:
            face = [indices.setdefault(tuple(round(x, 9) for x in points[v]), len(indices)) for v in polygon]
            faces.append([v for k, v in enumerate(face) if v != face[k - 1]])
    return list(indices), faces


def triangulated(soup):
    points, faces = soup
    return points, [triangle for face in faces for triangle in fan(face)]


def saddle():
    return grid(10, 10, lambda x, y: (x - 0.5, y - 0.5, 0.8 * ((x - 0.5) ** 2 - (y - 0.5) ** 2)))


def sheets(number=3, columns=8, rows=6):
    """that meet along a line"""
    def sheet(turn):
        return grid(columns, rows, lambda x, y: (x * math.cos(turn), x * math.sin(turn), y))
    return welded(*(sheet(2 * math.pi * (0.1 + i / number)) for i in range(number)))


def cones(sides=20, rows=6):
    """that touch at their tips"""
    def cone(sign):
        return grid(sides, rows, lambda x, y: (0.6 * y * math.cos(2 * math.pi * x), 0.6 * y * math.sin(2 * math.pi * x),
                                               sign * y))
    return welded(cone(1), cone(-1))


def turned(columns=12, rows=10):
    """A dome, some faces of which are turned over."""
    points, faces = welded(grid(columns, rows, lambda x, y: (math.cos(math.pi * x),
                                                             math.sin(math.pi * x) * math.cos(math.pi * y),
                                                             math.sin(math.pi * x) * math.sin(math.pi * y))))
    return points, [f[::-1] if (7 * i) % 11 < 3 else f for i, f in enumerate(faces)]


def strip(columns=40, rows=5):
    """a Moebius strip"""
    def point(x, y):
        angle, width = 2 * math.pi * x, 0.8 * (y - 0.5)
        radius = 1 + width * math.cos(angle / 2)
        return radius * math.cos(angle), radius * math.sin(angle), width * math.sin(angle / 2)
    return welded(grid(columns, rows, point))


def pieces():
    """The triangles of a box, each with points of its own."""
    sides = [grid(4, 4, side) for side in (
        lambda x, y: (x, y, 1), lambda x, y: (y, x, 0), lambda x, y: (x, 0, y), lambda x, y: (y, 1, x),
        lambda x, y: (0, y, x), lambda x, y: (1, x, y))]
    points, faces = triangulated(welded(*sides))
    return [points[v] for f in faces for v in f], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))]


def write_off(file, soup):
    points, faces = soup
    with open(file, "w") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines(" ".join(map(str, p)) + "\n" for p in points)
        out.writelines(" ".join(map(str, (len(f), *f))) + "\n" for f in faces)
