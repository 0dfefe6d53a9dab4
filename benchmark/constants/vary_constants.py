#!/usr/bin/env python3
"""Doubles and halves each constant of constants.csv, and compares the results with those of the library as it is.

usage: vary_constants.py [--meshes FOLDER] [--build FOLDER] [--only REGEX] [--repetitions N]
       vary_constants.py --table

Builds the benchmark programs once against headers whose constants can be varied (varied_headers.py), runs those
that read the constant, and adds a line for each constant and factor to BUILD/results.csv. Lines that are there are
not measured again. --table prints all constants with these."""

import argparse
import collections
import csv
import itertools
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

import varied_headers

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FACTORS = (0.5, 2)
FIELDS = ["constant", "factor", "runs", "changed", "failed", "length", "energy", "time"]
LEAST_TIME = 10  # per cent; on a machine with other work, repetitions differ by up to seven

Program = collections.namedtuple("Program", "name options meshes")
SMALL = ["anchor", "eight", "hand", "helmet", "joint", "rotor", "sphere", "spool"]
PROGRAMS = {
    "default": Program("pipeline", [], SMALL + ["bear_bis", "boeing", "cactus", "elk", "fandisk", "head", "mushroom",
                                                "pinion", "three_peaks"]),
    "medium": Program("pipeline", [], ["cow", "dino", "femur", "triceratops"]),
    "medium_fast": Program("pipeline", ["--effort", "fast"], ["bull", "cow", "dino", "elephant", "fandisk", "femur",
                                                              "homer", "triceratops"]),
    "larger_fast": Program("pipeline", ["--effort", "fast"], ["bear", "camel", "lion-head", "mannequin-devil"]),
    "bijective": Program("pipeline", ["--bijective", "--effort", "fast"],
                         ["boeing", "cactus", "couplingdown", "elephant", "elephant-with-holes", "elk", "holes",
                          "three_peaks", "triceratops"]),
    "coarse_slits": Program("pipeline", ["--bijective", "--effort", "fast"],
                            ["armadillo", "bull", "refined_elephant", "turbine"]),
    "bound": Program("pipeline", ["--max-distortion", "4.1"], SMALL),
    "bijective_bound": Program("pipeline", ["--bijective", "--max-distortion", "4.15", "--effort", "fast"],
                               ["cactus", "couplingdown", "handle"]),
    "fast_bound": Program("pipeline", ["--max-distortion", "4.1", "--effort", "fast"], SMALL),
    "coarse_bound": Program("pipeline", ["--max-distortion", "4.05", "--effort", "fast"], ["fandisk"]),
    "coarser_bound": Program("pipeline", ["--max-distortion", "4.1"], ["dino", "fandisk", "femur"]),
    "room": Program("pipeline", ["--bijective", "--max-distortion", "4.1"],
                    ["cactus", "camel", "couplingdown", "elk", "three_peaks", "triceratops"]),
    "large": Program("pipeline", ["--effort", "fast"], ["bunny00", "refined_elephant"]),
    "many_handles": Program("pipeline", ["--effort", "fast"], ["cheese"]),
    "many_handles_bound": Program("pipeline", ["--max-distortion", "4.1", "--effort", "fast"], ["cheese"]),
    "best_bound": Program("pipeline", ["--effort", "best", "--max-distortion", "4.1"],
                          ["anchor", "eight", "helmet", "joint", "sphere"]),
    "best": Program("pipeline", ["--effort", "best"], ["anchor", "eight", "helmet", "joint", "sphere"]),
    "published": Program("pipeline", ["--faithful"], SMALL + ["elk", "head", "mushroom", "pinion"]),
    "handles": Program("pipeline", ["--effort", "fast"], ["anchor", "eight", "elephant", "elk", "helmet", "joint",
                                                          "knot1", "pinion", "rotor"]),
    # what weights cost, and how much charts fill: in place of lengths
    "packing": Program("packing", [], ["blobby_3cc", "bones", "cheese", "knot2"]),
    "weighted": Program("weighted_cuts", ["front"], ["anchor", "eight", "hand", "helmet", "rotor", "spool"]),
    "weighted_coarse": Program("weighted_cuts", ["front"], ["dino"]),
    "trees": Program("connect_many_terminals", ["60", "1"], ["cactus", "hand", "head"]),
}

Run = collections.namedtuple("Run", "kind mesh")
Outcome = collections.namedtuple("Outcome", "is_done result length energy seconds")


class Runner:
    def __init__(self, binaries, meshes):
        self.binaries, self.meshes = binaries, meshes

    def command(self, run):
        program = PROGRAMS[run.kind]
        mesh = str(self.meshes / (run.mesh + ".off"))
        if program.name == "packing":
            return [str(self.binaries / program.name), str(self.layout(run.mesh))]
        if program.name == "weighted_cuts":
            return [str(self.binaries / program.name), *program.options, str(self.meshes), run.mesh + ".off"]
        options = ["--repetitions", "1"] if program.name == "pipeline" else []
        return [str(self.binaries / program.name), mesh, *program.options, *options]

    def layout(self, mesh):
        """Some charts: parts at one scale, not packed yet."""
        file = self.binaries / (mesh + ".obj")
        if not file.exists():
            subprocess.run([str(ROOT / "build/bin/unwrap"), str(self.meshes / (mesh + ".off")), "--uv-scale", "surface",
                            "--quiet", "-o", str(file)], check=True)
        return file

    def __call__(self, run, time_limit, **variables):
        """The outcome; not done if the program fails or takes too long."""
        try:
            process = subprocess.run(self.command(run), env={**os.environ, **variables}, timeout=time_limit,
                                     stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        except subprocess.TimeoutExpired:
            return Outcome(False, "time limit", 0, 0, time_limit)
        if process.returncode != 0:
            return Outcome(False, "crash", 0, 0, 0)
        rows = list(csv.DictReader(process.stdout.splitlines()))
        return OUTCOMES[PROGRAMS[run.kind].name](rows)


def outcome_of_pipeline(rows):
    row = rows[0]
    is_done = row["status"] == "done"
    if not is_done:
        return Outcome(False, row["status"], 0, 0, 0)
    result = tuple(row[key] for key in ("candidates", "features", "auxiliary", "L", "E", "largest_face_distortion"))
    return Outcome(True, result, float(row["L"]), float(row["E"]), float(row["total_s"]))


def outcome_of_weighted_cuts(rows):
    """The cost in place of the length."""
    row = {key.removeprefix("constrained_"): value for key, value in rows[0].items() if key.startswith("constrained_")}
    result = tuple(row[key] for key in ("L", "avoided", "E"))
    return Outcome(True, result, float(row["avoided"]), float(row["E"]), float(row["seconds"]))


def outcome_of_packing(rows):
    """The fill in place of the length."""
    return Outcome(True, rows[0]["packed"], float(rows[0]["packed"]), 0, float(rows[0]["seconds"]))


def outcome_of_trees(rows):
    result = tuple((row["length"], row["lower_bound"], row["optimal"]) for row in rows)
    return Outcome(True, result, sum(float(row["length"]) for row in rows), 0,
                   sum(float(row["cpu_seconds"]) for row in rows))


OUTCOMES = {"pipeline": outcome_of_pipeline, "weighted_cuts": outcome_of_weighted_cuts,
            "packing": outcome_of_packing, "connect_many_terminals": outcome_of_trees}
PACKAGES = {"pipeline": "Surface_mesh_cutting", "weighted_cuts": "Surface_mesh_cutting",
            "packing": "Surface_mesh_cutting", "connect_many_terminals": "BGL"}


def build(folder, constants, programs):
    """The folder of these programs. Their sources are copied, since they find the headers relative to themselves."""
    varied_headers.write_varied_headers(ROOT / "include", folder / "include", constants)
    shutil.copytree(ROOT / "benchmark", folder / "benchmark", dirs_exist_ok=True)
    binaries = folder / "bin"
    for program in programs:
        package = PACKAGES[program]
        subprocess.run(["cmake", "-S", str(folder / "benchmark" / package), "-B", str(folder / package),
                        "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_MODULE_PATH={ROOT / 'cmake'}",
                        f"-DCMAKE_RUNTIME_OUTPUT_DIRECTORY={binaries}", "--log-level=ERROR"], check=True)
        subprocess.run(["cmake", "--build", str(folder / package), "--target", program], check=True)
    return binaries


def references(runner, kinds, repetitions):
    """For each run, its outcome with the median of the times, and the rows of the constants that it reads."""
    result = {}
    with tempfile.TemporaryDirectory() as folder:
        read = pathlib.Path(folder) / "read"
        for kind in kinds:
            for run in (Run(kind, mesh) for mesh in PROGRAMS[kind].meshes):
                outcomes = [runner(run, 600, VARY_READ=str(read)) for _ in range(repetitions)]
                if len({outcome.result for outcome in outcomes}) != 1:
                    sys.exit(f"{run} is not deterministic: {outcomes}")
                if not outcomes[0].is_done:
                    sys.exit(f"{run} fails: {outcomes[0].result}")
                seconds = statistics.median(outcome.seconds for outcome in outcomes)
                result[run] = (outcomes[0]._replace(seconds=seconds), set(map(int, read.read_text().split())))
    return result


def measure(runner, runs, variation):
    """`runs` with their outcomes. Means of the changes of length, in per cent, and energy; time in per cent."""
    changed = failed = 0
    lengths, energies, seconds, former_seconds = [], [], 0, 0
    for run, former in runs.items():
        outcome = runner(run, 60 + 20 * former.seconds, VARY=variation)
        changed += outcome.result != former.result
        if not outcome.is_done:
            failed += 1
            continue
        if former.length > 0:
            lengths.append(100 * (outcome.length / former.length - 1))
        if former.energy > 0:
            energies.append(outcome.energy - former.energy)
        seconds += outcome.seconds
        former_seconds += former.seconds
    return {"runs": len(runs), "changed": changed, "failed": failed,
            "length": f"{statistics.mean(lengths or [0]):.2f}", "energy": f"{statistics.mean(energies or [0]):.4f}",
            "time": f"{100 * (seconds / former_seconds - 1):.0f}" if former_seconds > 0 else "0"}


def read_results(path):
    if not path.exists():
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        return {(row["constant"], float(row["factor"])): row for row in csv.DictReader(file)}


def vary(constants, arguments, path):
    done = read_results(path)
    to_do = [(c["constant"], row, c["runs"].split(), factor) for row, c in enumerate(constants) for factor in FACTORS
             if c["runs"] and (c["constant"], factor) not in done and re.search(arguments.only, c["constant"])]
    kinds = sorted({kind for task in to_do for kind in task[2]})
    binaries = build(path.parent.resolve(), constants, sorted({PROGRAMS[kind].name for kind in kinds}))
    runner = Runner(binaries, arguments.meshes.resolve())
    known = references(runner, kinds, arguments.repetitions)
    with open(path, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        if not done:
            writer.writeheader()
        for name, row, kinds, factor in to_do:
            runs = {run: outcome for run, (outcome, read) in known.items() if run.kind in kinds and row in read}
            result = measure(runner, runs, f"{row}:{factor}")
            writer.writerow({"constant": name, "factor": factor, **result})
            file.flush()
            print(name, factor, *result.values(), flush=True)


def effect(result):
    """As a cell of the table."""
    if result is None:
        return "not measured"
    if int(result["runs"]) == 0:
        return "not read"
    time = float(result["time"])
    parts = [f"{result['failed']} fail"] if int(result["failed"]) > 0 else []
    if int(result["changed"]) > 0:
        length, energy = round(float(result["length"]), 1), round(float(result["energy"]), 3)
        change = f": L {length or 0.:+} %, E {energy or 0.:+}" if length or energy else " in digits"
        parts.append(f"{result['changed']}/{result['runs']}{change}")
    if abs(time) >= LEAST_TIME:
        parts.append(f"time {time:+.0f} %")
    return "; ".join(parts) or "="


def print_table(constants, results):
    for package, group in itertools.groupby(constants, lambda c: c["file"].split("/")[0]):
        print(f"`CGAL/{package}`\n\n| file | constant | value | unit | reason | halved | doubled |\n"
              "|---|---|---|---|---|---|---|")
        for c in group:
            effects = [effect(results.get((c["constant"], factor))) if c["runs"] else "not varied" for factor in FACTORS]
            form = f" ({c['form']})" if c["form"] in ("excess", "power") else ""
            print("|", " | ".join([f"`{c['file'].split('/')[-1]}`", c["constant"] + form, varied_headers.value(c),
                                   c["unit"], c["reason"], *effects]), "|")
        print()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--meshes", type=pathlib.Path, default=ROOT / "build/data/meshes", help="CGAL's data set")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/constants")
    parser.add_argument("--only", default="", help="constants to measure, a regular expression")
    parser.add_argument("--repetitions", type=int, default=3, help="of the unchanged runs")
    parser.add_argument("--table", action="store_true")
    arguments = parser.parse_args()
    constants = varied_headers.read_constants(HERE / "constants.csv")
    path = arguments.build / "results.csv"
    if arguments.table:
        print_table(constants, read_results(path))
    else:
        vary(constants, arguments, path)


if __name__ == "__main__":
    main()
