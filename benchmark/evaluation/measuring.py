"""What all experiments share: how the programs are called and their answers read, tables, and claims."""

import csv
import dataclasses
import io
import json
import math
import pathlib
import statistics


@dataclasses.dataclass
class Claim:
    """A statement of the paper, its figure and ours, whether it holds (None: not measured), and what explains that."""
    source: str
    statement: str
    paper: str
    ours: str
    holds: bool | None
    reason: str = ""

    def verdict(self):
        return {True: "holds", False: "does not hold", None: "not measured"}[self.holds]


class Setting:
    """The programs, the meshes and where results go."""

    def __init__(self, programs, output):
        self.programs, self.output = pathlib.Path(programs), pathlib.Path(output)
        self.closed = []  # paths of the closed connected meshes of genus 0, from small to large
        self.values = {}  # numbers that the manual quotes
        self.stages = []  # lines of Table 3
        self.thresholds = []  # lines of cause_threshold.csv
        self.triangulations = {}  # {name: line of Figure 12}
        self.rivals = {}  # {detector: {name of the mesh: its line}} where the detector succeeded

    def unwrap(self, mesh, *options):
        """One thread: times of meshes that run side by side then mean something."""
        scratch = self.output / "scratch"
        scratch.mkdir(parents=True, exist_ok=True)
        # Pieces may run at the same time and must not share an output.
        name = "_".join([mesh.name, *map(str, options)]).replace("/", "_")
        return [self.programs / "unwrap", mesh, "-o", scratch / f"{name}.obj", "--json", "-", "--quiet",
                "--threads", "1", "--uv-scale", "surface",
                "--allow-overlap", *options]

    def detectors(self, mesh, detectors, connections):
        return [self.programs / "compare_detectors", "--detectors", detectors, "--connect", connections, mesh]

    def write_table(self, name, rows):
        """`rows` are dictionaries with the same keys; nothing is written if there is none."""
        if not rows:
            return
        with open(self.output / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)


def report(outcome):
    """The report of a run of unwrap that has a result, or None."""
    if outcome.exit_code not in (0, 7):
        return None
    return json.loads(outcome.output)


def rows(outcome):
    """The lines of CSV that a program printed, numbers as such."""
    return [{key: number(value) for key, value in row.items()}
            for row in csv.DictReader(io.StringIO(outcome.output)) if None not in row.values()]


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return text


def mean(values):
    values = list(values)
    return statistics.fmean(values) if values else math.nan


def rank_correlation(xs, ys):
    """Spearman's: 1 if ys grow with xs, -1 if they fall."""
    def ranks(values):
        return [sum(w < v for w in values) + (sum(w == v for w in values) - 1) / 2 for v in values]
    if len(set(xs)) < 2 or len(set(ys)) < 2:
        return 0.
    return statistics.correlation(ranks(xs), ranks(ys))
