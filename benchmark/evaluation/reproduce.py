#!/usr/bin/env python3
"""Repeats the paper's evaluation on a folder of meshes: tables (CSV), plots (gnuplot, SVG), and a summary
that says of each claim what the paper found, what was found here, and whether it holds.

What is finished is kept in OUTPUT/pieces and not run again: call it once more to go on, with more time
or more meshes. Meshes that cannot be read or are not closed, connected and of genus 0 are left out of
the comparisons and listed in OUTPUT/meshes.csv.

Times are processor seconds of one thread, measured while others run beside; use --jobs 1 on an idle
machine where they matter.
"""

import argparse
import collections
import datetime
import json
import os
import pathlib
import sys
import time

import causes
import comparisons
import stages
import sweeps
from measuring import Setting
from pieces import Pieces

BENCHMARK = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(BENCHMARK / "Surface_mesh_cutting" / "Robustness" / "corpus"))
sys.path.insert(0, str(BENCHMARK / "scoreboard"))

import driver  # noqa: E402
import results  # noqa: E402

from run_corpus import meshes_in  # noqa: E402

# Commands and what is made of their answers.
EXPERIMENTS = {
    "detectors": (comparisons.detector_commands, comparisons.detector_table),
    "same_energy": (comparisons.same_energy_commands, comparisons.same_energy_table),  # after the detectors
    "stages": (stages.stage_commands, stages.stage_table),
    "sweeps": (sweeps.sweep_commands, sweeps.sweep_tables),
    "triangulations": (sweeps.triangulation_commands, sweeps.triangulation_table),
    "steiner": (comparisons.steiner_commands, comparisons.steiner_table),
    "causes": (causes.cause_commands, causes.cause_table),  # after the stages
}

# What some need first: meshes.
MAKING = {"triangulations": sweeps.making_commands, "causes": causes.making_commands}


def survey(setting, pieces, folder, smallest, largest):
    """Runs the package on every mesh, and finds those on which the paper's method is defined."""
    meshes = sorted(mesh.resolve() for mesh in meshes_in([folder]))
    meshes.sort(key=lambda mesh: mesh.stat().st_size)
    outcomes = pieces.run({mesh: setting.unwrap(mesh, "--effort", "fast", "--time-limit", "100") for mesh in meshes})
    table, faces = [], {}
    for mesh, outcome in outcomes.items():
        try:
            report = json.loads(outcome.output)
        except json.JSONDecodeError:
            report = {"status": "not finished"}
        is_closed = (report["status"] == "done" and report["components"] == 1 and report["genus"] == 0
                     and report["borders"] == 0 and report["flips"] == 0)
        is_used = is_closed and smallest <= report["faces"] <= largest
        if is_used:
            faces[mesh] = report["faces"]
        table.append({"mesh": mesh.name, "status": report["status"], "message": report.get("message", ""),
                      **{key: report.get(key) for key in ("faces", "genus", "borders", "components")},
                      "L": report.get("cut_length"), "E": report.get("E_iso"), "used": is_used})
    setting.closed = sorted(faces, key=lambda mesh: (faces[mesh], mesh))
    setting.write_table("meshes", table)
    return len(table)


def cells(claim):
    return [claim.source, claim.statement, claim.paper, claim.ours, claim.verdict(), claim.reason]


def store(setting, claims, number_of_meshes, start):
    """Among the results that the manual quotes."""
    verdicts = collections.Counter(claim.verdict() for claim in claims)
    holds = [claim for claim in claims if claim.holds]
    values = {"claims": len(holds) + verdicts["does not hold"], "holds": len(holds), "meshes": number_of_meshes,
              "compared": len(setting.closed), **setting.values}
    headings = ["Source", "Claim", "Paper", "Here", "Verdict", "Why"]
    measured = [cells(claim) for claim in claims if claim.holds is not None]
    results.append("reproduction", {
        "claim": "reproduction", "command": "scripts/reproduce.sh", "values": values,
        "tables": {"verdicts": [headings, *measured]},
        "statement": "{holds} of {claims} claims of the paper hold on the {compared} closed meshes of genus 0 among "
                     "{meshes}".format(**values),
        "minutes": 30, "commit": driver.commit(), "date": datetime.date.today().isoformat(),
        "seconds": round(time.monotonic() - start, 1), "processor": driver.processor()})


def write_summary(setting, claims, pieces, number_of_meshes):
    lines = ["# The paper's claims", "",
             f"{number_of_meshes} meshes, {len(setting.closed)} of them closed, connected, of genus 0, neither too "
             "small nor too large: on those the comparisons were made.", ""]
    if not setting.closed:
        lines += ["**So far, no mesh is closed, connected and of genus 0.**", ""]
    if pieces.number_left:
        lines += [f"**{pieces.number_left} runs are left: call the program again.**", ""]
    if pieces.crashed:
        lines += ["**These programs crashed:** " + "; ".join(pieces.crashed), ""]
    lines += ["| source | claim | paper | here | | why |", "|---|---|---|---|---|---|"]
    lines += [f"| {' | '.join(cells(claim))} |" for claim in claims]
    text = "\n".join(lines) + "\n"
    (setting.output / "summary.md").write_text(text, encoding="utf-8")
    print(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", help="the folder of the programs, build/bin")
    parser.add_argument("meshes", type=pathlib.Path, help="a folder of meshes")
    parser.add_argument("output", type=pathlib.Path, help="a folder for results")
    parser.add_argument("--only", action="append", choices=EXPERIMENTS, help="this experiment; may be repeated")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at a time; default: one per core")
    parser.add_argument("--minutes", type=float, default=50, help="start nothing later; default: %(default)s")
    parser.add_argument("--time-limit", type=float, default=300, metavar="SECONDS",
                        help="of one run; default: %(default)s")
    parser.add_argument("--largest", type=int, default=30000, metavar="FACES",
                        help="leave larger meshes out of the comparisons; default: %(default)s")
    parser.add_argument("--smallest", type=int, default=1000, metavar="FACES",
                        help="leave smaller meshes out of the comparisons: the paper's have 26,000 on average; default: %(default)s")
    parser.add_argument("--store", action="store_true",
                        help="among the results of benchmark/results, if no run is left")
    arguments = parser.parse_args()
    start = time.monotonic()
    setting = Setting(arguments.programs, arguments.output.resolve())
    pieces = Pieces(setting.output / "pieces", arguments.jobs, arguments.time_limit, arguments.minutes)
    number_of_meshes = survey(setting, pieces, arguments.meshes, arguments.smallest, arguments.largest)
    chosen = [name for name in EXPERIMENTS if setting.closed and name in (arguments.only or EXPERIMENTS)]
    claims = []
    for name in chosen:
        commands, evaluate = EXPERIMENTS[name]
        if name in MAKING:
            pieces.run(MAKING[name](setting))
        claims += evaluate(setting, pieces.run(commands(setting)))
    causes.explain(setting, claims)
    write_summary(setting, claims, pieces, number_of_meshes)
    if arguments.store and not pieces.number_left:
        store(setting, claims, number_of_meshes, start)


if __name__ == "__main__":
    main()
