#!/usr/bin/env python3
"""Compares the numbers in README.md, the manual and benchmark/README.md with the stored results of the benchmarks, in
benchmark/results, and fails on a difference; also where a number with a unit is not marked as a result.

  check_claims.py [--update] [--root FOLDER]

With --update, the stored numbers are written into the texts. benchmark/scoreboard/marks.py explains the marks."""

import argparse
import difflib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "benchmark" / "scoreboard"))

import marks  # noqa: E402
import results  # noqa: E402


def texts(root):
    return [root / "README.md", root / "benchmark" / "README.md", *sorted((root / "doc").rglob("*.txt"))]


def check(file, root, records, not_measured, is_update):
    """Lines that say what is wrong."""
    name, text = file.relative_to(root).as_posix(), file.read_text(encoding="utf-8")
    try:
        stored = marks.updated(text, records)
    except marks.Unknown as error:
        return [f"{name}: {error}"]
    if is_update:
        file.write_text(stored, encoding="utf-8")
        text = stored
    lines = difflib.unified_diff(text.splitlines(), stored.splitlines(), name, "stored results", lineterm="", n=0)
    allowed = [line for line in not_measured if line[0] == name]
    source = text.splitlines()
    return [*lines, *(f"{name}:{number}: {measure} is not marked as a result" for number, measure in marks.unmarked(text)
                      if not any(phrase in source[number - 1] for _, phrase in allowed))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="of the project")
    arguments = parser.parse_args()
    records = results.latest(arguments.root / "benchmark" / "results")
    lines = (arguments.root / "benchmark" / "scoreboard" / "not_measured.txt").read_text(encoding="utf-8").splitlines()
    not_measured = [tuple(line.split(": ", 1)) for line in lines if line and not line.startswith("#")]
    problems = [problem for file in texts(arguments.root)
                for problem in check(file, arguments.root, records, not_measured, arguments.update)]
    for problem in problems:
        print(problem)
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()
