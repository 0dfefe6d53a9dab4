"""This program and others side by side, by scripts/compare.sh."""

import json
import subprocess

from bench import ROOT, Failed, Measured


def compare(bench, *options):
    command = [ROOT / "scripts/compare.sh", bench.given("common"), "--output", bench.folder, *options]
    if subprocess.run(command, check=False).returncode != 0:
        raise Failed("scripts/compare.sh")


def stored(path):
    found = json.loads(path.read_text(encoding="utf-8"))
    return Measured(found.pop("values"), found)


def measure_comparison(bench):
    compare(bench)
    return stored(bench.folder / "comparison.json")


def measure_pages(bench):
    """For the charts that xatlas makes."""
    compare(bench, "--ours", "fast", "--only", "xatlas")
    layouts = sorted((bench.folder / "xatlas").glob("*.obj"))
    command = ["/usr/bin/python3", "-B", ROOT / "benchmark/compare/pages.py", *layouts, "--output", bench.folder]
    if subprocess.run(command, check=False).returncode != 0:
        raise Failed("benchmark/compare/pages.py")
    return stored(bench.folder / "pages.json")
