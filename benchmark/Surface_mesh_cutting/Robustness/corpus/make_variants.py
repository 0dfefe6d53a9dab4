#!/usr/bin/env python3
"""Makes a data set of any size out of small meshes: each variant is one of them, stretched and bent.

  make_variants.py OUTPUT COUNT MESHES... [--largest FACES] [--seed N] [--kinds plain,soup,polygons]

Reads OFF files of triangles, skips all others and those with more faces than allowed, and writes
OUTPUT/NAME_NUMBER.off. The same seed makes the same files. Kinds take turns: `plain` is only moved; of a `soup`, some faces
are missing, some turned over, and some twice there; in `polygons`, pairs of neighbors are one face.
"""

import argparse
import math
import pathlib
import random
import sys

from off_files import write_off
from run_corpus import meshes_in


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


def soup(faces, numbers):
    """Of twenty faces, about one is missing, one turned over, and one twice there."""
    result = []
    for face in faces:
        chance = numbers.random()
        result += [] if chance < 0.05 else [face[::-1]] if chance < 0.1 else [face, face] if chance < 0.15 else [face]
    return result


def polygons(faces, numbers):
    """Pairs of neighbors become one face, where both are still free."""
    neighbors = {(face[k], face[k - 2]): i for i, face in enumerate(faces) for k in range(3)}
    result, used = [], set()
    for i, face in enumerate(faces):
        if i in used:
            continue
        used.add(i)
        k = numbers.randrange(3)
        a, b, c = face[k], face[k - 2], face[k - 1]
        j = neighbors.get((b, a))
        opposite = [v for v in faces[j] if v not in (a, b)] if j is not None and j not in used else []
        if len(opposite) == 1 and opposite[0] != c:
            used.add(j)
            face = (a, opposite[0], b, c)
        result.append(face)
    return result


KINDS = {"plain": lambda faces, numbers: faces, "soup": soup, "polygons": polygons}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("count", type=int)
    parser.add_argument("meshes", nargs="+", help="meshes, folders of meshes, or lists of meshes (.txt)")
    parser.add_argument("--largest", type=int, default=1000, metavar="FACES", help="default: %(default)s")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--kinds", default="plain", help="separated by commas; default: %(default)s")
    arguments = parser.parse_args()
    read = ((mesh.stem, read_off(mesh, arguments.largest)) for mesh in meshes_in(arguments.meshes)
            if mesh.suffix == ".off")
    sources = [(name, mesh) for name, mesh in read if mesh]
    if not sources:
        sys.exit("none of the meshes is small enough")
    arguments.output.mkdir(parents=True, exist_ok=True)
    kinds = [KINDS[kind] for kind in arguments.kinds.split(",")]
    numbers = random.Random(arguments.seed)
    for i in range(arguments.count):
        name, (points, faces) = sources[i // len(kinds) % len(sources)]
        points = list(bent(points, numbers))
        write_off(arguments.output / f"{name}_{i:04}.off", points, kinds[i % len(kinds)](faces, numbers))


if __name__ == "__main__":
    main()
