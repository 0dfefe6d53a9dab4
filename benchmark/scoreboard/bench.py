"""What measuring a claim needs: programs, meshes, and runs of unwrap that are kept and not repeated."""

import argparse
import concurrent.futures
import csv
import dataclasses
import io
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmark" / "Surface_mesh_cutting" / "Robustness" / "corpus"))

import run_corpus  # noqa: E402
from outcomes import read_records  # noqa: E402

PUBLISHED = ["--allow-overlap", "--uv-scale", "surface"]  # what the method's authors make: charts that may overlap


class Missing(Exception):
    """Something that does not come with the project and was not given, such as a folder of meshes."""


class Failed(Exception):
    """A program that ended as it must not."""


@dataclasses.dataclass
class Measured:
    """Numbers by name, and tables by name: rows of text, of which the first has the headings."""
    values: dict
    tables: dict = dataclasses.field(default_factory=dict)


@dataclasses.dataclass
class Bench:
    options: argparse.Namespace
    folder: pathlib.Path  # for intermediate files

    def program(self, name):
        program = self.options.programs / name
        if not program.exists():
            raise Missing(f"the program {name}: scripts/build.sh --target {name}")
        return program

    def meshes(self, names):
        """Of CGAL's data set."""
        return [self.options.meshes / name for name in names]

    def given(self, option):
        folder = getattr(self.options, option)
        if not folder:
            raise Missing(f"--{option} FOLDER")
        return folder

    def models(self, table):
        """The rows of one of the tables in benchmark/results, and where the model is that each names."""
        with open(ROOT / "benchmark" / "results" / table, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return rows, [self.given("models") / row["model"] for row in rows]

    def records(self, meshes, *words, jobs=1, repetition=0, time_limit=600):
        """Those of Robustness/corpus/run_mesh.py, in the order of the meshes; what is there from a former call is not run
        again. Where times count, one run at a time."""
        results = self.folder / f"runs_{repetition}.jsonl"
        options = ["--threads", "1", *map(str, words)] if "--threads" not in words else list(map(str, words))
        arguments = argparse.Namespace(program=self.program("unwrap"), results=results, jobs=jobs, judge=None, sshlogin=None, part="0/1",
                                       time_limit=time_limit, memory_limit=0, options=options,
                                       meshes=list(map(str, meshes)), largest=float("inf"))
        left = run_corpus.to_do(arguments)
        if left and run_corpus.run(arguments, left) != 0:
            raise Failed("GNU parallel")
        found = {record["mesh"]: record for record in read_records(results) if record["options"] == options}
        return [found[str(mesh)] for mesh in meshes]

    def reports(self, meshes, *words, **keywords):
        """The reports alone; each run must have a result that is proven valid."""
        records = self.records(meshes, *words, **keywords)
        for record in records:
            if record["outcome"] not in ("certified", "bound_not_reached"):
                raise Failed(f"{record['mesh']}: {record['outcome']} {record['messages']}")
        return [record["report"] for record in records]

    def rows(self, command):
        """The lines of CSV that a program prints, and what it says on standard error."""
        run = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise Failed(f"{command[0]}: {run.stderr}")
        return list(csv.DictReader(io.StringIO(run.stdout))), run.stderr

    def all_rows(self, commands):
        """The same of several commands, side by side."""
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            return [rows for rows, _ in pool.map(self.rows, commands)]


def cut_seconds(report):
    """Processor time without the final map and its packing."""
    seconds = report["cpu_seconds"]
    return seconds["total"] - seconds["parameterize"] - (seconds["packing"] or 0)


def total_seconds(report):
    return report["cpu_seconds"]["total"]


def mean_of(reports, key):
    return statistics.fmean(report[key] for report in reports)
