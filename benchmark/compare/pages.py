#!/usr/bin/env python3
"""Compares how many pages charts fill at the same texels per unit and margin: packed by this program, by xatlas, and as boxes on
shelves. Each OBJ is a layout of 20 to 2000 charts, which are packed as they are, as often as it takes to fill PAGES pages to three
quarters, but no more than 2000 charts in all; the scale is such that its largest chart is 0.7 pages wide, or that one copy of it
fills these pages. Writes pages.json and prints a table; fill is the area of the charts by that of all pages."""

import argparse
import json
import pathlib
import subprocess
import sys

import numpy as np

import tables
from run_programs import ROOT
from surface_files import read_obj, triangulated

HOPEFUL_FILL = 0.75
FITTING_SHARE = 0.7  # of the side of a page, at most, is the side of a chart's box, since xatlas turns charts
LEAST_CHARTS, MOST_CHARTS = 20, 2000
PACKERS = ("ours", "xatlas", "shelves")
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
    """A flat surface with itself as its layout."""
    with open(path, "w", encoding="ascii") as file:
        file.writelines("v %r %r 0\nvt %r %r\n" % (x, y, x, y) for x, y in points.tolist())
        file.writelines("f " + " ".join(f"{k}/{k}" for k in face) + "\n" for face in (faces + 1).tolist())


def compare(path, folder, pages, margin, side):
    points, faces, area = flat_layout(path)
    boxes = apart(points, faces)[1]
    if not LEAST_CHARTS <= len(boxes) <= MOST_CHARTS:
        return None
    hopeful = HOPEFUL_FILL * pages * side ** 2 / area
    density = min(np.sqrt(hopeful), FITTING_SHARE * (side - 2 * margin) / boxes.max())
    copies = max(1, min(round(hopeful / density ** 2), MOST_CHARTS // len(boxes)))
    faces = np.concatenate([faces + k * len(points) for k in range(copies)])
    points, boxes = apart(np.tile(points, (copies, 1)), faces)
    area *= copies
    folder.mkdir(parents=True, exist_ok=True)
    layout, report = folder / f"{path.stem}.obj", folder / f"{path.stem}.json"
    write_layout(layout, points, faces)
    told([ROOT / "build/bin/unwrap", layout, "-o", folder / f"{path.stem}_packed.obj", "--pack-only", "--texels-per-unit", density,
          "--texture-size", side, "--margin", margin, "--threads", 1, "--json", report, "--quiet"])
    ours = json.loads(report.read_text(encoding="utf-8"))["pages"]
    xatlas = int(told(["node", ROOT / "benchmark/compare/pack_by_xatlas.mjs", WATLAS, layout, density, side, margin]))
    counts = [ours, xatlas, on_shelves(density * boxes, margin, side)]
    return {"layout": path.stem, "charts": len(boxes), "pages": dict(zip(PACKERS, counts)),
            "fill": {packer: area * density ** 2 / (count * side ** 2) for packer, count in zip(PACKERS, counts)}}


def summary(rows):
    found = {"layouts": len(rows), "fewest": sum(row["pages"]["ours"] <= min(row["pages"].values()) for row in rows)}
    for packer in PACKERS:
        found |= {f"{packer}_pages": sum(row["pages"][packer] for row in rows),
                  f"{packer}_fill": 100 * float(np.mean([row["fill"][packer] for row in rows]))}
    return found


def table(rows):
    cells = [["layout", "charts", *(f"pages, {packer}" for packer in PACKERS), *(f"fill, {packer}" for packer in PACKERS)]]
    return cells + [[row["layout"], f"{row['charts']:,}", *map(str, row["pages"].values()),
                     *(f"{fill:.3f}" for fill in row["fill"].values())] for row in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layouts", nargs="+", type=pathlib.Path, help="OBJ files with texture coordinates")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/compare/pages", metavar="FOLDER")
    parser.add_argument("--pages", type=float, default=4)
    parser.add_argument("--margin", type=float, default=4, metavar="TEXELS")
    parser.add_argument("--texture-size", type=int, default=1024, metavar="TEXELS")
    arguments = parser.parse_args()
    rows = [row for path in arguments.layouts
            if (row := compare(path, arguments.output, arguments.pages, arguments.margin, arguments.texture_size))]
    found = {"values": summary(rows), "layouts": table(rows)}
    (arguments.output / "pages.json").write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(tables.markdown(found["layouts"]))


if __name__ == "__main__":
    main()
