"""Looks for runs of the program unwrap that do not end as its documentation promises:

    fuzz_options.py PROGRAM MESHES options|stops|all [--seconds S] [--count N] [--seed N] [--only K]

`options` combines options with files, odd values and hostile places, `stops` ends runs at random moments.
Each run follows from the seed and its number; `--only` repeats a single one and leaves its folder.
UNWRAP_TEST_SLACK are the seconds that a run may take after a stop (default 1): more on busy machines."""

import argparse
import collections
import os
import random
import signal
import sys
import tempfile
import time
from pathlib import Path

import random_options
import random_stops
from judge import Fault

KINDS = {"options": random_options.run_case, "stops": random_stops.run_case}


def parse():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("meshes")
    parser.add_argument("kind", choices=[*KINDS, "all"])
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--count", type=int, default=10 ** 9)
    parser.add_argument("--seed", type=int, default=random.randrange(10 ** 6))
    parser.add_argument("--only", type=int)
    return parser.parse_args()


def run_case(kind, seed, number, folder):
    slack = float(os.environ.get("UNWRAP_TEST_SLACK", "1"))
    return KINDS[kind](random.Random(f"{seed} {kind} {number}"), folder, slack)


def run_only(arguments):
    folder = Path(tempfile.mkdtemp())
    print(f"in {folder}")
    print(*run_case(arguments.kind, arguments.seed, arguments.only, folder), sep="\nexit code ")


def run_many(arguments):
    kinds = list(KINDS) if arguments.kind == "all" else [arguments.kind]
    ends, faults, number = collections.Counter(), 0, 0
    start = time.monotonic()
    while number < arguments.count and time.monotonic() - start < arguments.seconds:
        kind = kinds[number % len(kinds)]
        with tempfile.TemporaryDirectory() as folder:
            try:
                ends[run_case(kind, arguments.seed, number, Path(folder).resolve())[1]] += 1
            except Fault as fault:
                faults += 1
                print(f"{kind} {number}: {fault}", flush=True)
        number += 1
    print(f"seed {arguments.seed}: {number} runs in {time.monotonic() - start:.0f} s, {faults} faults; exit codes:",
          ", ".join(f"{code}: {count}" for code, count in sorted(ends.items())))
    return faults


def main():
    for ignored in (signal.SIGHUP, signal.SIGINT):  # by nohup, and in the background; programs inherit that, and rightly so
        signal.signal(ignored, signal.SIG_DFL)
    arguments = parse()
    if arguments.only is not None:
        run_only(arguments)
    else:
        sys.exit(run_many(arguments) > 0)


main()
