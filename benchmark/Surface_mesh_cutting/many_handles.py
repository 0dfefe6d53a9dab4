#!/usr/bin/env python3
"""Time, memory and results of `unwrap` on surfaces with many handles.

  many_handles.py UNWRAP [MESH...] [--effort fast] [--threads 2] [--baseline OTHER_UNWRAP]

Runs on a plate with 133 holes (see make_plate.py) and on the meshes given; one line each: triangles, genus, wall seconds,
CPU seconds of the whole process, megabytes, length over the bounding box diagonal, mean energy. With --baseline, a second
line tells what another build of the program makes of the same mesh, right after it.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time

from make_plate import plate, write_off


def run(program, mesh, options, folder):
    """Figures of one run; exits with a message if it fails."""
    report = os.path.join(folder, "report.json")
    command = [program, mesh, "--quiet", "--effort", options.effort, "--threads", str(options.threads),
               "--json", report, "-o", os.path.join(folder, "out.obj")]
    start = time.monotonic()
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    if status != 0:
        sys.exit(f"{mesh}: {program} ended with status {os.waitstatus_to_exitcode(status)}")
    with open(report, encoding="utf-8") as file:
        result = json.load(file)
    return [result["faces"], result["genus"], f"{wall:.2f}", f"{usage.ru_utime + usage.ru_stime:.2f}",
            f"{usage.ru_maxrss / 1024:.0f}", f"{result['cut_length']:.4f}", f"{result['E_iso']:.4f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("unwrap")
    parser.add_argument("meshes", nargs="*")
    parser.add_argument("--effort", default="fast")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--baseline")
    options = parser.parse_args()
    print("mesh,program,triangles,genus,seconds,cpu_seconds,megabytes,length,energy")
    with tempfile.TemporaryDirectory() as folder:
        plate_file = os.path.join(folder, "plate.off")
        write_off(plate_file, *plate(rows=7, columns=19, segments=32, radius=0.3, thickness=0.25))
        for mesh in [plate_file] + options.meshes:
            for name, program in (("unwrap", options.unwrap), ("baseline", options.baseline)):
                if program:
                    print(os.path.basename(mesh), name, *run(program, mesh, options, folder), sep=",", flush=True)


if __name__ == "__main__":
    main()
