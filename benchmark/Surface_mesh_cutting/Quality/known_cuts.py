"""The best cuts that are known of closed surfaces of CGAL's data set, at bounds on the mean energy and without: the
yardstick of all efforts. Layouts may overlap, since only the cut counts."""

import csv
import math
import pathlib
import statistics
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scoreboard"))

from bench import Measured  # noqa: E402
from meshes import CLOSED, HANDLES  # noqa: E402

FILE = HERE / "best_known.csv"
COLUMNS = ["mesh", "bound", "length", "energy", "options"]
BOUNDS = ["", "4.2", "4.1", "4.05"]
NAMES = CLOSED + HANDLES
ENERGY_PER_DIAGONAL = 0.15  # without a bound: the package's rate of exchange, decrease_per_length


def options_of(bound, effort, seed=0):
    return ["--effort", effort, "--seed", str(seed), "--allow-overlap", *(["--max-distortion", bound] if bound else [])]


def badness(bound, length, energy):
    """With a bound the length, infinite above the bound; without, what the method minimizes."""
    if not bound:
        return energy + ENERGY_PER_DIAGONAL * length
    return length if energy <= float(bound) else math.inf


def read():
    """{(mesh, bound): row}"""
    if not FILE.exists():
        return {}
    with open(FILE, newline="", encoding="utf-8") as file:
        return {(row["mesh"], row["bound"]): row for row in csv.DictReader(file)}


def write(known):
    with open(FILE, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(known[key] for key in sorted(known))


def improve(known, mesh, bound, report, options):
    """Whether the report is of a better cut than the known one; the file rounds, so it has to be better by more."""
    length, energy = report["cut_length"], report["E_iso"]
    former = known.get((mesh, bound))
    found = badness(bound, length, energy)
    if math.isinf(found) or former and found > badness(bound, float(former["length"]), float(former["energy"])) - 1e-5:
        return False
    known[mesh, bound] = {"mesh": mesh, "bound": bound, "length": f"{length:.6f}", "energy": f"{energy:.6f}",
                          "options": " ".join(options)}
    return True


def excess(known, mesh, bound, report):
    """In percent of the length; without a bound, differences of the energy are converted."""
    row = known[mesh, bound]
    length, energy = float(row["length"]), float(row["energy"])
    difference = badness(bound, report["cut_length"], report["E_iso"]) - badness(bound, length, energy)
    return 100 * difference / length / (1 if bound else ENERGY_PER_DIAGONAL)


def measure_known(bench):
    """How far efforts are from the best known cuts."""
    known = read()
    values, table = {"surfaces": len(NAMES)}, [["Effort", *("no bound" if not bound else bound for bound in BOUNDS)]]
    for effort in "fast", "default":
        row = [effort]
        for bound in BOUNDS:
            reports = bench.reports(bench.meshes(NAMES), *options_of(bound, effort), jobs=bench.options.jobs)
            found = [excess(known, name, bound, report) for name, report in zip(NAMES, reports)
                     if (name, bound) in known]
            reached = [percent for percent in found if not math.isinf(percent)]
            mean = statistics.fmean(reached)
            values[f"{effort}_{bound.replace('.', '_') or 'free'}"] = mean
            row.append(f"{mean:+.1f} %" + (f", {len(found) - len(reached)} above" if len(reached) < len(found) else ""))
        table.append(row)
    return Measured(values, {"efforts": table})
