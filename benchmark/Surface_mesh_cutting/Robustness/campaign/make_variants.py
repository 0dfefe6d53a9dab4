#!/usr/bin/env python3
"""Makes a data set of any size out of small meshes: each variant is one of them, stretched and bent.

  make_variants.py OUTPUT COUNT MESHES... [--largest FACES] [--seed N]

Reads OFF files of triangles, skips all others and those with more faces than allowed, and writes
OUTPUT/NAME_NUMBER.off. The same seed makes the same files.
"""

import argparse
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "corpus"))

from run_corpus import meshes_in  # noqa: E402


def read_off(file, largest):
    """Points and faces; None unless it is a plain OFF file of a moderate number of triangles."""
    try:
        lines = (line.split("#")[0].split() for line in file.read_text().splitlines())
        words = [word for line in lines for word in line]
        if words[0] != "OFF" or int(words[2]) > largest:
            return None
        vertices, faces = int(words[1]), int(words[2])
        numbers = words[4:]
        points = [tuple(map(float, numbers[3 * i:3 * i + 3])) for i in range(vertices)]
        rest = numbers[3 * vertices:]
        triangles = [tuple(map(int, rest[4 * i:4 * i + 4])) for i in range(faces)]
        is_plain = len(rest) == 4 * faces and faces > 0 and all(t[0] == 3 for t in triangles)
        return (points, [t[1:] for t in triangles]) if is_plain else None
    except (ValueError, IndexError, UnicodeDecodeError):
        return None


def bent(points, numbers):
    """The points, scaled along the axes by factors between 1/2 and 2 and moved by a wave."""
    low = [min(p[i] for p in points) for i in range(3)]
    size = max(max(p[i] for p in points) - low[i] for i in range(3)) or 1.
    scales = [2 ** numbers.uniform(-1, 1) for _ in range(3)]
    phase, amplitude = numbers.uniform(0, 2 * math.pi), 0.1 * size * numbers.random()
    for p in points:
        wave = amplitude * math.sin(phase + 4 * (p[0] - low[0]) / size)
        yield scales[0] * p[0], scales[1] * (p[1] + wave), scales[2] * p[2]


def write_off(file, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += (f"{x!r} {y!r} {z!r}" for x, y, z in points)
    lines += (f"3 {a} {b} {c}" for a, b, c in faces)
    file.write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("count", type=int)
    parser.add_argument("meshes", nargs="+", help="meshes, folders of meshes, or lists of meshes (.txt)")
    parser.add_argument("--largest", type=int, default=1000, metavar="FACES", help="default: %(default)s")
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    read = ((mesh.stem, read_off(mesh, arguments.largest)) for mesh in meshes_in(arguments.meshes)
            if mesh.suffix == ".off")
    sources = [(name, mesh) for name, mesh in read if mesh]
    if not sources:
        sys.exit("none of the meshes is small enough")
    arguments.output.mkdir(parents=True, exist_ok=True)
    numbers = random.Random(arguments.seed)
    for i in range(arguments.count):
        name, (points, faces) = sources[i % len(sources)]
        write_off(arguments.output / f"{name}_{i:04}.off", list(bent(points, numbers)), faces)


if __name__ == "__main__":
    main()
