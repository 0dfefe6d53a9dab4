#!/usr/bin/env python3
"""Compares programs that unwrap meshes: runs each on each mesh, measures all results alike, and writes comparison.md,
comparison.html and comparison.json into OUTPUT, beside all results and records.jsonl. Calling it again goes on where it was."""

import argparse
import json
import pathlib

import page
import tables
from run_programs import ROOT, TABLE, find_meshes, read_programs, run_all


def explain():
    return ("Seams on the surface are in diagonals of its bounding box, those in the unit square are the borders of all charts "
            "after the layout is scaled into it. Energies are symmetric Dirichlet ones at the best common scale (4 is no "
            "distortion), weighted by area, of the faces that are not flipped; a face is flipped if it is turned against most of "
            "its chart, or flat. Angles and areas are the mean discrepancies of the parameterization benchmark, and PartUV's "
            "scores (1 is best). Overlaps are decided exactly. Seconds are of the processor. A run without a result counts as "
            "worse than any with one.\n")


def write(folder, records, programs, ours):
    names, rivals = [program.name for program in programs], [program.name for program in programs if program.is_rival()]
    bounds = [(program.name, rival, key) for program in programs for rival, key in program.measured()]
    found = {"values": tables.values_of_all(records, ours, names, rivals) | tables.counts_at_bounds(records, bounds),
             "programs": tables.totals(records, names),
             **{name: tables.pairs(records, ours, name) for name in names if name != ours},
             **{f"{rival}_minus_{name}": tables.pairs(records, name, rival) for name, rival, _ in bounds},
             "exceptions": tables.exceptions(records, ours, rivals)}
    (folder / "comparison.json").write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    parts = [f"# {len(records)} surfaces\n", explain(), tables.markdown(found["programs"])]
    for name in names:
        parts += [f"## {name} minus {ours}\n", tables.markdown(found[name])] if name != ours else []
    for name, rival, _ in bounds:
        parts += [f"## {rival} minus {name}\n", tables.markdown(found[f"{rival}_minus_{name}"])]
    parts += ["## Exceptions\n", tables.markdown(found["exceptions"])]
    (folder / "comparison.md").write_text("\n".join(parts), encoding="utf-8")
    (folder / "comparison.html").write_text(page.page(records, found, names, ours), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", type=pathlib.Path, help="OBJ, OFF and PLY files, and folders of them")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/compare/results", metavar="FOLDER")
    parser.add_argument("--programs", type=pathlib.Path, default=TABLE, metavar="FILE", help="the table of commands")
    parser.add_argument("--ours", default="default", metavar="NAME", help="the program to compare all others with; default: %(default)s")
    parser.add_argument("--only", metavar="NAME,...", help="of these programs")
    parser.add_argument("--time-limit", type=float, default=300, metavar="SECONDS",
                        help="of the processor, of each run; default: %(default)s")
    arguments = parser.parse_args()
    programs = read_programs(arguments.programs)
    if arguments.only:
        names = [arguments.ours, *arguments.only.split(",")]
        programs = [program for program in programs if program.name in names]
    records = run_all(programs, find_meshes(arguments.meshes), arguments.output.resolve(), arguments.time_limit)
    write(arguments.output, records, programs, arguments.ours)
    print(f"comparison   {arguments.output / 'comparison.html'}")


if __name__ == "__main__":
    main()
