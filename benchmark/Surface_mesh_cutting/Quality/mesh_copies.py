"""How much results depend on what should not matter: copies of meshes that are turned, in other units, or numbered anew."""

import sys

from bench import ROOT, Measured
from meshes import CLOSED

sys.path.insert(0, str(ROOT / "scripts"))

from invariance import KINDS, differences, summary, write_copies  # noqa: E402

MESHES = CLOSED[:15]
ROTATIONS = 10


def measure_invariance(bench):
    copies = [write_copies(mesh, bench.folder, ROTATIONS) for mesh in bench.meshes(MESHES)]
    values = {"surfaces": len(copies), "rotations": ROTATIONS}
    table = [["Copies", "bound", "length, mean", "length, largest", "energy, mean", "energy, largest", "sum, mean", "sum, largest"]]
    for bound in "4.1", "":
        reports = bench.reports([copy.path for group in copies for copy in group],
                                *(["--max-distortion", bound] if bound else []), jobs=bench.options.jobs)
        rows = {kind: [] for kind in KINDS}
        for i, group in enumerate(copies):
            found = [(r["cut_length"], r["E_iso"]) for r in reports[i * len(group):(i + 1) * len(group)]]
            for kind, more in differences(group, found).items():
                rows[kind] += more
        for kind in KINDS:
            length, energy, total = summary(rows[kind])
            name = f"{kind}_{bound.replace('.', '_') or 'free'}"
            values |= {f"{name}_mean": 100 * length[0], f"{name}_largest": 100 * length[1], f"{name}_sum": total[1]}
            table.append([kind, bound or "none", *(f"{100 * x:.2f} %" for x in length), *(f"{x:.4f}" for x in (*energy, *total))])
    return Measured(values, {"copies": table})
