#!/usr/bin/env python3
"""Records what `unwrap` finds in forty runs, or compares that with a record made before:

    scripts/golden_record.py RECORD.json [--program PROGRAM] [--data FOLDER] [--only WORD] [--every N]
    scripts/golden_record.py RECORD.json --compare FORMER.json [--same cut|bytes]

The runs cover all efforts, bounds, maps with and without overlaps, the published method, handles, borders, soups, and one
and two threads. A record holds digests of the cut and of the mesh with its texture coordinates, the measures, and the
number of unknowns factorized. A comparison lists each run that differs, and fails if there is one: `bytes` (default)
compares both digests, `cut` the cut and the measures to nine digits, for changes that turn or move charts alone.
"""
import argparse
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

CLOSED = ["hand.off", "blobby.off", "cow.off", "bull.off"]
RUNS = [
    *((mesh, options) for mesh in CLOSED for options in ("", "--effort fast", "--max-distortion 4.2")),
    *((mesh, options) for mesh in CLOSED[:2] for options in (
        "--effort best", "--faithful", "--allow-overlap", "--max-distortion 4.05", "--effort fast --max-distortion 4.1",
        "--allow-overlap --max-distortion 4.1", "--edge-weights crease", "--connect exact --seed 3")),
    ("triceratops.off", "--max-distortion 4.1"), ("camel.off", "--effort fast"), ("armadillo.off", "--effort fast"),
    ("couplingdown.off", ""), ("couplingdown.off", "--effort fast --max-distortion 4.1"),
    ("turbine.off", "--effort fast"), ("cheese.off", "--effort fast --allow-overlap"),
    ("head.off", ""), ("elephant-with-holes.off", "--effort fast"), ("blobby_3cc.off", ""),
    ("pig.stl", "--effort fast"), ("quads_to_stitch.off", ""),
]


def measures(report):
    unknowns = report["factorized_unknowns"]["total"]
    return {"status": report["status"], "charts": report["charts"], "length": report["cut_length"],
            "E_iso": report["E_iso"], "E_max": report["E_max"], "factorized_unknowns": unknowns}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else None


def run(program, mesh, options, threads):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        output, cut, report = folder / "mesh.obj", folder / "cut.obj", folder / "report.json"
        subprocess.run([program, mesh, *options.split(), "-o", output, "--obj-cut", cut, "--json", report, "--quiet",
                        "--threads", str(threads)], check=False, stderr=subprocess.DEVNULL)
        return {**measures(json.loads(report.read_text())), "cut": digest(cut), "mesh": digest(output)}


def record(program, data, word, step):
    results = {}
    for number, (mesh, options) in enumerate(RUNS):
        name = f"{mesh} {options}".strip()
        if word not in name or number % step != 0:
            continue
        threads = 1 + number % 2
        results[name] = run(program, data / mesh, options, threads)
        print(f"{name} ({threads} threads): {results[name]['length']:.6f} at {results[name]['E_iso']:.6f}", flush=True)
    return results


def is_near(a, b):
    if isinstance(a, float) and isinstance(b, float):
        return abs(a - b) <= 1e-9 * max(abs(a), abs(b))
    return a == b


def difference(former, now, same):
    keys = ["cut", "mesh"] if same == "bytes" else ["cut", "charts", "status", "length", "E_iso"]
    return [key for key in keys if not is_near(former[key], now[key])]


def compare(former, results, same):
    changed = 0
    for name, now in results.items():
        keys = difference(former[name], now, same) if name in former else ["not recorded before"]
        if keys:
            changed += 1
            before = former.get(name, {"length": 0, "E_iso": 0, "factorized_unknowns": 0})
            print(f"{name}: {', '.join(keys)}; length {before['length']:.6f} -> {now['length']:.6f}, "
                  f"energy {before['E_iso']:.6f} -> {now['E_iso']:.6f}, "
                  f"unknowns {before['factorized_unknowns']} -> {now['factorized_unknowns']}")
    print(f"{len(results) - changed} of {len(results)} runs are the same")
    return changed == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("record", type=pathlib.Path, help="made, unless it is there and --compare is given")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "bin" / "unwrap")
    parser.add_argument("--data", type=pathlib.Path, default=ROOT / "build" / "data" / "meshes")
    parser.add_argument("--only", default="", metavar="WORD", help="the runs whose name holds it")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="of the runs, each Nth")
    parser.add_argument("--compare", type=pathlib.Path, metavar="FORMER.json")
    parser.add_argument("--same", choices=["cut", "bytes"], default="bytes")
    arguments = parser.parse_args()
    if not (arguments.compare and arguments.record.exists()):
        results = record(arguments.program, arguments.data, arguments.only, arguments.every)
        arguments.record.write_text(json.dumps(results, indent=1) + "\n")
    results = json.loads(arguments.record.read_text())
    if arguments.compare and not compare(json.loads(arguments.compare.read_text()), results, arguments.same):
        sys.exit(1)


if __name__ == "__main__":
    main()
