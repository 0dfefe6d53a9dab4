#!/usr/bin/env python3
"""Unwraps meshes and writes the measures of their maps in the columns of the parameterization benchmark of Shay, Solomon
and Stein (distortion_characteristics.csv of its uncut meshes), which its own report then reads; the last column, which
that benchmark lacks, is the exact number of overlaps.

What compares with an artist's map is empty. A mesh that yields no map has a row without measures, and the exit status
is then 1."""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

MEASURES = {"Max Area Distortion": "max_area_distortion", "Average Area Discrepancy": "average_area_discrepancy",
            "Min Singular Value": "min_singular_value", "Max Singular Value": "max_singular_value",
            "Proportion Flipped Triangles": "proportion_flipped_triangles",
            "Max Angle Distortion": "max_angle_distortion", "Average Angle Discrepancy": "average_angle_discrepancy",
            "Resolution": "resolution", "Symmetric Dirichlet Energy": "symmetric_dirichlet_energy",
            "Mesh Cut Length": "mesh_cut_length", "Overlaps": "overlaps"}
COLUMNS = ["Filename", "Faces", "Vertices", "Max Area Distortion", "Average Area Discrepancy", "Min Singular Value",
           "Max Singular Value", "Proportion Flipped Triangles", "Max Angle Distortion", "Average Angle Discrepancy",
           "Resolution", "Artist Correlation", "Remeshed", "Symmetric Dirichlet Energy", "Mesh Cut Length",
           "Artist Mesh Cut Length Match", "Overlaps"]


def row_of(command, mesh, folder):
    result = subprocess.run([*command, mesh, "-o", folder / (mesh.stem + ".obj"), "--json", "-", "--quiet"],
                            stdout=subprocess.PIPE, check=False)
    report = json.loads(result.stdout)
    row = {"Filename": mesh.name, "Faces": report["faces"], "Vertices": report["vertices"]}
    measures = report["distortion"]
    if measures is not None:
        row["Remeshed"] = False
        row.update({column: measures[key] for column, key in MEASURES.items()})
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="the program unwrap")
    parser.add_argument("output", type=pathlib.Path, help="the table to write")
    parser.add_argument("meshes", type=pathlib.Path, nargs="+")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER", help="also keep the meshes with their maps, as OBJ")
    parser.add_argument("--options", default="", help="further options of unwrap")
    arguments = parser.parse_args()
    command = [arguments.program, *arguments.options.split()]
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        rows = [row_of(command, mesh, folder) for mesh in arguments.meshes]
    with arguments.output.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    return 0 if all("Remeshed" in row for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
