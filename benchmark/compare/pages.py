#!/usr/bin/env python3
"""Compares how many pages charts fill at the same texels per unit and margin: packed by this program, by xatlas, and as boxes on
shelves. Each OBJ is a layout, whose charts are packed as they are; the scale is such that they would fill about PAGES pages if they
filled three quarters of each. Prints a table; fill is the area of the charts by that of all pages."""

import argparse
import json
import pathlib
import subprocess
import sys

import numpy as np

import tables
from run_programs import ROOT
from surface_files import read_obj, triangulated, write_surface

HOPEFUL_FILL = 0.75
WATLAS = ROOT / "build/compare/node_modules/watlas/dist/watlas.js"


def flat_layout(path):
    """Points in the plane, triangles that run counterclockwise, and their area."""
    _, _, uvs, uv_faces = read_obj(path)
    faces = triangulated(uv_faces)
    points = np.array(uvs)
    a, b, c = (points[faces[:, k]] for k in range(3))
    areas = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    faces[areas < 0] = faces[areas < 0][:, ::-1]  # of charts that are mirrored
    return points, faces[areas != 0], np.abs(areas).sum()


def on_shelves(boxes, margin, side):
    """How many pages boxes need, the highest first, each on the last shelf, or on the next one, or on the next page."""
    pages, x, y, height = 1, 0, 0, 0
    room = side - margin
    for box in boxes[np.argsort(-boxes.min(axis=1))]:
        high, wide = sorted(box + margin)  # lying
        if x + wide > room:
            x, y, height = 0, y + height, 0
        if y + high > room:
            pages, x, y = pages + 1, 0, 0
        x, height = x + wide, max(height, high)
    return pages


def connected_parts(points, faces):
    """The least point of the part of each point."""
    part = np.arange(len(points))
    while True:
        least = part.copy()
        np.minimum.at(least, faces.ravel(), np.repeat(part[faces].min(axis=1), 3))
        least = least[least]
        if np.array_equal(least, part):
            return part
        part = least


def apart(points, faces):
    """The charts in a grid, since xatlas joins what has a corner in common, and the sizes of their boxes."""
    used, part = np.unique(faces), connected_parts(points, faces)
    order = used[np.argsort(part[used], kind="stable")]
    charts = np.split(order, np.flatnonzero(np.diff(part[order])) + 1)
    lows = np.array([points[chart].min(axis=0) for chart in charts])
    boxes = np.array([np.ptp(points[chart], axis=0) for chart in charts])
    columns, step = int(np.ceil(np.sqrt(len(charts)))), 1.1 * boxes.max()
    moved = points.copy()
    for k, chart in enumerate(charts):
        moved[chart] += step * np.array([k % columns, k // columns]) - lows[k]
    return moved, boxes


def told(command):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"{command[0]}: {run.stderr.strip()}")
    return run.stdout


def write_layout(path, points, faces):
    """The flat surface as its own layout."""
    write_surface(path, points, faces)
    with open(path, "a", encoding="ascii") as file:
        file.writelines("vt %r %r\n" % tuple(point) for point in points[:, :2].tolist())
    lines = path.read_text(encoding="ascii").splitlines()
    path.write_text("\n".join("f " + " ".join(f"{k}/{k}" for k in line.split()[1:]) if line[0] == "f" else line for line in lines)
                    + "\n", encoding="ascii")


def compare(path, folder, pages, margin, side):
    points, faces, area = flat_layout(path)
    points, boxes = apart(points, faces)
    points = np.column_stack([points, np.zeros(len(points))])
    density = side * np.sqrt(HOPEFUL_FILL * pages / area)
    folder.mkdir(parents=True, exist_ok=True)
    flat, layout, report = (folder / (path.stem + end) for end in (".obj", "_layout.obj", ".json"))
    write_surface(flat, points, faces)
    write_layout(layout, points, faces)
    told([ROOT / "build/bin/unwrap", layout, "-o", folder / f"{path.stem}_packed.obj", "--pack-only", "--texels-per-unit", density,
          "--texture-size", side, "--margin", margin, "--threads", 1, "--json", report, "--quiet"])
    ours = json.loads(report.read_text(encoding="utf-8"))
    xatlas = json.loads(told(["node", ROOT / "benchmark/compare/pack_by_xatlas.mjs", WATLAS, flat, density, side, margin]))
    counts = {"ours": ours["pages"], "xatlas": xatlas["pages"], "shelves": on_shelves(density * boxes, margin, side)}
    fills = {f"{name} %": 100 * area * density ** 2 / (count * side ** 2) for name, count in counts.items()}
    return {"layout": path.stem, "charts": len(boxes), **counts, **fills, "s": ours["cpu_seconds"]["packing"],
            "xatlas s": xatlas["seconds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layouts", nargs="+", type=pathlib.Path, help="OBJ files with texture coordinates")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/compare/pages", metavar="FOLDER")
    parser.add_argument("--pages", type=float, default=4)
    parser.add_argument("--margin", type=float, default=4, metavar="TEXELS")
    parser.add_argument("--texture-size", type=int, default=1024, metavar="TEXELS")
    arguments = parser.parse_args()
    rows = [compare(path, arguments.output, arguments.pages, arguments.margin, arguments.texture_size) for path in arguments.layouts]
    cells = [[value if isinstance(value, str) else f"{value:.3g}" if isinstance(value, float) else str(value) for value in row.values()]
             for row in rows]
    print(tables.markdown([list(rows[0]), *cells]))


if __name__ == "__main__":
    main()
