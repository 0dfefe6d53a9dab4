"""The runner of corpora: every way to end has its class, and what is finished is not run again."""

import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from support import Case, PROGRAM, main, octahedron, sphere, to_glb, to_obj, to_off, torus

FOLDER = Path(__file__).parents[2] / "benchmark" / "Surface_mesh_cutting" / "Robustness" / "corpus"
NOWHERE = ([("nan", 0, 0), *octahedron()[0][1:]], octahedron()[1])
# Programs that end as unwrap must not.
CULPRITS = {"hang": "sleep 60", "crash": "kill -SEGV $$", "uncertified": """echo '{"flips": 1}'"""}


class Corpus(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "meshes").mkdir()
        self.write("meshes/a mesh.off", to_off(sphere(1)))
        self.write("meshes/torus.obj", to_obj(torus()))
        self.write("meshes/sphere.glb", to_glb(*sphere(1)))
        self.write("meshes/nowhere.off", to_off(NOWHERE))
        self.write("meshes/no_mesh.csv", "1,2")

    def run_script(self, name, *arguments):
        run = subprocess.run([sys.executable, "-B", FOLDER / name, *map(str, arguments)], cwd=self.folder,
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def run_mesh(self, program, mesh, *options):
        return json.loads(self.run_script("run_mesh.py", "--time-limit", 1, program, mesh, "--", *options))

    def records(self):
        return [json.loads(line) for line in (self.folder / "results").read_text().splitlines()]

    def test_one_mesh(self):
        record = self.run_mesh(PROGRAM, "meshes/torus.obj", "--seed", "1")
        self.assertEqual((record["outcome"], record["exit_code"]), ("certified", 0))
        self.assertEqual((record["report"]["genus"], record["report"]["seed"]), (1, 1))
        record = self.run_mesh(PROGRAM, "meshes/nowhere.off")
        self.assertEqual((record["outcome"], record["digest"]), ("refused", None))
        self.assertEqual(self.run_mesh(PROGRAM, "missing.off")["outcome"], "refused")
        self.assertEqual(self.run_mesh(PROGRAM, "meshes/nowhere.off", "--no-such-option")["outcome"], "usage")

    def test_culprits(self):
        for outcome, script in CULPRITS.items():
            program = self.folder / self.write(outcome, f"#!/bin/sh\n{script}\n")
            program.chmod(0o755)
            self.assertEqual(self.run_mesh(program, "meshes/torus.obj")["outcome"], outcome)

    def test_keep_and_judge(self):
        judge = self.folder / self.write("judge", '#!/bin/sh\necho "{\\"lines\\": $(wc -l < "$2")}"\n')
        judge.chmod(0o755)
        record = json.loads(self.run_script("run_mesh.py", "--keep", "kept/a.obj", "--judge", judge, PROGRAM,
                                            "meshes/a mesh.off"))
        lines = len((self.folder / "kept/a.obj").read_text().splitlines())
        self.assertEqual(record["judgement"], {"exit_code": 0, "is_timed_out": False, "output": {"lines": lines}})

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_corpus(self):
        run = lambda *options: self.run_script("run_corpus.py", PROGRAM, "results", *options)
        self.write("list.txt", "# some\nmeshes/torus.obj\n")
        run("list.txt")
        self.assertEqual([record["mesh"] for record in self.records()], ["meshes/torus.obj"])
        with (self.folder / "results").open("a") as results:
            results.write('{"mesh": "meshes/now')  # as a killed run may leave it
        table = run("meshes", "--jobs", 2)
        lines = (self.folder / "results").read_text().splitlines()
        self.assertEqual(len(lines), 5)
        self.assertEqual(run("meshes"), table)
        self.assertEqual((self.folder / "results").read_text().splitlines(), lines)
        self.assertIn("refused: meshes/nowhere.off", table)
        self.assertEqual(table.splitlines()[1].split()[:4], ["(none)", "4", "3", "1"])
        table = run("meshes", "--options", "--effort fast")
        self.assertEqual(len(table.splitlines()), 5)  # heading, two sets of options, two refusals

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_parts(self):
        """As two tasks of Slurm, and through what would be ssh to other machines."""
        self.run_script("run_corpus.py", PROGRAM, "results", "meshes", "--sshlogin", "1/:,:")
        for part in range(2):
            subprocess.run([FOLDER / "run_corpus.sbatch", FOLDER / "run_corpus.py", PROGRAM, "parts", "meshes"],
                           cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True,
                           env={**os.environ, "SLURM_ARRAY_TASK_ID": str(part), "SLURM_ARRAY_TASK_COUNT": "2"})
        parts = [[json.loads(line) for line in (self.folder / f"parts/{part}.jsonl").read_text().splitlines()]
                 for part in range(2)]
        self.assertEqual([len(records) for records in parts], [2, 2])
        results = lambda records: sorted((record["mesh"], record["outcome"], record["digest"] or "") for record in records)
        self.assertEqual(results(parts[0] + parts[1]), results(self.records()))

    def test_variants(self):
        for folder in "once", "again":
            self.run_script("make_variants.py", folder, 6, "meshes/a mesh.off", "--kinds", "plain,soup,polygons")
        once, again = ([path.read_bytes() for path in sorted((self.folder / name).iterdir())] for name in ("once", "again"))
        self.assertEqual(once, again)
        self.assertEqual(len(set(once)), 6)


main()
