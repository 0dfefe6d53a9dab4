#!/usr/bin/env python3
"""Measures how runs end on many meshes of all kinds, and when they are stopped. --help tells the options, --list the
claims."""

import collections
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "scoreboard"))

from bench import Measured  # noqa: E402
from driver import Claim, run  # noqa: E402
from meshes import CLOSED  # noqa: E402
from ramp import write_ramp  # noqa: E402
from run_corpus import meshes_in  # noqa: E402

VARIANTS = 1000
LIMIT = 60  # seconds, of the program itself: then it writes the best result so far
OPTIONS = ["--effort", "fast", "--time-limit", LIMIT]
ACCEPTED = ("certified", "refused", "stopped")


def run_all(bench, meshes):
    """The records of all meshes in a folder; a call that was interrupted goes on where it was."""
    return bench.records(list(meshes_in([meshes])), *OPTIONS, jobs=bench.options.jobs, time_limit=300)


def outcomes(records):
    """Counts by class, and a line for the table."""
    counts = collections.Counter(record["outcome"] for record in records)
    unexpected = sum(count for name, count in counts.items() if name not in ACCEPTED)
    slowest = max(record["seconds"] for record in records)
    values = {"meshes": len(records), **{name: counts[name] for name in ACCEPTED}, "unexpected": unexpected,
              "slowest": slowest}
    return values, [*(f"{values[name]:,}" for name in ("meshes", *ACCEPTED, "unexpected")), f"{slowest:.1f}"]


def measured(records, name):
    """With the reasons of refusals, and all that must not happen."""
    values, line = outcomes(records)
    table = [["Meshes", "number", "proven", "refused", f"stopped at {LIMIT} s", "otherwise", "slowest, s"], [name, *line]]
    reasons = collections.Counter((record["report"] or {}).get("message", "").split(":")[0] for record in records
                                  if record["outcome"] == "refused")
    interpreted = sum(bool((record["report"] or {}).get("interpreted")) for record in records)
    polygons = sum(bool((record["report"] or {}).get("polygons")) for record in records)
    for record in records:
        if record["outcome"] not in ACCEPTED:
            print(f"{record['outcome']}: {record['mesh']}", file=sys.stderr)
    return Measured({**values, "interpreted": interpreted, "polygons": polygons},
                    {"outcomes": table, "refusals": [["Reason", "meshes"], *([a, str(b)] for a, b in reasons.most_common())]})


def measure_data_set(bench):
    return measured(run_all(bench, bench.options.meshes), "CGAL's data set")


def measure_variants(bench):
    """Stretched and bent, a third of them as soups and a third with polygons."""
    folder = bench.folder / "meshes"
    if not folder.exists():
        subprocess.run([sys.executable, "-B", HERE / "corpus" / "make_variants.py", folder, str(VARIANTS), bench.options.meshes,
                        "--kinds", "plain,soup,polygons", "--largest", "3000"], check=True)
    return measured(run_all(bench, folder), f"{VARIANTS:,} variants")


def measure_wild(bench):
    return measured(run_all(bench, bench.given("wild")), "what users bring")


def measure_first_maps(bench):
    """Ways to a first map without flips, on surfaces opened along a path and along their final cuts."""
    rows, _ = bench.rows([bench.program("initial_maps"), bench.options.meshes, *CLOSED])
    paths, cuts = ([row for row in rows if row["cut"] == kind] for kind in ("path", "final"))

    def with_spectral_map(repaired):
        return sum(float(row["spectral_flips"]) > 0 and row["repaired"] == "1" if repaired
                   else row["spectral_flips"] == "0" for row in paths)
    return Measured({
        "paths": len(paths), "spectral": with_spectral_map(False), "repaired": with_spectral_map(True),
        "tutte_failed": sum(row["tutte"] != "1" for row in paths), "stages_failed": sum(row["stage"] == "0" for row in rows),
        "cuts": len(cuts)})


def latest_end(bench, mesh, effort, limits):
    """Of runs that are stopped: their number, that of triangles, and how long after its time is up the last one ends, with the
    writing of its result."""
    records = [(bench.records([mesh], "--effort", effort, "--time-limit", limit)[0], limit) for limit in limits]
    late = [record["seconds"] - limit for record, limit in records if record["outcome"] == "stopped"]
    return len(late), records[-1][0]["report"]["faces"], max(late)


def measure_stops(bench):
    """A large surface, whose search takes long, and one whose division into charts does, at several times."""
    ramp = bench.folder / "ramp.off"
    write_ramp(ramp)
    runs, triangles, latest = latest_end(bench, bench.options.meshes / "refined_elephant.off", "best", (1, 2, 3, 5))
    ramp_runs, ramp_triangles, ramp_latest = latest_end(bench, ramp, "fast", range(1, 10))
    return Measured({"runs": runs, "triangles": triangles, "latest": latest, "ramp_runs": ramp_runs,
                     "ramp_triangles": ramp_triangles, "ramp_latest": ramp_latest})


ENDS = "{certified} are unwrapped with a proof, {refused} refused with a reason, {stopped} stopped after a minute, and " \
    "{unexpected} end otherwise"
CLAIMS = [
    Claim("data_set", 2, "Of the {meshes} files of CGAL's data set, " + ENDS + "; {interpreted} are not read as what they say",
          measure_data_set),
    Claim("variants", 2.5, "Of {meshes:,} variants, meshes, soups and polygons, " + ENDS, measure_variants),
    Claim("wild", 2, "Of {meshes} meshes from outside, " + ENDS, measure_wild, needs="--wild FOLDER"),
    Claim("stops", 1,
          "Runs on {triangles:,} triangles end at most {latest:.2f} s after their time is up, and such that divide a ramp of "
          "{ramp_triangles:,} into charts at most {ramp_latest:.2f} s", measure_stops),
    Claim("first_maps", 1,
          "Of {paths} surfaces opened along a path, the spectral map has no flips on {spectral}, {repaired} are repaired; maps "
          "through coarse versions fail on {stages_failed}", measure_first_maps),
]

if __name__ == "__main__":
    run("robustness", CLAIMS)
