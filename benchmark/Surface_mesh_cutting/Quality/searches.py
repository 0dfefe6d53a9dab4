"""What the search for short cuts reaches: how far seeds differ, whether effort `best` contains the smaller ones, and
cuts of another method at the same bound."""

import pathlib
import statistics

from bench import Measured, total_seconds
from meshes import CLOSED, FIGURES

BOUND = "4.1"  # that of the lengths in optcuts.csv, too
LONGEST = 3600  # seconds, for effort `best` on a large surface
ROUNDING = 1e-9
FEW = FIGURES[:5]  # small enough for effort `best` in four settings


def measure_seeds(bench):
    """The longest cut of any seed against the shortest one, default effort."""
    seeds = [0, *range(8, 15)]  # small surfaces take all starts of the first eight, whichever of these is given
    runs = [bench.reports(bench.meshes(CLOSED), "--max-distortion", BOUND, "--seed", seed, jobs=bench.options.jobs)
            for seed in seeds]
    lengths = {name: [report["cut_length"] for report in reports] for name, reports in zip(CLOSED, zip(*runs))}
    spreads = {name: 100 * (max(found) / min(found) - 1) for name, found in lengths.items()}
    table = [["Surface", "shortest", "mean", "longest", "difference"]]
    for name, found in lengths.items():
        table.append([pathlib.Path(name).stem, f"{min(found):.3f}", f"{statistics.fmean(found):.3f}", f"{max(found):.3f}",
                      f"{spreads[name]:.1f} %"])
    return Measured({"surfaces": len(CLOSED), "seeds": len(seeds), "mean": statistics.fmean(spreads.values()),
                     "median": statistics.median(spreads.values()), "largest": max(spreads.values()),
                     "best_percent": 100 * (1 - statistics.fmean(min(found) / found[0] for found in lengths.values()))},
                    {"seeds": table})


def dominates(report, best, bound):
    """With a bound, a shorter cut that keeps it; without, a cut no worse in both and better in one."""
    length = report["cut_length"] - best["cut_length"]
    if bound:
        return report["status"] == "done" and (best["status"] != "done" or length < -ROUNDING)
    energy = report["E_iso"] - best["E_iso"]
    return max(length, energy) <= ROUNDING and min(length, energy) < -ROUNDING


def compare_best(bench, meshes):
    """Effort `best` against the smaller ones from several seeds."""
    seeds = range(3)
    dominated, shorter, ratios, table = 0, [], [], [["Surface", "bound", "length", "energy", "shorter by", "times"]]
    for bound in "", "4.2", "4.1", "4.05":
        def reports(effort, seed):
            limit = ["--max-distortion", bound] if bound else []
            return bench.reports(meshes, "--effort", effort, "--seed", seed, *limit, jobs=bench.options.jobs,
                                 time_limit=LONGEST)

        best = reports("best", 0)
        smaller = {(effort, seed): reports(effort, seed) for effort in ("default", "fast") for seed in seeds}
        for i, found in enumerate(best):
            dominated += any(dominates(others[i], found, bound) for others in smaller.values())
            defaults = [smaller["default", seed][i] for seed in seeds]
            ratios.append(total_seconds(found) / statistics.fmean(map(total_seconds, defaults)))
            percent = 100 * (1 - found["cut_length"] / defaults[0]["cut_length"])
            if bound:
                shorter.append(percent)
            table.append([meshes[i].stem, bound or "none", f"{found['cut_length']:.3f}", f"{found['E_iso']:.4f}",
                          f"{percent:.1f} %", f"{ratios[-1]:.1f}"])
    return Measured({"surfaces": len(meshes), "runs": len(ratios), "dominated": dominated,
                     "shorter_percent": statistics.fmean(shorter), "ratio": statistics.fmean(ratios),
                     "largest_ratio": max(ratios)}, {"best": table})


def measure_best(bench):
    return compare_best(bench, bench.meshes(FEW))


def measure_best_on_models(bench):
    return compare_best(bench, bench.models("closed_models.csv")[1])


def measure_optcuts(bench):
    """One run at a time, since times count."""
    rows, models = bench.models("optcuts.csv")
    reports = bench.reports(models, "--max-distortion", BOUND)
    shorter = [100 * (1 - report["cut_length"] / float(row["length"])) for row, report in zip(rows, reports)]
    table = [["Surface", "triangles", "their length", "our length", "energy", "shorter by", "s"]]
    for row, report, percent in zip(rows, reports, shorter):
        table.append([pathlib.Path(row["model"]).stem, f"{report['faces']:,}", row["length"], f"{report['cut_length']:.3f}",
                      f"{report['E_iso']:.4f}", f"{percent:.1f} %", f"{total_seconds(report):.1f}"])
    return Measured({"surfaces": len(rows), "mean": statistics.fmean(shorter), "least": min(shorter),
                     "seconds": sum(map(total_seconds, reports)),
                     "overlaps": sum(report["overlaps"] for report in reports)}, {"optcuts": table})
