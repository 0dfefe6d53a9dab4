"""The checker of claims finds each number that differs from the stored results, and writes the stored ones; the drivers store
what they measure, once for each commit."""

import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CHECKER = ROOT / "scripts" / "check_claims.py"
sys.path.insert(0, str(ROOT / "benchmark" / "scoreboard"))

import marks  # noqa: E402
import results  # noqa: E402

RECORDS = {"speed": {"claim": "speed", "command": "run --only speed", "minutes": 2, "date": "2026-01-01", "commit": "abc",
                     "statement": "It takes 1.2 s", "values": {"seconds": 1.2345, "sets": 2310, "change": 3.0},
                     "tables": {"meshes": [["Mesh", "s", "MB"], ["cow", "0.1", "7"]]}}}


class Marks(unittest.TestCase):
    def test_numbers(self):
        text = "a <!--=speed.seconds-->9.99 b <!--=speed.sets-->1 c <!--=speed.change-->+0.0 %"
        expected = "a <!--=speed.seconds-->1.23 b <!--=speed.sets-->2,310 c <!--=speed.change-->+3.0 %"
        self.assertEqual(marks.updated(text, RECORDS), expected)
        self.assertEqual(marks.updated(expected, RECORDS), expected)

    def test_tables(self):
        text = "<!--table speed.meshes Mesh,MB-->\n\nold\n\n<!--/table-->\n"
        stored = marks.updated(text, RECORDS)
        self.assertIn("| cow | 7 |\n\n<!--/table-->", stored)
        self.assertEqual(marks.updated(stored, RECORDS), stored)
        self.assertIn("It takes 1.2 s", marks.updated("<!--table claims-->\n\n<!--/table-->", RECORDS))

    def test_what_is_wrong(self):
        for text in ("<!--=speed.minutes-->1", "<!--=spee.seconds-->1", "<!--=speed.seconds-->",
                     "<!--table speed.models-->\n\n<!--/table-->", "<!--table speed.meshes Model-->\n\n<!--/table-->"):
            with self.assertRaises(marks.Unknown, msg=text):
                marks.updated(text, RECORDS)

    def test_unmarked(self):
        text = "first\nit takes 1.2 s, <!--=speed.seconds-->1.2 s and 5 % of `3 s`\n    run 4 s\n7 MB\n"
        self.assertEqual(marks.unmarked(text), [(2, "1.2 s"), (2, "5 %"), (4, "7 MB")])


class Checker(unittest.TestCase):
    """On a copy of the texts and results of the project."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copy(ROOT / "README.md", self.root)
        for name in "benchmark/README.md", "benchmark/scoreboard/not_measured.txt":
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)
        shutil.copytree(ROOT / "benchmark" / "results", self.root / "benchmark" / "results")
        for text in (ROOT / "doc").rglob("*.txt"):
            (self.root / text.relative_to(ROOT)).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(text, self.root / text.relative_to(ROOT))

    def check(self, *options):
        return subprocess.run([sys.executable, "-B", CHECKER, "--root", self.root, *options], capture_output=True, text=True,
                              check=False)

    def test_altered_number(self):
        for name in "README.md", "doc/Surface_mesh_cutting/Surface_mesh_cutting.txt":
            text = (self.root / name).read_text()
            mark = marks.NUMBER.search(text)
            altered = re.sub(r"\d", lambda digit: str((int(digit[0]) + 1) % 10), mark[3])
            (self.root / name).write_text(text[:mark.start(3)] + altered + text[mark.end(3):])
            run = self.check()
            self.assertEqual(run.returncode, 1)
            self.assertIn(f"-{(self.root / name).read_text().splitlines()[text[:mark.start()].count(chr(10))]}", run.stdout)
            self.assertEqual(self.check("--update").returncode, 0)
            self.assertEqual((self.root / name).read_text(), text)

    def test_altered_result(self):
        records = results.latest(self.root / "benchmark" / "results")
        text = (self.root / "README.md").read_text()
        claim, value, _ = marks.NUMBER.search(text).groups()
        record = records[claim]
        record["values"][value] = 2 * record["values"][value] + 1
        results.append("zz_later", record, self.root / "benchmark" / "results")
        self.assertEqual(self.check().returncode, 1)
        self.assertEqual(self.check("--update").returncode, 0)
        self.assertNotEqual((self.root / "README.md").read_text(), text)

    def test_unmarked_number(self):
        with (self.root / "README.md").open("a") as text:
            text.write("\nIt only takes 3 s.\n")
        run = self.check()
        self.assertEqual((run.returncode, "3 s is not marked" in run.stdout), (1, True))


class Driver(unittest.TestCase):
    def test_stores_once(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            script = folder / "driver_of_test.py"
            script.write_text(f"""import sys
sys.path.insert(0, {str(ROOT / "benchmark" / "scoreboard")!r})
import bench, driver
def measure(bench_):
    bench_.given("models")
    return bench.Measured({{"seconds": 1.5}})
driver.run("performance", [driver.Claim("speed", 2, "It takes {{seconds:.1f}} s", measure, needs="--models FOLDER"),
                           driver.Claim("rare", 9, "rare", measure, is_long=True)])
""")

            def run(*options):
                return subprocess.run([sys.executable, "-B", script, "--results", folder, "--output", folder / "out",
                                       *options], capture_output=True, text=True, check=False)
            missing = run()
            self.assertEqual((missing.returncode, "needs --models FOLDER" in missing.stdout), (3, True))
            for repetition in range(2):
                self.assertEqual(run("--models", folder).returncode, 0)
            lines = (folder / "performance.json").read_text().splitlines()
            self.assertEqual(len(lines), 1)
            self.assertEqual(json.loads(lines[0])["statement"], "It takes 1.5 s")
            self.assertEqual(run("--models", folder, "--again").returncode, 0)
            self.assertEqual(len((folder / "performance.json").read_text().splitlines()), 2)
            self.assertEqual(run("--list").stdout.count("about"), 3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
