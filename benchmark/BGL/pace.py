#!/usr/bin/env python3
"""Runs steiner_pace on a folder of graphs of the PACE 2018 Steiner tree challenge and compares with known optima.

Prints CSV, one line per graph, and a summary on standard error. One process at a time; seconds are processor time.
The file of optima has lines `file,optimum` after a header.
"""
import argparse
import csv
import pathlib
import resource
import subprocess
import sys


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(program, graph, method, seconds):
    """Returns the value, None if there is none, and the processor time."""
    limit = int(seconds) + 1
    before = processor_time()
    with graph.open() as problem:
        process = subprocess.run(
            [program, "--method", method], stdin=problem, capture_output=True, text=True, check=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    words = process.stdout.split()
    value = float(words[1]) if process.returncode == 0 and words[:1] == ["VALUE"] else None
    return value, processor_time() - before


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program steiner_pace")
    parser.add_argument("folder", type=pathlib.Path, help="of the graphs")
    parser.add_argument("optima", type=pathlib.Path)
    parser.add_argument("--method", default="best", help="%(default)s by default")
    parser.add_argument("--seconds", type=float, default=60., help="per graph, %(default)s by default")
    parser.add_argument("--only", nargs="+", metavar="FILE", help="names of graphs, instead of all")
    arguments = parser.parse_args()

    output = csv.writer(sys.stdout)
    output.writerow(["file", "value", "optimum", "ratio", "seconds"])
    ratios, times = [], []
    with arguments.optima.open() as optima:
        problems = [(row["file"], float(row["optimum"])) for row in csv.DictReader(optima)]
    for file, optimum in problems:
        if arguments.only and file not in arguments.only:
            continue
        value, seconds = run(arguments.program, arguments.folder / file, arguments.method, arguments.seconds)
        ratio = None if value is None or seconds > arguments.seconds else value / optimum
        output.writerow([file, value, optimum, ratio and f"{ratio:.6f}", f"{seconds:.2f}"])
        sys.stdout.flush()
        ratios.append(ratio)
        times.append(seconds)

    found = [ratio for ratio in ratios if ratio is not None]
    print(f"{arguments.method}: {len(found)} of {len(ratios)} within {arguments.seconds:g} s, "
          f"{sum(ratio == 1. for ratio in found)} optimal, {sum(ratio < 1. for ratio in found)} below the optimum, "
          f"largest ratio {max(found, default=0.):.4f}; {sum(times):.0f} s in total", file=sys.stderr)


if __name__ == "__main__":
    main()
