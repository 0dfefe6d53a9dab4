"""The command line that the drivers of Performance, Quality and Robustness share."""

import argparse
import dataclasses
import datetime
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import time
from typing import Callable

import results
from bench import ROOT, Bench, Failed, Missing


@dataclasses.dataclass
class Claim:
    name: str
    minutes: float  # that measuring it takes, about
    statement: str  # a format string of the values
    measure: Callable  # Bench -> Measured
    needs: str = ""  # options without which it cannot be measured
    is_long: bool = False  # measured only if it is asked for by name


def commit():
    """The commit, with a + if what is measured was changed since."""
    git = ["git", "-C", ROOT]
    try:
        name = subprocess.run([*git, "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
        changes = subprocess.run([*git, "diff", "--quiet", "HEAD", "--", "include", "src", "examples", "benchmark",
                                  ":!benchmark/results", ":!benchmark/README.md"], check=False).returncode
    except (FileNotFoundError, subprocess.CalledProcessError):
        return "unknown"
    return name + ("+" if changes else "")


def processor():
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


def read_arguments(driver, claims):
    parser = argparse.ArgumentParser(
        description=f"Measures the claims of benchmark/Surface_mesh_cutting/{driver.capitalize()} and appends them to "
                    f"benchmark/results/{driver}.json. What was measured of the same commit is not measured again.")
    parser.add_argument("--list", action="store_true", help="only tell the claims and how long they take")
    parser.add_argument("--only", action="append", choices=[claim.name for claim in claims], metavar="CLAIM",
                        help="this claim; may be repeated. Default: all that do not take long")
    parser.add_argument("--again", action="store_true", help="measure anew what was measured of this commit")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/bin", metavar="FOLDER")
    parser.add_argument("--meshes", type=pathlib.Path, default=ROOT / "build/data/meshes", metavar="FOLDER",
                        help="CGAL's data set")
    for name, meaning in (("common", "with the Common Shapes, which README.md names"),
                          ("models", "with the meshes that rivals.csv and optcuts.csv in benchmark/results name"),
                          ("graphs", "with the graphs of PACE 2018 and optimum.csv"),
                          ("wild", "with any meshes, for the runs of Robustness")):
        parser.add_argument(f"--{name}", type=pathlib.Path, metavar="FOLDER", help=meaning)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/scoreboard", metavar="FOLDER",
                        help="for intermediate files and charts")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="at a time, where times do not count")
    parser.add_argument("--results", type=pathlib.Path, default=results.FOLDER, metavar="FOLDER")
    arguments = parser.parse_args()
    for name in "programs", "meshes", "models", "graphs", "wild", "common", "output":
        value = getattr(arguments, name)
        setattr(arguments, name, value and value.resolve())
    return arguments


def command(driver, claim):
    return f"benchmark/Surface_mesh_cutting/{driver.capitalize()}/{driver}.py --only {claim.name}" + \
        (f" {claim.needs}" if claim.needs else "")


def measure(driver, claim, arguments, version):
    """Measures one claim and stores it; returns whether that was possible."""
    folder = arguments.output / version / claim.name
    if arguments.again:
        shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    try:
        measured = claim.measure(Bench(arguments, folder))
    except Missing as missing:
        print(f"{claim.name}: not measured, it needs {missing}", flush=True)
        return False
    except (Failed, subprocess.CalledProcessError) as failure:
        print(f"{claim.name}: FAILED, {failure}", flush=True)
        return False
    results.append(driver, {
        "claim": claim.name, "command": command(driver, claim), "values": measured.values, "tables": measured.tables,
        "statement": claim.statement.format(**measured.values), "minutes": claim.minutes, "commit": version,
        "date": datetime.date.today().isoformat(), "seconds": round(time.monotonic() - start, 1),
        "processor": processor()}, arguments.results)
    print(f"{claim.name}: {claim.statement.format(**measured.values)}", flush=True)
    return True


def run(driver, claims):
    arguments = read_arguments(driver, claims)
    version = commit()
    stored = results.latest(arguments.results)
    chosen = [claim for claim in claims if claim.name in (arguments.only or [c.name for c in claims if not c.is_long])]
    if not arguments.again:
        chosen = [claim for claim in chosen if stored.get(claim.name, {}).get("commit") != version]
    if arguments.list:
        chosen = claims
    for claim in chosen:
        print(f"{claim.name}: about {claim.minutes:g} minutes" + (f", needs {claim.needs}" if claim.needs else "")
              + (", only if named" if claim.is_long else ""))
    total = sum(claim.minutes for claim in chosen if not (arguments.list and claim.is_long))
    print(f"in total about {total:g} minutes", flush=True)
    if arguments.list:
        return
    if not all([measure(driver, claim, arguments, version) for claim in chosen]):
        sys.exit(3)
