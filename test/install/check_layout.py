"""Checks what the program in the README has written, exactly: check_layout.py UNWRAPPED.obj MESH.off

The surface is that of the mesh, each triangle of the layout is counterclockwise, all lie in the unit square, and no two
overlap."""

import sys
from fractions import Fraction
from itertools import combinations


def read_off(path):
    words = iter(open(path, encoding="ascii").read().split()[1:])
    points, faces, _ = (int(next(words)) for _ in range(3))
    return [tuple(float(next(words)) for _ in range(3)) for _ in range(points)], [
        tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(faces)]


def read_obj(path):
    rows = {"v": [], "vt": [], "f": []}
    for line in open(path, encoding="ascii"):
        kind, *words = line.split()
        rows[kind].append(words)
    corners = [[tuple(int(number) - 1 for number in word.split("/")) for word in words] for words in rows["f"]]
    uvs = [tuple(map(Fraction, words)) for words in rows["vt"]]
    return ([tuple(map(float, words)) for words in rows["v"]], [tuple(v for v, _ in face) for face in corners],
            [[uvs[uv] for _, uv in face] for face in corners])


def side(a, b, c):
    """Positive if c lies to the left of the line from a to b."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def overlap(one, other):
    """Whether the interiors of two counterclockwise triangles meet: no line along a side has them on different sides."""
    return not any(all(side(p[i - 1], p[i], q) <= 0 for q in r) for p, r in ((one, other), (other, one)) for i in range(3))


def overlapping_pairs(triangles, cells=64):
    """Triangles that meet share a cell of a grid."""
    grid = {}
    for triangle in triangles:
        low, high = ([int(cells * pick(p[axis] for p in triangle)) for axis in range(2)] for pick in (min, max))
        for x in range(low[0], high[0] + 1):
            for y in range(low[1], high[1] + 1):
                grid.setdefault((x, y), []).append(triangle)
    return sum(overlap(*pair) for cell in grid.values() for pair in combinations(cell, 2))


points, faces, triangles = read_obj(sys.argv[1])
assert (points, faces) == read_off(sys.argv[2]), "another surface"
assert all(0 <= x <= 1 for triangle in triangles for p in triangle for x in p), "outside of the unit square"
assert all(side(*triangle) > 0 for triangle in triangles), "a triangle is flipped"
assert overlap(triangles[0], triangles[0]) and overlapping_pairs(triangles) == 0, "triangles overlap"
print(f"{len(triangles)} triangles, no two of which overlap")
