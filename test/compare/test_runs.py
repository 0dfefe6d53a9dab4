"""The runs of the comparison, with programs that end in all ways, and its statistics."""

import math
import subprocess
import sys
import unittest
import unittest.mock

from comparison import ROOT, grid
from support import Case, PROGRAM, joined, main, scaled, sphere, to_obj, to_off

import numpy as np
import paired_statistics
import tables
from run_programs import find_meshes, read_programs, read_records, run_all
from surface_files import read_surface, write_surface

COPY = "import sys; open(sys.argv[2], 'w').write(open(sys.argv[1]).read().replace(*sys.argv[3:]))"


class Runs(Case):
    def test_outcomes(self):
        self.write("mesh.obj", to_obj(sphere(1)))
        self.write("programs.txt", f"""# a comment
default: {PROGRAM} {{input}} -o {{output}} --quiet
after: {PROGRAM} {{default}} -o {{output}} --quiet --pack-only
bounded: {PROGRAM} {{input}} -o {{output}} --quiet --max-face-distortion {{default.E_max}}
unmeasured: {PROGRAM} {{input}} -o {{output}} --quiet --max-distortion {{default.E_least}}
late: {sys.executable} -c "while True: pass"
idle: {sys.executable} -c "import time; time.sleep(300)"
fails: {sys.executable} -c "import sys; sys.exit('no memory')"
silent: {sys.executable} -c "print('seconds 0.5')" {{output}}
without_uv: {sys.executable} -c "{COPY}" {{input}} {{output}} v v
other_faces: {sys.executable} -c "{COPY}" {{default}} {{output}} "f 1" "f 2"
missing: no_such_program {{input}} {{output}}
needs: {PROGRAM} {{fails}} -o {{output}}
""")
        programs = read_programs(self.folder / "programs.txt")
        self.enterContext(unittest.mock.patch("run_programs.IDLE", 5))
        found = run_all(programs, find_meshes([self.folder / "mesh.obj"]), self.folder / "out", 2, lambda _: None)["mesh.obj"]
        outcomes = {name: record["outcome"] for name, record in found.items()}
        self.assertEqual(outcomes, dict.fromkeys(("default", "after", "bounded"), "done") | dict.fromkeys(
            ("late", "idle"), "time is up") | dict.fromkeys(
                ("unmeasured", "fails", "silent", "without_uv", "other_faces", "missing", "needs"), "failed"))
        self.assertIn("no memory", found["fails"]["message"])
        self.assertIn("no result of fails", found["needs"]["message"])
        self.assertEqual(found["silent"]["seconds"], 0.5)
        self.assertAlmostEqual(found["default"]["E_mean"], found["after"]["E_mean"], places=6)
        self.assertLessEqual(found["bounded"]["E_max"], found["default"]["E_max"] + 1e-6)
        self.assertGreater(found["default"]["memory_mb"], 1)
        # Former runs are not repeated.
        again = run_all(programs, find_meshes([self.folder]), self.folder / "out", 2, self.fail)
        self.assertEqual(again, {"mesh.obj": found})
        # A line that was left unfinished is none.
        records = self.folder / "out" / "records.jsonl"
        records.write_text(records.read_text()[:-20])
        self.assertEqual(len(read_records(records)), len(programs) - 1)

    def test_command(self):
        for number in range(2):
            self.write(f"{number}.off", to_off(joined(sphere(2), scaled(sphere(1), 2 + number))))
        self.write("broken.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n")
        line = f"{PROGRAM} {{input}} -o {{output}}"
        self.write("programs.txt", f"default: {line}\nother: {line} --effort fast\n"
                                   f"bounded: {line} --max-distortion {{other.E_chart}}\n")
        command = [sys.executable, "-B", ROOT / "benchmark" / "compare" / "compare.py", self.folder, "--programs",
                   self.folder / "programs.txt", "--output", self.folder / "out"]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""), run.stderr)
        self.assertIn("not read: broken.off", run.stdout)
        self.assertIn("| default | 2 | 0 | 2 / 2 |", (self.folder / "out" / "comparison.md").read_text())
        self.assertIn("## other minus bounded", (self.folder / "out" / "comparison.md").read_text())
        page = (self.folder / "out" / "comparison.html").read_text()
        self.assertGreater(page.count("<circle"), 4 * 10)
        self.assertNotIn("http", page)

    def test_surface(self):
        """Equal points are one, faces that repeat a vertex or a face are left out, and so are points without faces."""
        points, faces = grid(1, 1)
        soup = points[faces].reshape(-1, 3).tolist()
        mesh = [tuple(p) for p in [(9, 9, 9), *soup]], [(1, 2, 3), (4, 5, 6), (5, 6, 4), (1, 1, 2), (1, 2, 3)]
        self.write("a.obj", to_obj(mesh))
        found_points, found_faces = read_surface(self.folder / "a.obj")
        self.assertEqual(found_points.tolist(), [soup[i] for i in (0, 1, 2, 5)])
        self.assertEqual(found_faces.tolist(), [[0, 1, 2], [0, 2, 3]])
        write_surface(self.folder / "b.obj", found_points, found_faces)
        self.assertEqual(read_surface(self.folder / "b.obj")[1].tolist(), found_faces.tolist())


class Statistics(unittest.TestCase):
    def test_paired(self):
        found = paired_statistics.compare([1, 1, 1, 1, 1, 2], [2, 3, 4, 5, 6, 1])
        self.assertEqual((found.meshes, found.better, found.equal, found.median), (6, 5, 0, 2.5))
        # Differences 1, 2, 3, 4, 5, -1: ranks 1.5 of 21 against the rest.
        self.assertLess(found.p, 0.1)
        self.assertLessEqual(found.low, 2.5)
        self.assertGreaterEqual(found.high, 2.5)
        exact = paired_statistics.compare([0] * 6, [1, 2, 3, 4, 5, 6])
        self.assertAlmostEqual(exact.p, 2 / 2 ** 6)

    def test_failures(self):
        """Are worse than all, whose ever they are, and equal to each other."""
        found = paired_statistics.compare([1, 1, None, None], [None, 2, 1, None])
        self.assertEqual((found.better, found.equal, found.meshes), (2, 1, 4))
        found = paired_statistics.compare([1] * 6, [2, 3, 4, None, None, None])
        self.assertAlmostEqual(found.p, 2 / 2 ** 6, delta=0.01)
        self.assertEqual((found.high, tables.text(found.high, 1)), (math.inf, "\u221e"))
        self.assertEqual(paired_statistics.summary([1, None, 3]), (2, 2, 1))

    def test_interval(self):
        """The interval covers the median, and is that of the same seed."""
        values = np.random.default_rng(3).normal(5, 1, 100)
        low, high = paired_statistics.interval(values)
        self.assertEqual((low, high), paired_statistics.interval(values))
        self.assertTrue(4.5 < low < np.median(values) < high < 5.5, (low, high))

    def test_counts(self):
        def row(charts, seam, outcome="done"):
            return {"outcome": outcome, "message": "", "charts": charts, "seam": seam, "uv_seam": seam, "E_mean": 4, "overlaps": 0,
                    "flipped": 0}
        records = {"a": {"ours": row(1, 2), "theirs": row(2, 1)}, "b": {"ours": row(2, 2), "theirs": row(2, 2)},
                   "c": {"ours": row(3, 3), "theirs": row(1, 1, "failed")}, "d": {"ours": row(0, 0, "failed"), "theirs": row(1, 1)}}
        found = tables.counts(records, "ours", ["theirs"])
        self.assertEqual([found[key] for key in ("meshes", "best_charts", "best_seam", "unfinished")], [4, 3, 2, 1])
        self.assertEqual([cells[0] for cells in tables.exceptions(records, "ours", ["theirs"])[1:]], ["a", "d"])

    def test_counts_at_bounds(self):
        def row(outcome, seam, largest):
            return {"outcome": outcome, "seam": seam, "E_max": largest}
        theirs, flat = row("done", 5, 8), row("done", 0, 4)
        records = {"kept": {"ours": row("done", 4, 8), "theirs": theirs}, "missed": {"ours": row("done", 4, 9), "theirs": theirs},
                   "longer": {"ours": row("done", 6, 7), "theirs": theirs}, "failed": {"ours": {"outcome": "failed"}, "theirs": theirs},
                   "uncut": {"ours": row("done", 0, 4), "theirs": flat}, "unknown": {"ours": theirs, "theirs": {"outcome": "failed"}}}
        found = tables.counts_at_bounds(records, [("ours", "theirs", "E_max")])
        self.assertEqual(found, {"ours_meshes": 4, "ours_kept": 2, "ours_shorter": 2})

    def test_equal(self):
        self.assertEqual(paired_statistics.compare([1, 2], [1, 2]).p, 1)


if __name__ == "__main__":
    main()
