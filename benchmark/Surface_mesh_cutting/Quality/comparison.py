"""This program and others side by side, by scripts/compare.sh."""

import json
import subprocess

from bench import ROOT, Failed, Measured


def measure_comparison(bench):
    command = [ROOT / "scripts/compare.sh", bench.given("common"), "--output", bench.folder]
    if subprocess.run(command, check=False).returncode != 0:
        raise Failed("scripts/compare.sh")
    found = json.loads((bench.folder / "comparison.json").read_text(encoding="utf-8"))
    return Measured(found.pop("values"), found)
