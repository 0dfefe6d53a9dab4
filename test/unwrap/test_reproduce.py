"""The paper's evaluation on a folder in which some meshes are of no use: every experiment gives its tables,
what is finished is not run again, and what failed is said."""

import csv
import subprocess
import sys
import unittest
from pathlib import Path

from support import Case, PROGRAM, main, octahedron, sphere, to_off, torus, without_face

BIN = Path(PROGRAM).parent
SCRIPT = Path(__file__).parents[2] / "benchmark" / "evaluation" / "reproduce.py"
EXPERIMENTS = ["detectors", "same_energy", "stages", "sweeps", "steiner"]
TABLES = ["figure_10_eps_iso", "figure_11_eps_len", "figure_14_construction", "figure_16_detectors",
          "figure_16_same_energy", "figure_16_statistics", "figure_18_steiner_trees", "table_3_stages"]


def capsule(length):
    """A ball drawn out along one axis, with more to cut than a ball."""
    points, faces = sphere(3)
    return [(x, y, z + length * max(0., z)) for x, y, z in points], faces


PROGRAMS = ["compare_detectors", "connect_random_terminals"]


@unittest.skipUnless(all((BIN / name).exists() for name in PROGRAMS), "the benchmarks are not built")
class Reproduce(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "meshes").mkdir()
        for i in range(4):
            self.write(f"meshes/capsule{i}.off", to_off(capsule(1 + i)))
        self.write("meshes/open.off", to_off(without_face(sphere(2))))
        self.write("meshes/torus.off", to_off(torus()))
        self.write("meshes/twice.off", to_off((octahedron()[0], octahedron()[1] * 2)))
        self.write("meshes/truncated.off", to_off(sphere(2))[:-500])

    def reproduce(self, *options):
        chosen = [word for name in EXPERIMENTS for word in ("--only", name)]
        run = subprocess.run([sys.executable, "-B", SCRIPT, BIN, "meshes", "out",
                              "--smallest", "100", *chosen, *options], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.strip(), (self.folder / "out/summary.md").read_text().strip())
        return run

    def table(self, name):
        with open(self.folder / f"out/{name}.csv", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_all(self):
        run = self.reproduce("--minutes", "0")
        self.assertIn("no mesh is closed", run.stdout)
        run = self.reproduce()
        self.assertNotIn("are left", run.stdout)
        self.assertNotIn("crashed", run.stdout)
        meshes = {row["mesh"]: row for row in self.table("meshes")}
        self.assertEqual(len(meshes), 8)
        self.assertEqual({name for name, row in meshes.items() if row["used"] == "True"},
                         {f"capsule{i}.off" for i in range(4)})
        self.assertEqual({name: meshes[f"{name}.off"]["status"] for name in ("open", "torus", "twice", "truncated")},
                         {"open": "done", "torus": "done", "twice": "done", "truncated": "unreadable"})
        for name in TABLES:
            self.assertTrue(self.table(name), name)
        detectors = {(row["mesh"], row["detector"]): row for row in self.table("figure_16_detectors")}
        self.assertEqual(len(detectors), 8)
        for i in range(4):
            ours = detectors[f"capsule{i}.off", "ours"]
            self.assertEqual(ours["status"], "done")
            self.assertGreater(float(ours["E"]), 4)
            self.assertGreater(float(ours["L"]), 0.5)
        stages = {row["mesh"]: row for row in self.table("table_3_stages")}
        self.assertEqual(len(stages), 6)  # and two means
        for row in stages.values():
            self.assertLessEqual(float(row["L"]), float(row["L_after"]) + 1e-9)

        again = self.reproduce()
        self.assertEqual(again.stderr, "")  # nothing was run
        self.assertEqual(again.stdout, run.stdout)


main()
