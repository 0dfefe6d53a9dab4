"""One shape at sizes from 2,000 to a million triangles."""

import csv
import json
import math
import pathlib
import shutil
import statistics
import subprocess

from bench import PUBLISHED, Measured, cut_seconds, total_seconds

SIZES = [2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000]
FAST = ["--effort", "fast", *PUBLISHED]
FITTED = 10000  # and more triangles: from there, points are found on a coarser version


def shapes(bench):
    """Made once for all claims."""
    folder = bench.folder.parent / "shapes"
    files = [folder / f"shape_{size}.ply" for size in SIZES]
    if not files[0].exists() or not files[-1].exists():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run([bench.program("make_sizes"), folder, bench.options.meshes / "cow.off", *map(str, SIZES)], check=True,
                       stdout=subprocess.DEVNULL)
    return files


def fitted_exponent(triangles, seconds):
    """The slope of the line through the logarithms."""
    points = [point for point in zip(triangles, seconds) if point[0] >= 0.99 * FITTED]
    return statistics.linear_regression(*([math.log(value) for value in column] for column in zip(*points))).slope


def measure_sizes(bench):
    records = bench.records(shapes(bench), *FAST)
    reports = [record["report"] for record in records]
    rows = [(report["faces"], cut_seconds(report), total_seconds(report), record["peak_memory_mb"])
            for report, record in zip(reports, records)]
    draw(bench, rows)
    triangles, cut, total, _ = zip(*rows)
    values = {"cut_exponent": fitted_exponent(triangles, cut), "exponent": fitted_exponent(triangles, total)}
    for size, (_, cut_time, time, megabytes) in zip(SIZES, rows):
        values |= {f"cut_seconds_{size}": cut_time, f"seconds_{size}": time, f"megabytes_{size}": megabytes}
    table = [["Triangles", "cut, s", "cut and UVs, s", "MB"]]
    table += [[f"{size:,}", f"{a:.2f}", f"{b:.2f}", f"{memory:,.0f}"] for size, a, b, memory in rows]
    return Measured(values, {"sizes": table})


def draw(bench, rows):
    """OUTPUT/sizes.csv, and scaling.png, the manual's figure, where there is gnuplot."""
    with open(bench.options.output / "sizes.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["triangles", "cut_s", "total_s", "memory_mb"])
        writer.writerows(rows)
    if shutil.which("gnuplot"):
        script = pathlib.Path(__file__).resolve().with_name("scaling.gnuplot")
        subprocess.run(["gnuplot", "-e", "file='sizes.csv'", script], cwd=bench.options.output, check=True,
                       stderr=subprocess.DEVNULL)


def measure_factorization(bench):
    """A whole run against one numeric factorization of its last system."""
    mesh, unwrapped, report = shapes(bench)[-1], bench.folder / "unwrapped.obj", bench.folder / "report.json"
    subprocess.run([bench.program("unwrap"), mesh, "-o", unwrapped, "--json", report, "--quiet", "--threads", "1", *FAST],
                   check=True)
    rows, _ = bench.rows([bench.program("assembly"), unwrapped])
    unwrapped.unlink()
    seconds = {row["solver"]: float(row["factorization_ms"]) / 1000 for row in rows}
    total = total_seconds(json.loads(report.read_text(encoding="utf-8")))
    return Measured({"triangles": int(rows[0]["triangles"]), "seconds": total, "own_seconds": seconds["supernodal"],
                     "simplicial_seconds": seconds["SimplicialLDLT"], "ratio": total / seconds["SimplicialLDLT"],
                     "own_ratio": total / seconds["supernodal"]})
