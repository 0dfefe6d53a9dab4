#!/usr/bin/env python3
"""Runs unwrap on many meshes, one process each, by GNU parallel, and prints a table of outcomes.

Each mesh adds one line to RESULTS (see run_mesh.py). Meshes that have a line with the same options
are not run again: an interrupted run goes on where it was, further meshes and options can be added.
For the results of another program use another file.

Other machines help over ssh (--sshlogin), if all see this folder, the program, the meshes and RESULTS at the same place;
run_corpus.sbatch does the same with Slurm.
"""

import argparse
import os
import pathlib
import subprocess
import sys

from outcomes import read_records, table

RUN_MESH = pathlib.Path(__file__).with_name("run_mesh.py")
SUFFIXES = {".off", ".obj", ".ply", ".stl", ".glb", ".gltf"}


def meshes_in(places):
    """Folders are searched; a text file lists meshes, one per line, relative to itself."""
    for place in map(pathlib.Path, places):
        if place.is_dir():
            yield from sorted(path for path in place.rglob("*") if path.suffix.lower() in SUFFIXES)
        elif place.suffix == ".txt":
            lines = map(str.strip, place.read_text().splitlines())
            yield from (place.parent / line for line in lines if line and not line.startswith("#"))
        else:
            yield place


def size(mesh):
    return mesh.stat().st_size if mesh.exists() else 0


def to_do(arguments):
    """What is not finished, the largest first: no long run is left for the end."""
    finished = {record["mesh"] for record in read_records(pathlib.Path(arguments.results))
                if record["options"] == arguments.options}
    part, number_of_parts = map(int, arguments.part.split("/"))
    meshes = dict.fromkeys(mesh for mesh in list(meshes_in(arguments.meshes))[part::number_of_parts]
                           if size(mesh) <= arguments.largest and str(mesh) not in finished)
    return sorted(meshes, key=size, reverse=True)


def run(arguments, meshes):
    hosts = ["--workdir", ".", "--sshlogin", arguments.sshlogin] if arguments.sshlogin else []
    command = ["parallel", "--will-cite", "--quote", "--null", "--jobs", str(arguments.jobs), *hosts, sys.executable, "-B",
               str(RUN_MESH), "--results", arguments.results, "--time-limit", str(arguments.time_limit),
               "--memory-limit", str(arguments.memory_limit)]
    if arguments.judge:
        command += ["--judge", arguments.judge]
    command += [arguments.program, "{}", "--", *arguments.options]
    names = "".join(f"{mesh}\0" for mesh in meshes)
    return subprocess.run(command, input=names.encode(), check=False).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program unwrap")
    parser.add_argument("results", help="file to add to")
    parser.add_argument("meshes", nargs="+", help="meshes, folders of meshes, or lists of meshes (.txt)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at a time; default: one per core")
    parser.add_argument("--time-limit", type=float, default=600, metavar="SECONDS",
                        help="per mesh; default: %(default)s")
    parser.add_argument("--memory-limit", type=int, default=0, metavar="MB", help="per mesh; default: none")
    parser.add_argument("--largest", type=float, default=float("inf"), metavar="BYTES",
                        help="leave larger files out")
    parser.add_argument("--judge", metavar="PROGRAM",
                        help="called with each mesh and its result; prints a JSON object")
    parser.add_argument("--sshlogin", metavar="HOSTS", help="as GNU parallel reads it: names separated by commas")
    parser.add_argument("--part", default="0/1", metavar="I/N", help="only each N-th mesh from the I-th on, which counts from 0")
    parser.add_argument("--options", default="", help="of unwrap, in one word; for example '--effort fast'")
    arguments = parser.parse_args()
    arguments.options = arguments.options.split()
    meshes = to_do(arguments)
    print(f"{len(meshes)} meshes to run", file=sys.stderr)
    status = run(arguments, meshes) if meshes else 0
    print(table(read_records(pathlib.Path(arguments.results))))
    sys.exit(status)


if __name__ == "__main__":
    main()
