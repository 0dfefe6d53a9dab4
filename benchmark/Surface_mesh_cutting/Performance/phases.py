#!/usr/bin/env python3
"""What `unwrap` takes on meshes: seconds per phase, with one thread and with several, and memory.

Runs alternate between the numbers of threads, one process at a time, and the table holds medians; nothing else should
run on the machine. `all` is the whole process, reading and writing included; `processor` is the time of all threads
in it. `solves` is how many factorizations for a map of the whole surface have as many unknowns as those of the run;
`speedup` compares `all` with that of the first number of threads. The last lines give the exponent of `all` against
the number of triangles, if the meshes differ in size.
"""
import argparse
import json
import math
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

PHASES = ["candidates", "filter", "connect", "refine", "parameterize"]


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(command, mesh, threads, folder):
    """The program's report, with the times of the whole process and the mesh that it wrote."""
    report, output = folder / "report.json", folder / "mesh.obj"
    start, processor_start = time.monotonic(), processor_time()
    status = subprocess.run([*command, mesh, "-o", output, "--json", report, "--threads", str(threads), "--quiet"],
                            check=False).returncode
    seconds, processor_seconds = time.monotonic() - start, processor_time() - processor_start
    if status not in (0, 7):
        raise RuntimeError(f"{mesh}: exit status {status}")
    result = json.loads(report.read_text())
    result["all"], result["processor"] = seconds, processor_seconds
    result["bytes"] = output.read_bytes()
    return result


def median(results, value):
    return statistics.median(value(result) for result in results)


def row(name, threads, results, first_seconds):
    """The cells of a line, and the median time of the process."""
    seconds = median(results, lambda result: result["all"])
    phases = [median(results, lambda result: result["seconds"][phase]) for phase in PHASES]
    cells = [name, str(results[0]["faces"]), str(threads), *(f"{phase:.2f}" for phase in phases), f"{seconds:.2f}",
             f"{median(results, lambda result: result['processor']):.2f}",
             f"{median(results, lambda result: result['peak_memory_mb']):.0f}",
             f"{results[0]['factorized_unknowns']['total'] / (2 * results[0]['vertices']):.1f}",
             f"{(first_seconds or seconds) / seconds:.2f}"]
    return cells, seconds


def exponent(points):
    """The slope of the line through the logarithms, None for a single size."""
    if len({size for size, _ in points}) < 2:
        return None
    x, y = ([math.log(value) for value in column] for column in zip(*points))
    x_mean, y_mean = statistics.mean(x), statistics.mean(y)
    return sum((a - x_mean) * (b - y_mean) for a, b in zip(x, y)) / sum((a - x_mean) ** 2 for a in x)


def print_row(cells):
    print(f"{cells[0]:<24}" + "".join(f"{cell:>13}" for cell in cells[1:]), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", type=pathlib.Path, metavar="MESH")
    parser.add_argument("--program", default="build/bin/unwrap", help="%(default)s by default")
    parser.add_argument("--threads", nargs="+", type=int, default=[1, 2], help="1 2 by default")
    parser.add_argument("--repetitions", type=int, default=3, help="%(default)s by default")
    parser.add_argument("--effort", default="fast", help="%(default)s by default")
    arguments = parser.parse_args()

    command = [arguments.program, "--effort", arguments.effort]
    points = {threads: [] for threads in arguments.threads}
    differing = []
    print_row(["mesh", "triangles", "threads", *PHASES, "all", "processor", "MB", "solves", "speedup"])
    with tempfile.TemporaryDirectory() as folder:
        for mesh in arguments.meshes:
            results = {threads: [] for threads in arguments.threads}
            for _ in range(arguments.repetitions):
                for threads in arguments.threads:
                    results[threads].append(run(command, mesh, threads, pathlib.Path(folder)))
            if len({result["bytes"] for same in results.values() for result in same}) > 1:
                differing.append(mesh.name)
            first_seconds = None
            for threads in arguments.threads:
                cells, seconds = row(mesh.stem, threads, results[threads], first_seconds)
                first_seconds = first_seconds or seconds
                points[threads].append((results[threads][0]["faces"], seconds))
                print_row(cells)
    for threads in arguments.threads:
        slope = exponent(points[threads])
        if slope is not None:
            print(f"threads {threads}: exponent {slope:.2f}")
    if differing:
        sys.exit("not the same bytes in all runs: " + ", ".join(differing))


if __name__ == "__main__":
    main()
