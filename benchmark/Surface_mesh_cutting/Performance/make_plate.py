#!/usr/bin/env python3
"""Makes a plate with round holes, tessellated as CAD programs do: no more vertices than the outlines need.

  make_plate.py OUT.off [--rows 7] [--columns 19] [--segments 32] [--radius 0.3] [--thickness 0.25]

One hole in each square of side 1, so that the genus is ROWS * COLUMNS.
"""
import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "Robustness" / "corpus"))

from off_files import write_off  # noqa: E402


def plate(rows, columns, segments, radius, thickness):
    """Points and triangles."""
    points, triangles = [], []
    corners = {}
    for side in (0, 1):
        for i in range(columns + 1):
            for j in range(rows + 1):
                corners[side, i, j] = len(points)
                points.append((i, j, side * thickness))

    def add(side, a, b, c):  # counterclockwise as seen from above
        triangles.append((a, b, c) if side == 1 else (a, c, b))

    for i in range(columns):
        for j in range(rows):
            circles = []
            for side in (0, 1):
                circles.append(range(len(points), len(points) + segments))
                for k in range(segments):
                    angle = 2 * math.pi * k / segments
                    points.append((i + 0.5 + radius * math.cos(angle), j + 0.5 + radius * math.sin(angle),
                                   side * thickness))
                square = [corners[side, i + x, j + y] for x, y in ((1, 1), (0, 1), (0, 0), (1, 0))]
                # The corner of a quarter of the square sees the eighths of the circle on both sides of it.
                for k in range(segments):
                    add(side, circles[side][k], square[4 * k // segments], circles[side][(k + 1) % segments])
                for k in range(4):
                    add(side, circles[side][k * segments // 4], square[k - 1], square[k])
            for k in range(segments):
                a, b = circles[0][k], circles[0][(k + 1) % segments]
                c, d = circles[1][k], circles[1][(k + 1) % segments]
                triangles += [(a, c, d), (a, d, b)]
    outline = [(i, 0) for i in range(columns)] + [(columns, j) for j in range(rows)] + \
              [(i, rows) for i in range(columns, 0, -1)] + [(0, j) for j in range(rows, 0, -1)]
    for p, q in zip(outline, outline[1:] + outline[:1]):
        a, b, c, d = corners[(0, *p)], corners[(0, *q)], corners[(1, *p)], corners[(1, *q)]
        triangles += [(a, b, d), (a, d, c)]
    return points, triangles


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("--rows", type=int, default=7)
    parser.add_argument("--columns", type=int, default=19)
    parser.add_argument("--segments", type=int, default=32, help="of a hole's outline, a multiple of 4")
    parser.add_argument("--radius", type=float, default=0.3)
    parser.add_argument("--thickness", type=float, default=0.25)
    options = parser.parse_args()
    write_off(options.out, *plate(options.rows, options.columns, options.segments, options.radius, options.thickness))


if __name__ == "__main__":
    main()
