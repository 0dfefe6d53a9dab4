"""Steiner trees: through random points, through many, and on the graphs of PACE 2018."""

import re
import statistics
import sys

from bench import ROOT, Failed, Measured
from meshes import CLOSED

METHODS = {"mst": "Metric_closure_tag", "sph": "Shortest_path_heuristic_tag", "greedy": "Greedy_auxiliary_points_tag",
           "local": "Local_search_tag", "best": "Best_tag"}


def measure_trees(bench):
    """The paper's comparison of Section 4.3, with ten sets of each size on each mesh."""
    rows, _ = bench.rows([bench.program("connect_random_terminals"), bench.options.meshes, *CLOSED])
    values = {"sets": len(rows), "surfaces": len(CLOSED), "proven": sum(row["optimal"] == "1" for row in rows)}
    table = [["Tag", "shortest", "mean ratio", "largest ratio", "median time", "largest time"]]
    for name, tag in METHODS.items():
        ratios = [float(row[f"length_{name}"]) / float(row["length_best"]) for row in rows]
        seconds = [float(row[f"seconds_{name}"]) for row in rows]
        shortest = sum(ratio <= 1 + 1e-9 for ratio in ratios) / len(ratios)
        table.append([f"`{tag}`", f"{100 * shortest:.1f} %", f"{statistics.fmean(ratios):.4f}", f"{max(ratios):.3f}",
                      f"{1000 * statistics.median(seconds):.0f} ms", f"{1000 * max(seconds):.0f} ms"])
        values |= {f"{name}_percent": 100 * shortest, f"{name}_ratio": statistics.fmean(ratios)}
    values["median_ms"] = 1000 * statistics.median(float(row["seconds_best"]) for row in rows)
    return Measured(values, {"methods": table})


def measure_many_terminals(bench):
    mesh = bench.options.meshes / "refined_elephant.off"
    rows, _ = bench.rows([bench.program("connect_many_terminals"), mesh, 26])
    exact = [row for row in rows if row["method"] == "exact"]
    seconds = [float(row["cpu_seconds"]) for row in exact]
    if any(row["optimal"] != "1" for row in exact):
        raise Failed("a tree is not proven shortest")
    with open(mesh, encoding="utf-8") as file:
        vertices = int(re.search(r"(\d+)\s+\d+\s+\d+", file.read(1000)).group(1))
    return Measured({"vertices": vertices, "least_s": min(seconds), "largest_s": max(seconds)})


def measure_pace(bench):
    graphs, limit = bench.given("graphs"), 20
    script = ROOT / "benchmark" / "BGL" / "pace.py"
    found = {}
    for method in "exact", "best":
        found[method], _ = bench.rows([sys.executable, "-B", script, bench.program("steiner_pace"), graphs,
                                       graphs / "optimum.csv", "--method", method, "--seconds", limit])
    ratios = [float(row["ratio"]) for row in found["best"] if row["ratio"]]
    return Measured({"graphs": len(found["exact"]), "solved": sum(bool(row["ratio"]) for row in found["exact"]), "limit": limit,
                     "found": len(ratios), "percent": 100 * (max(ratios) - 1)})
