#!/usr/bin/env python3
"""How much results depend on what should not matter: where the surface is turned, its unit, the numbers of vertices and faces,
and which side is up:

    scripts/invariance.py MESH_OR_FOLDER... [--bound B] [--rotations N] [--options "..."] [--jobs N]

compares, for each mesh, its copies with it: lengths at the bound, and without a bound lengths, energies, and their sum (energy +
0.15 length). Lengths are in diagonals of the bounding box of the given mesh, which does not turn with the copies; what the program
minimizes is in those of the copy."""

import argparse
import concurrent.futures
import dataclasses
import math
import pathlib
import random
import shlex
import statistics
import tempfile

from search_quality import EXCHANGE_RATE, ROOT, meshes_of, polygons_of, run, write_shuffled

KINDS = ("rotated", "scaled", "renumbered", "reversed")


@dataclasses.dataclass
class Copy:
    kind: str  # "" for the mesh itself
    path: pathlib.Path
    unit: float  # that of the lengths in its report, in diagonals of the mesh


def random_rotation(numbers):
    """A matrix, from a quaternion of any direction."""
    a, b, c, d = (numbers.gauss(0, 1) for _ in range(4))
    n = 2 / (a * a + b * b + c * c + d * d)
    return ((1 - n * (c * c + d * d), n * (b * c - a * d), n * (b * d + a * c)),
            (n * (b * c + a * d), 1 - n * (b * b + d * d), n * (c * d - a * b)),
            (n * (b * d - a * c), n * (c * d + a * b), 1 - n * (b * b + c * c)))


def diagonal(points):
    return math.dist(*([pick(axis) for axis in zip(*points)] for pick in (min, max)))


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(map(repr, p)) for p in points),
             *(f"{len(face)} {' '.join(map(str, face))}" for face in faces)]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_copies(mesh, folder, rotations, seed=0):
    """The mesh itself comes first."""
    numbers, folder = random.Random(seed), pathlib.Path(folder)
    points, faces = polygons_of(mesh)
    points = [tuple(map(float, p)) for p in points]
    size, factor = diagonal(points), 1 / 3
    copies = [Copy("", write_off(folder / f"{mesh.stem}.off", points, faces), 1)]
    for i in range(rotations):
        matrix = random_rotation(numbers)
        turned = [tuple(sum(x * y for x, y in zip(row, p)) for row in matrix) for p in points]
        copies.append(Copy("rotated", write_off(folder / f"{mesh.stem}_rotated_{i}.off", turned, faces), diagonal(turned) / size))
    scaled = [tuple(factor * x for x in p) for p in points]
    copies.append(Copy("scaled", write_off(folder / f"{mesh.stem}_scaled.off", scaled, faces), 1))
    shuffled = write_shuffled(copies[0].path, seed, folder).rename(folder / f"{mesh.stem}_renumbered.off")
    copies.append(Copy("renumbered", shuffled, 1))
    copies.append(Copy("reversed", write_off(folder / f"{mesh.stem}_reversed.off", points, [face[::-1] for face in faces]), 1))
    return copies


def differences(copies, found):
    """{kind: [(relative of length, of energy, of the sum)]} from (length, energy) of each copy."""
    length, energy = found[0]
    result = {}
    for copy, (other_length, other_energy) in zip(copies[1:], found[1:]):
        other_length *= copy.unit
        change = other_length - length
        result.setdefault(copy.kind, []).append((change / length if length else float(change != 0), other_energy - energy,
                                                 other_energy - energy + EXCHANGE_RATE * change))
    return result


def summary(rows):
    """Mean and largest size of each of the columns."""
    return [(statistics.fmean(sizes), max(sizes)) for sizes in (list(map(abs, column)) for column in zip(*rows))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", help="OFF and OBJ files, and folders of them")
    parser.add_argument("--program", default=ROOT / "build/bin/unwrap")
    parser.add_argument("--bound", default="4.1")
    parser.add_argument("--rotations", type=int, default=3, help="of each mesh; default: %(default)s")
    parser.add_argument("--options", default="", help="of all runs")
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args()
    all_rows = {}
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for mesh in meshes_of(given.meshes):
            copies = write_copies(mesh, folder, given.rotations)
            for name, words in (f"bound {given.bound}", ["--max-distortion", given.bound]), ("no bound", []):
                options = [*shlex.split(given.options), *words]
                results = list(pool.map(lambda copy, options=options: run(given.program, copy.path, options), copies))
                if not all("sum" in result for result in results):
                    print(f"{mesh.name:24} {name}: {', '.join(result['status'] for result in results)}")
                    continue
                for kind, rows in differences(copies, [(r["length"], r["energy"]) for r in results]).items():
                    all_rows.setdefault((name, kind), []).extend(rows)
                    print(f"{mesh.name:24} {name:10} {kind:10} length up to {100 * summary(rows)[0][1]:5.2f} %, "
                          f"sum {summary(rows)[2][1]:.4f}", flush=True)
    for (name, kind), rows in sorted(all_rows.items()):
        length, energy, total = summary(rows)
        print(f"{name}, {kind}, {len(rows)} copies: length {100 * length[0]:.2f} % in the mean, {100 * length[1]:.2f} % at most; "
              f"energy {energy[0]:.4f} and {energy[1]:.4f}; sum {total[0]:.4f} and {total[1]:.4f}")


if __name__ == "__main__":
    main()
