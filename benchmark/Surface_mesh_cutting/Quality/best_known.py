#!/usr/bin/env python3
"""Looks for better cuts than those in best_known.csv, and writes what it finds there, with the options that found it:
  best_known.py [--efforts EFFORT,...] [--seeds N] [--jobs N]
Takes minutes with the efforts fast and default, hours with best; what has run is not run again. How far each effort is
from the best known cuts is the claim best_known of quality.py."""

import argparse
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scoreboard"))

import known_cuts  # noqa: E402
from bench import ROOT, Bench  # noqa: E402
from driver import commit  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--efforts", default="fast,default,best")
    parser.add_argument("--seeds", type=int, default=1, help="0 to N - 1")
    parser.add_argument("--only", default="", metavar="MESH,...", help="default: all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/bin", metavar="FOLDER")
    parser.add_argument("--meshes", type=pathlib.Path, default=ROOT / "build/data/meshes", metavar="FOLDER")
    options = parser.parse_args()
    folder = ROOT / "build/scoreboard" / commit() / "known_cuts"
    folder.mkdir(parents=True, exist_ok=True)
    bench = Bench(options, folder)
    names = options.only.split(",") if options.only else known_cuts.NAMES
    known = known_cuts.read()
    for effort in options.efforts.split(","):
        for seed in range(options.seeds):
            for bound in known_cuts.BOUNDS:
                words = known_cuts.options_of(bound, effort, seed)
                reports = bench.reports(bench.meshes(names), *words, jobs=options.jobs)
                better = [name for name, report in zip(names, reports)
                          if known_cuts.improve(known, name, bound, report, words)]
                known_cuts.write(known)
                print(" ".join(words), "found", len(better), "better cuts:", *better, flush=True)


if __name__ == "__main__":
    main()
