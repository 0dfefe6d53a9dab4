"""Where cuts run with weights, and how layouts are packed."""

import re
import statistics
import subprocess

from bench import Failed, Measured
from meshes import FIGURES

WEIGHTED = FIGURES[:6]
TASKS = {"front": "cost, ten times the length in front", "sky": "seen from above", "viewers": "seen from the front",
         "visibility": "seen from all around"}
SEVERAL_CHARTS = ["bones.off", "knot2.off", "blobby_3cc.off"]


def mean(rows, column):
    return statistics.fmean(float(row[column]) for row in rows)


def measure_weights(bench):
    values, table = {"surfaces": len(WEIGHTED)}, [["Task", "to be avoided", "", "length", "energy", "time"]]
    tasks = bench.all_rows([bench.program("weighted_cuts"), task, bench.options.meshes, *WEIGHTED] for task in TASKS)
    for (task, meaning), rows in zip(TASKS.items(), tasks):
        before, after = mean(rows, "avoided"), mean(rows, "constrained_avoided")
        change = 100 * (after / before - 1)
        length = 100 * (mean(rows, "constrained_L") / mean(rows, "L") - 1)
        time = mean(rows, "constrained_seconds") / mean(rows, "seconds")
        table.append([f"`{task}` ({meaning})", f"{before:.2f} to {after:.2f}", f"{change:+.0f} %", f"{length:+.0f} %",
                      f"{mean(rows, 'E'):.3f} to {mean(rows, 'constrained_E'):.3f}", f"{time:.2f}"])
        values |= {f"{task}_percent": -change, f"{task}_length": length, f"{task}_time": time}
    return Measured(values, {"tasks": table})


def measure_packing(bench):
    """Layouts with several charts: parts of CGAL's data set, and boxes."""
    meshes = bench.meshes(SEVERAL_CHARTS)
    for number in 12, 40, 100:
        meshes.append(bench.folder / f"boxes_{number}.off")
        write_boxes(meshes[-1], number)
    layouts = []
    for mesh in meshes:
        layouts.append(bench.folder / f"{mesh.stem}.obj")
        run = subprocess.run([bench.program("unwrap"), mesh, "-o", layouts[-1], "--effort", "fast", "--threads", "1", "--quiet"],
                             check=False)
        if run.returncode != 0:
            raise Failed(f"{mesh}: exit status {run.returncode}")
    rows, _ = bench.rows([bench.program("packing"), *layouts])
    rows = [row for row in rows if row["packed"] and re.fullmatch(r"\d+", row["charts"])]
    table = [["Layout", "charts", "shelves", "bitmap", "`pack_charts()`", "limit"]]
    for mesh, row in zip(meshes, rows):
        table.append([mesh.stem, row["charts"], *(f"{100 * float(row[way]):.1f} %" for way in
                                                  ("shelves", "bitmap", "packed", "limit"))])
    several = [row for row in rows if int(row["charts"]) >= 10]
    return Measured({"files": len(meshes), "several": 100 * mean(several, "packed"),
                     **{way: 100 * mean(rows, way) for way in ("shelves", "bitmap", "packed")}}, {"layouts": table})


def write_boxes(file, number):
    """Of different sizes, far from each other."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    lines = [f"OFF\n{8 * number} {12 * number} 0"]
    for i in range(number):
        sizes = 1 + i % 3, 1 + i % 5, 1 + i % 7
        lines += [" ".join(str(10 * i * (axis == 0) + x * size) for axis, (x, size) in enumerate(zip(corner, sizes)))
                  for corner in corners]
    for i in range(number):
        for a, b, c, d in quads:
            lines += [f"3 {8 * i + a} {8 * i + b} {8 * i + c}", f"3 {8 * i + a} {8 * i + c} {8 * i + d}"]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
