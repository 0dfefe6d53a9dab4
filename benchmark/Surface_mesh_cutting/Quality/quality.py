#!/usr/bin/env python3
"""Measures how good results are: lengths, distortion, shortest trees, layouts. --help tells the options, --list the
claims."""

import pathlib
import statistics
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scoreboard"))

from bench import Measured, mean_of, total_seconds  # noqa: E402
from comparison import measure_comparison, measure_pages  # noqa: E402
from driver import Claim, run  # noqa: E402
from known_cuts import measure_known  # noqa: E402
from layouts import measure_packing, measure_weights  # noqa: E402
from mesh_copies import measure_invariance  # noqa: E402
from meshes import CLOSED, FIGURES  # noqa: E402
from room import measure_ramp, measure_room  # noqa: E402
from searches import measure_best, measure_best_on_models, measure_optcuts, measure_seeds  # noqa: E402
from trees import measure_many_terminals, measure_pace, measure_trees  # noqa: E402

# Where no time counts, several runs go side by side; processor seconds are then a little longer than alone.
OVERLAP = ["--allow-overlap"]


def mean_seconds(reports):
    return statistics.fmean(map(total_seconds, reports))


def measure_efforts(bench):
    meshes = bench.meshes(FIGURES)
    values, table = {"surfaces": len(meshes)}, [["Effort", "mean length", "mean distortion", "mean s"]]
    for effort in "fast", "default", "best":
        reports = bench.reports(meshes, "--effort", effort, *OVERLAP, jobs=bench.options.jobs)
        found = mean_of(reports, "cut_length"), mean_of(reports, "E_iso"), mean_seconds(reports)
        values |= dict(zip((f"{effort}_length", f"{effort}_energy", f"{effort}_seconds"), found))
        table.append([effort, f"{found[0]:.3f}", f"{found[1]:.3f}", f"{found[2]:.1f}"])
    values["percent"] = 100 * (values["default_length"] / values["fast_length"] - 1)
    return Measured(values, {"efforts": table})


def measure_bounds(bench):
    meshes = bench.meshes(FIGURES)
    free = bench.reports(meshes, *OVERLAP, jobs=bench.options.jobs)
    values = {"surfaces": len(meshes), "kept": 0, "runs": 0, "length": mean_of(free, "cut_length"), "seconds": mean_seconds(free)}
    for bound in "4.05", "4.03":
        reports = bench.reports(meshes, "--max-distortion", bound, *OVERLAP, jobs=bench.options.jobs)
        values["kept"] += sum(report["status"] == "done" and report["E_iso"] <= float(bound) for report in reports)
        values["runs"] += len(reports)
        name = bound.replace(".", "_")
        values |= {f"length_{name}": mean_of(reports, "cut_length"), f"seconds_{name}": mean_seconds(reports)}
    return Measured(values)


def measure_overlaps(bench):
    """What it costs that no two triangles of the layout overlap: by default, and with effort `fast`."""
    meshes = bench.meshes(CLOSED)
    values = {"surfaces": len(meshes), "overlaps": 0}
    for effort in "default", "fast":
        options = ["--effort", effort, "--uv-scale", "surface"]
        free, bijective = bench.reports(meshes, *options, *OVERLAP), bench.reports(meshes, *options)
        values["overlaps"] += sum(report["overlaps"] for report in bijective)
        values |= {
            f"{effort}_time_percent": 100 * (sum(map(total_seconds, bijective)) / sum(map(total_seconds, free)) - 1),
            f"{effort}_energy": mean_of(bijective, "E_iso") - mean_of(free, "E_iso"),
            f"{effort}_length_percent": 100 * (mean_of(bijective, "cut_length") / mean_of(free, "cut_length") - 1)}
    return Measured(values)


def measure_coarse(bench):
    """Feature points of a coarser version against those of full resolution."""
    meshes = bench.meshes(CLOSED[-9:])
    command = [bench.program("pipeline"), *meshes, "--effort", "fast", "--repetitions", "1"]
    found = dict(zip(("coarse", "full"), bench.all_rows([command, [*command, "--coarse", "0"]])))
    mean = {(name, column): statistics.fmean(float(row[column]) for row in rows)
            for name, rows in found.items() for column in ("L", "E", "cut_s")}
    return Measured({"surfaces": len(meshes), "energy": mean["coarse", "E"] - mean["full", "E"],
                     "length_percent": 100 * (mean["coarse", "L"] / mean["full", "L"] - 1),
                     "times_as_fast": mean["full", "cut_s"] / mean["coarse", "cut_s"]})


def measure_feature_trees(bench):
    """The trees through feature points."""
    reports = bench.reports(bench.meshes(CLOSED), "--effort", "fast", *OVERLAP)
    seconds = [report["cpu_seconds"]["connect"] for report in reports]
    return Measured({"surfaces": len(reports), "proven": sum(bool(report["optimal"]) for report in reports),
                     "median_ms": 1000 * statistics.median(seconds), "largest_s": max(seconds)})


CLAIMS = [
    Claim("efforts", 2,
          "On {surfaces} surfaces, default cuts have {percent:+.1f} % length against fast ones, at {default_energy:.3f} instead of "
          "{fast_energy:.3f}; best ones have {best_length:.3f} instead of {default_length:.3f} diagonals at {best_energy:.3f}",
          measure_efforts),
    Claim("bounds", 2,
          "Bounds of 4.05 and 4.03 are kept in {kept} of {runs} runs; mean lengths {length_4_05:.2f} and {length_4_03:.2f}, "
          "{length:.2f} without", measure_bounds),
    Claim("best_known", 10,
          "On {surfaces} closed surfaces, default cuts are {default_free:.1f} % longer than the best known ones without a bound, "
          "{default_4_1:.1f} % at a bound of 4.1; fast ones {fast_free:.1f} % and {fast_4_1:.1f} %", measure_known),
    Claim("seeds", 20,
          "At a bound of 4.1, default cuts of {seeds} seeds differ by {mean:.1f} % in the mean over {surfaces} surfaces, by {median:.1f} % "
          "in the median and by {largest:.1f} % at most; the shortest one is {best_percent:.1f} % shorter than that of seed 0",
          measure_seeds, is_long=True),
    Claim("best", 10,
          "Effort best is {dominated} times of {runs} worse than a smaller one from three seeds, on {surfaces} surfaces with and without "
          "bounds; with one, its cuts are {shorter_percent:.1f} % shorter than default ones, in {ratio:.0f} times their time",
          measure_best, is_long=True),
    Claim("best_on_models", 150,
          "Effort best is {dominated} times of {runs} worse than a smaller one from three seeds, on {surfaces} closed surfaces with and "
          "without bounds; with one, its cuts are {shorter_percent:.1f} % shorter than default ones; it takes {ratio:.1f} times their "
          "time in the mean, {largest_ratio:.1f} times at most", measure_best_on_models, needs="--models FOLDER", is_long=True),
    Claim("optcuts", 1.5,
          "On {surfaces} surfaces at a bound of 4.1 without overlaps, cuts are {mean:.1f} % shorter than those of OptCuts in the mean and "
          "{least:.1f} % at least, in {seconds:.0f} s; overlaps left: {overlaps}", measure_optcuts, needs="--models FOLDER"),
    Claim("comparison", 60,
          "On {meshes} of the Common Shapes, cuts are as short as those of xatlas and of Blender's Smart UV Project or shorter on "
          "{best_seam}, with as few charts or fewer on {best_charts}: {default_charts:.1f} in the mean, {xatlas_charts:.0f} and "
          "{smart_charts:.0f}; overlaps: {overlaps}, without result: {unfinished}", measure_comparison, needs="--common FOLDER",
          is_long=True),
    Claim("pages", 10,
          "Charts that xatlas makes of {layouts} of the Common Shapes, with copies, need {ours_pages} pages, {xatlas_pages} as xatlas packs "
          "them and {shelves_pages} on shelves, at the same scale and margin; on {fewest}, no other needs fewer",
          measure_pages, needs="--common FOLDER"),
    Claim("invariance", 60,
          "{rotations} rotations of {surfaces} surfaces change the length at a bound of 4.1 by {rotated_4_1_mean:.1f} % in the mean "
          "and {rotated_4_1_largest:.1f} % at most, other numbers of vertices by {renumbered_4_1_mean:.1f} and "
          "{renumbered_4_1_largest:.1f} %", measure_invariance, is_long=True),
    Claim("overlaps", 1.5,
          "On {surfaces} surfaces, layouts without overlaps take {default_time_percent:+.0f} % time for {default_energy:+.4f} mean "
          "distortion and {default_length_percent:+.1f} % length, with effort fast {fast_time_percent:+.0f} % for {fast_energy:+.4f} "
          "and {fast_length_percent:+.1f} %; overlaps left: {overlaps}", measure_overlaps),
    Claim("room", 5,
          "On {surfaces} surfaces whose charts are crowded, a bound of 4.03 is kept without overlaps on {kept}, with cuts that are "
          "{length_percent:.0f} % longer in sum than with overlaps, {whole} not divided further, in {seconds:.0f} s",
          measure_room),
    Claim("ramp", 0.5,
          "A ramp of {turns} turns and {triangles:,} triangles becomes {charts} charts without overlaps, with a cut of {length:.2f} "
          "diagonals", measure_ramp),
    Claim("coarse", 1,
          "On {surfaces} larger surfaces, feature points of a coarser version are found {times_as_fast:.1f} times as fast, for "
          "{energy:+.4f} mean distortion and {length_percent:+.1f} % length", measure_coarse),
    Claim("feature_trees", 0.5,
          "{proven} of {surfaces} trees through feature points are proven shortest, in {median_ms:.0f} ms in the median and "
          "{largest_s:.2f} s at most", measure_feature_trees),
    Claim("trees", 1.5,
          "{proven:,} of {sets:,} trees through random points are proven shortest, in {median_ms:.0f} ms in the median",
          measure_trees),
    Claim("many_terminals", 0.5,
          "Shortest trees through 26 points of a surface of {vertices:,} vertices take {least_s:.1f} to {largest_s:.1f} s",
          measure_many_terminals),
    Claim("pace", 15,
          "Of the {graphs} graphs of PACE 2018, {solved} are solved exactly within {limit:.0f} s each; the best trees found in that "
          "time are at most {percent:.2f} % longer than shortest ones", measure_pace, needs="--graphs FOLDER", is_long=True),
    Claim("weights", 1.5,
          "Weights for a view from the front remove {viewers_percent:.0f} % of what is seen of the cuts, for "
          "{viewers_length:+.0f} % length, on {surfaces} surfaces", measure_weights),
    Claim("packing", 0.5,
          "Packed charts fill {packed:.1f} % of the square, {shelves:.1f} % on shelves and {bitmap:.1f} % in a bitmap, on "
          "{files} layouts; where there are 10 charts or more, {several:.1f} %", measure_packing),
]

if __name__ == "__main__":
    run("quality", CLAIMS)
