#!/usr/bin/env python3
"""Judges the search on meshes: prints, for each, what it minimizes, and how it does with bounds:

    scripts/search_quality.py MESH_OR_FOLDER... [--program PROGRAM] [--bounds B,...] [--options "..."] [--record FILE.json]
    scripts/search_quality.py MESH_OR_FOLDER... --compare FORMER.json [--shuffled SEED]

For each run: length over the bounding box diagonal, mean energy, their sum (energy + 0.15 length), seconds of CPU, and
unknowns factorized, which do not depend on the machine. The last line tells where a bound leads to a smaller sum than none,
by how much at most. `--compare` prints ratios to a record of another version or of other options: lengths at bounds,
differences of sums without, and unknowns. `--shuffled` numbers vertices and faces of OFF and OBJ anew, which should not
matter."""

import argparse
import json
import math
import pathlib
import random
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXCHANGE_RATE = 0.15  # energy per bounding box diagonal, the default of the program


def meshes_of(names):
    for name in map(pathlib.Path, names):
        if name.is_dir():
            yield from sorted(p for p in name.iterdir() if p.suffix in (".off", ".obj", ".ply", ".stl"))
        else:
            yield name


def polygons_of(mesh):
    lines = [words for line in mesh.read_text().splitlines() if (words := line.split("#")[0].split())]
    if mesh.suffix == ".obj":
        return ([words[1:4] for words in lines if words[0] == "v"],
                [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[0] == "f"])
    vertices, faces = map(int, lines[1][:2])
    return ([words[:3] for words in lines[2:2 + vertices]],
            [list(map(int, words[1:1 + int(words[0])])) for words in lines[2 + vertices:2 + vertices + faces]])


def write_shuffled(mesh, seed, folder):
    """The same surface with vertices, faces, and first corners of faces in another order, as OFF."""
    points, faces = polygons_of(mesh)
    numbers = random.Random(seed)
    order = numbers.sample(range(len(points)), len(points))
    place = {v: i for i, v in enumerate(order)}
    faces = [[place[v] for v in face[k:] + face[:k]] for face in numbers.sample(faces, len(faces))
             for k in [numbers.randrange(len(face))]]
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(points[v]) for v in order),
             *(f"{len(face)} {' '.join(map(str, face))}" for face in faces)]
    copy = pathlib.Path(folder) / "mesh.off"
    copy.write_text("\n".join(lines) + "\n")
    return copy


def run(program, mesh, options, seed=None):
    with tempfile.TemporaryDirectory() as folder:
        mesh = mesh if seed is None else write_shuffled(mesh, seed, folder)
        process = subprocess.run([program, mesh.resolve(), "-o", "out.obj", "--quiet", "--json", "-", "--threads", "1", *options],
                                 cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    report = json.loads(process.stdout)
    if report["E_iso"] is None:
        return {"status": report["status"]}
    return {"status": report["status"], "length": report["cut_length"], "energy": report["E_iso"],
            "sum": report["E_iso"] + EXCHANGE_RATE * report["cut_length"], "charts": report["charts"],
            "cpu": report["cpu_seconds"]["total"], "unknowns": report["factorized_unknowns"]["total"]}


def text(result):
    if "sum" not in result:
        return f"{result['status']:>40}"
    return (f"{result['sum']:9.4f} {result['energy']:8.4f} {result['length']:7.3f} {result['cpu']:6.1f} s"
            f" {result['unknowns'] / 1e6:6.2f}")


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else math.nan


def compare(results, former, bounds):
    for bound in bounds:
        pairs = [(results[m][bound], former[m][bound]) for m in results if bound in former.get(m, {})]
        pairs = [(new, old) for new, old in pairs if new["status"] == old["status"] == "done"]
        if not pairs:
            continue
        length = math.exp(mean(math.log(new["length"] / old["length"]) for new, old in pairs if min(new["length"], old["length"]) > 0))
        work = sum(new["unknowns"] for new, _ in pairs) / sum(old["unknowns"] for _, old in pairs)
        differences = [new["sum"] - old["sum"] for new, old in pairs]
        print(f"bound {bound or 'none'}: {len(pairs)} meshes, length times {length:.4f}, sum {mean(differences):+.4f}"
              f" (largest difference {max(map(abs, differences)):.4f}), work times {work:.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--program", default=ROOT / "build/bin/unwrap")
    parser.add_argument("--bounds", default="4.02,4.1,4.3", help="with commas; empty: none")
    parser.add_argument("--options", default="", help="of all runs")
    parser.add_argument("--shuffled", type=int, metavar="SEED")
    parser.add_argument("--record")
    parser.add_argument("--compare")
    given = parser.parse_args()
    bounds = ["", *filter(None, given.bounds.split(","))]
    results, worst = {}, (0, "nowhere", "")
    print(f"{'mesh':24} bound       sum   energy  length      CPU  million unknowns")
    for mesh in meshes_of(given.meshes):
        runs = results[mesh.name] = {}
        for bound in bounds:
            options = [*shlex.split(given.options), *(["--max-distortion", bound] if bound else [])]
            runs[bound] = run(given.program, mesh, options, given.shuffled)
            print(f"{mesh.name:24} {bound or 'none':6}{text(runs[bound])}", flush=True)
            if bound and "sum" in runs[bound] and "sum" in runs[""]:
                worst = max(worst, (runs[""]["sum"] - runs[bound]["sum"], mesh.name, bound))
    for bound in bounds:
        found = [runs[bound] for runs in results.values() if "sum" in runs[bound]]
        if found:
            print(f"{'mean':24} {bound or 'none':6}" + text({key: mean(r[key] for r in found) for key in found[0] if key != "status"}))
    print(f"a bound leads to a smaller sum by {worst[0]:.4f} at most: {worst[1]} {worst[2]}")
    if given.record:
        pathlib.Path(given.record).write_text(json.dumps(results, indent=1) + "\n")
    if given.compare:
        compare(results, json.loads(pathlib.Path(given.compare).read_text()), bounds)
    return 0


if __name__ == "__main__":
    sys.exit(main())
