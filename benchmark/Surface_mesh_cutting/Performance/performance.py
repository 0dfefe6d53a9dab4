#!/usr/bin/env python3
"""Measures what the package takes: time, memory, threads. --help tells the options, --list the claims."""

import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scoreboard"))

from bench import PUBLISHED, Failed, Measured, Missing, cut_seconds, mean_of, total_seconds  # noqa: E402
from driver import Claim, run  # noqa: E402
from make_plate import plate  # noqa: E402
from meshes import FIGURES, HANDLES  # noqa: E402
from off_files import write_off  # noqa: E402
from sizes import measure_factorization, measure_sizes  # noqa: E402


def measure_rivals(bench):
    """The pairs of rivals.csv, and what the program takes now: medians of three runs."""
    pairs, models = bench.models("rivals.csv")
    runs = [bench.reports(models, "--effort", "fast", *PUBLISHED, repetition=i) for i in range(3)]
    now = [statistics.median(map(cut_seconds, reports)) for reports in zip(*runs)]
    complete = [statistics.median(map(total_seconds, reports)) for reports in zip(*runs)]
    theirs, ours = ([float(pair[column]) for pair in pairs] for column in ("seconds", "our_seconds"))
    table = [["Surface", "triangles", "their s", "our s", "times as fast", "our s now", "factorizations", "their length",
              "our length now"]]
    for pair, report, a, b, c in zip(pairs, runs[0], theirs, ours, now):
        table.append([pathlib.Path(pair["model"]).stem, f"{report['faces']:,}", pair["seconds"], pair["our_seconds"],
                      f"{a / b:.0f}", f"{c:.2f}", f"{full_factorizations(report):.1f}", pair["length"], f"{report['cut_length']:.3f}"])
    ratios = [a / b for a, b in zip(theirs, ours)]
    return Measured({
        "pairs": len(pairs), "their_seconds": sum(theirs), "our_seconds": sum(ours), "seconds_now": sum(now),
        "geometric_mean": statistics.geometric_mean(ratios), "least": min(ratios),
        "their_length": statistics.fmean(float(pair["length"]) for pair in pairs),
        "our_length": statistics.fmean(float(pair["our_length"]) for pair in pairs),
        "length_now": mean_of(runs[0], "cut_length"), "largest_theirs": theirs[-1], "largest_ours": ours[-1],
        "largest_now": now[-1], "largest_complete": complete[-1], "largest_triangles": runs[0][-1]["faces"],
        "factorizations": statistics.fmean(map(full_factorizations, runs[0]))}, {"pairs": table})


def full_factorizations(report):
    """How many factorizations for a map of the whole surface have as many unknowns as those for the cut."""
    unknowns = report["factorized_unknowns"]
    return (unknowns["total"] - unknowns["parameterize"]) / (2 * report["vertices"])


def measure_threads(bench):
    """Wall seconds with one and two threads; all bits must be the same."""
    meshes = bench.meshes(["bear.off", "armadillo.off", "bunny00.off"])
    found = {}
    for threads in 1, 2:
        runs = [bench.records(meshes, "--effort", "fast", *PUBLISHED, "--threads", threads, repetition=i) for i in range(3)]
        found[threads] = list(zip(*runs))
    table, speedups = [["Surface", "triangles", "s, one thread", "s, two threads", "speedup"]], []
    for one, two in zip(found[1], found[2]):
        if len({record["digest"] for record in (*one, *two)}) != 1:
            raise Failed(f"{one[0]['mesh']}: not the same bytes")
        seconds = [statistics.median(record["report"]["seconds"]["total"] for record in runs) for runs in (one, two)]
        speedups.append(seconds[0] / seconds[1])
        table.append([pathlib.Path(one[0]["mesh"]).stem, f"{one[0]['report']['faces']:,}",
                      *(f"{value:.2f}" for value in seconds), f"{speedups[-1]:.2f}"])
    return Measured({"surfaces": len(meshes), "speedup": statistics.fmean(speedups), "least": min(speedups)},
                    {"threads": table})


def measure_handles(bench):
    meshes = bench.meshes(HANDLES)
    meshes.append(bench.folder / "plate.off")
    write_off(meshes[-1], *plate(rows=7, columns=19, segments=32, radius=0.3, thickness=0.25))
    records = bench.records(meshes, "--effort", "fast", *PUBLISHED)
    table = [["Surface", "triangles", "handles", "s", "MB", "length"]]
    for record in records:
        report = record["report"]
        table.append([pathlib.Path(record["mesh"]).stem, f"{report['faces']:,}", str(report["genus"]),
                      f"{total_seconds(report):.1f}", f"{record['peak_memory_mb']:.0f}", f"{report['cut_length']:.2f}"])
    most = records[-2]["report"]
    return Measured({"most": most["genus"], "triangles": most["faces"], "seconds": total_seconds(most)}, {"handles": table})


def measure_generated(bench):
    """A model with handles and several components, with a layout for textures, on two threads."""
    meshes = [bench.folder / "foam.off"]
    subprocess.run([bench.program("make_foam"), meshes[0]], check=True, stdout=subprocess.DEVNULL)
    runs = [bench.records(meshes, "--effort", "fast", "--threads", 2, repetition=i)[0] for i in range(3)]
    report = runs[0]["report"]
    return Measured({"triangles": report["faces"], "handles": report["genus"], "overlaps": report["overlaps"],
                     "seconds": statistics.median(run["seconds"] for run in runs),
                     "megabytes": max(run["peak_memory_mb"] for run in runs)})


def measure_published(bench):
    meshes = bench.meshes(FIGURES[:6])
    runs = {name: bench.reports(meshes, *words, *PUBLISHED)
            for name, words in (("published", ["--faithful"]), ("fast", ["--effort", "fast"]), ("default", []))}
    ratios = {name: [total_seconds(a) / total_seconds(b) for a, b in zip(runs["published"], runs[name])]
              for name in ("fast", "default")}
    return Measured({"surfaces": len(meshes), "least": min(ratios["fast"]), "largest": max(ratios["fast"]),
                     "default_ratio": statistics.geometric_mean(ratios["default"]),
                     **{f"{name}_length": mean_of(reports, "cut_length") for name, reports in runs.items()},
                     **{f"{name}_energy": mean_of(reports, "E_iso") for name, reports in runs.items()}})


def measure_python(bench):
    if subprocess.run([sys.executable, "-c", "import surface_mesh_cutting"], check=False, capture_output=True).returncode:
        raise Missing("the Python module: PYTHONPATH=build/python")
    table, _ = bench.rows([sys.executable, "-B", HERE / "python_overhead.py", bench.program("unwrap"),
                           *bench.meshes(["cow.off", "homer.off", "bear.off"]), "--repetitions", "3"])
    return Measured({"surfaces": len(table), "own_percent": max(float(row["own"].rstrip("%")) for row in table),
                     "overhead_percent": max(float(row["overhead"].rstrip("%")) for row in table)})


def measure_compiling(bench):
    del bench
    run_ = subprocess.run([HERE / "compile_cost" / "compile_cost.sh"], check=True, capture_output=True, text=True)
    rows = [line.split("  ") for line in run_.stdout.splitlines()]
    rows = [[cell.strip() for cell in row if cell.strip()] for row in rows]
    seconds = [float(row[1]) for row in rows[1:]]
    table = [["Program", "seconds", "MB", "ratio"], *rows[1:]]
    return Measured({"arap": seconds[0], "headers": seconds[1], "library": seconds[2],
                     "headers_ratio": seconds[1] / seconds[0], "library_ratio": seconds[2] / seconds[0],
                     "library_share": seconds[2] / seconds[1]}, {"programs": table})


CLAIMS = [
    Claim("rivals", 0.5,
          "On {pairs} surfaces, measured side by side, the authors' program took {their_seconds:.0f} s, this one {our_seconds:.2f} s "
          "({geometric_mean:.0f} times as fast in the geometric mean), now {seconds_now:.2f} s with {factorizations:.1f} full "
          "factorizations each; mean length {their_length:.2f} and now {length_now:.2f}",
          measure_rivals, needs="--models FOLDER"),
    Claim("sizes", 2.5,
          "Up to a million triangles, the time for the cut grows with exponent {cut_exponent:.2f}, in total {exponent:.2f}; 100,000 "
          "take {seconds_100000:.1f} s and {megabytes_100000:.0f} MB, a million {seconds_1000000:.0f} s and "
          "{megabytes_1000000:.0f} MB", measure_sizes),
    Claim("factorization", 3,
          "A whole run on {triangles:,} triangles takes {ratio:.2f} times as long as one numeric factorization of its last system by "
          "Eigen's SimplicialLDLT, and {own_ratio:.1f} times as long as one by the package's own", measure_factorization, is_long=True),
    Claim("threads", 1, "The same bytes with one and two threads on {surfaces} surfaces; two are {speedup:.2f} times as fast",
          measure_threads),
    Claim("handles", 0.5, "A surface with {most} handles and {triangles:,} triangles takes {seconds:.1f} s", measure_handles),
    Claim("generated", 2.5,
          "A generated model of {triangles:,} triangles with {handles} handles gets a layout with {overlaps} overlaps in "
          "{seconds:.0f} s on two threads, with reading and writing, and {megabytes:.0f} MB", measure_generated, is_long=True),
    Claim("published", 1,
          "The published method takes {least:.1f} to {largest:.1f} times as long as fast on {surfaces} surfaces, and {default_ratio:.1f} "
          "times as long as the default; cuts have {published_length:.2f}, {fast_length:.2f} and {default_length:.2f} diagonals",
          measure_published),
    Claim("python", 0.5, "The Python module adds at most {own_percent:.1f} % to the time of the library on {surfaces} surfaces",
          measure_python, needs="PYTHONPATH=build/python"),
    Claim("compiling", 2.5,
          "With the compiled library, the program of README.md compiles in {library_share:.2f} of the time of the headers alone, and "
          "in {library_ratio:.2f} times that of CGAL's ARAP parameterizer", measure_compiling),
]

if __name__ == "__main__":
    run("performance", CLAIMS)
