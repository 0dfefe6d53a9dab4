#!/usr/bin/env python3
"""What the Python module adds to the time of the library.

usage: python_overhead.py PROGRAM MESH.off... [--repetitions N] [--effort E]

PROGRAM is `unwrap`, whose report tells the processor time that the library takes in C++. Runs of the two alternate, each
with one thread; the table holds medians. The module gets the same triangles as the program hands to the library, so that
both compute the same. `overhead` compares a whole call of the module with the library in the program, `own` with the
library within the same call. Needs the module, for example by PYTHONPATH=build/python.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import surface_mesh_cutting


def read_off(path):
    words = " ".join(line.split("#")[0] for line in path.read_text().splitlines()).split()
    points, faces = int(words[1]), int(words[2])
    end = 4 + 3 * points
    return (np.array(words[4:end], float).reshape(-1, 3),
            np.ascontiguousarray(np.array(words[end:end + 4 * faces], np.int64).reshape(-1, 4)[:, 1:]))


def time_program(program, mesh, effort, folder):
    """The library's processor time and the mean energy."""
    report = folder / "report.json"
    subprocess.run([program, mesh, "-o", folder / "out.obj", "--json", report, "--threads", "1", "--quiet",
                    "--effort", effort, "--uv-scale", "surface"], check=True)
    result = json.loads(report.read_text())
    return result["cpu_seconds"]["total"], result["E_iso"]


def time_module(points, faces, effort):
    start = time.process_time()
    result = surface_mesh_cutting.unwrap(points, faces, effort=effort, threads=1, uv_scale="surface")
    return time.process_time() - start, result.cpu_seconds["total"], result.average_distortion


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path, nargs="+")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--effort", default="fast")
    arguments = parser.parse_args()
    print("mesh,triangles,program,module,overhead,own")
    for mesh in arguments.meshes:
        points, faces = read_off(mesh)
        seconds = []
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(arguments.repetitions):
                of_program, energy = time_program(arguments.program.resolve(), mesh, arguments.effort, pathlib.Path(folder))
                of_module, of_library, same_energy = time_module(points, faces, arguments.effort)
                if energy != same_energy:
                    sys.exit(f"{mesh}: the results differ")
                seconds.append((of_program, of_module, of_library))
        overhead = statistics.median(module / program - 1 for program, module, _ in seconds)
        own = statistics.median(module / library - 1 for _, module, library in seconds)
        program, module, _ = (statistics.median(column) for column in zip(*seconds))
        print(f"{mesh.stem},{len(faces)},{program:.3f},{module:.3f},{overhead:+.2%},{own:+.2%}", flush=True)


if __name__ == "__main__":
    main()
