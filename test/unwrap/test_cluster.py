"""Campaigns: whatever runs them, and whatever is killed meanwhile, each mesh has one record and all have
the same results. The parts that need GNU parallel, an ssh server or Slurm are skipped where these are missing."""

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from support import PROGRAM, main, octahedron, sphere, to_off, torus, without_face

FOLDER = Path(__file__).parents[2] / "benchmark" / "Surface_mesh_cutting" / "Robustness" / "campaign"
NUMBER_OF_MESHES = 24


def missing(*programs):
    return [name for name in programs if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")]


def needs(*programs):
    return unittest.skipIf(missing(*programs), f"not installed: {', '.join(missing(*programs))}")


class Cluster(unittest.TestCase):
    """All tests share the folder, the meshes and the results they are compared with."""

    @classmethod
    def setUpClass(cls):
        cls.common = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.common.cleanup)
        cls.folder = Path(cls.common.name)
        (cls.folder / "sources").mkdir()
        for name, mesh in ("ball", sphere(2)), ("open ball", without_face(sphere(2))), ("torus", torus()):
            (cls.folder / "sources" / f"{name}.off").write_text(to_off(mesh))
        self = cls()
        self.call("make_variants.py", "meshes", NUMBER_OF_MESHES - 2, "sources")
        (cls.folder / "meshes" / "twice.off").write_text(to_off((octahedron()[0], octahedron()[1] * 2)))
        (cls.folder / "meshes" / "nothing.off").touch()
        cls.reference = self.create("reference", 1)
        self.call("campaign.py", "work", cls.reference, 0)

    def call(self, script, *arguments, environment=None, expected=0):
        command = [FOLDER / script, *map(str, arguments)]
        if script.endswith(".py"):
            command = [sys.executable, "-B", *command]
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False,
                             env={**os.environ, **(environment or {})}, timeout=300)
        self.assertEqual(run.returncode, expected, run.stdout + run.stderr)
        return run.stdout

    def create(self, name, shards, program=PROGRAM):
        self.call("campaign.py", "create", name, program, "meshes", "--shards", shards)
        return self.folder / name

    def assert_complete(self, campaign):
        self.call("compare_campaigns.py", self.reference, campaign)
        self.assertEqual(self.call("campaign.py", "status", campaign), "")

    def test_variants(self):
        self.call("make_variants.py", "again", NUMBER_OF_MESHES - 2, "sources")
        for mesh in (self.folder / "again").iterdir():
            self.assertEqual(mesh.read_bytes(), (self.folder / "meshes" / mesh.name).read_bytes())
        self.assertEqual(len(set(mesh.read_bytes() for mesh in (self.folder / "again").iterdir())),
                         NUMBER_OF_MESHES - 2)

    def test_differences_are_found(self):
        campaign = self.create("other", 2)
        self.call("campaign.py", "work", campaign, 0)
        self.assertIn("shard 1: 12 of 12 meshes missing", self.call("campaign.py", "status", campaign, expected=1))
        self.call("compare_campaigns.py", campaign, expected=1)
        self.call("campaign.py", "work", campaign, 1)
        self.assert_complete(campaign)
        results = campaign / "results" / "1.jsonl"
        lines = results.read_text().splitlines(keepends=True)
        results.write_text("".join(lines + lines[:1]))
        self.assertIn("2 records of", self.call("compare_campaigns.py", campaign, expected=1))
        results.write_text("".join(lines).replace('"outcome": "certified"', '"outcome": "crash"', 1))
        self.assertIn("another result", self.call("compare_campaigns.py", self.reference, campaign, expected=1))

    def test_killed_worker(self):
        # The program waits as long as this file is there.
        hold = self.folder / "hold"
        hold.touch()
        slow = self.folder / "slow"
        slow.write_text(f"#!/bin/sh\nwhile [ -e {hold} ]; do sleep 0.1; done\nexec {shlex.quote(PROGRAM)} \"$@\"\n")
        slow.chmod(0o755)
        campaign = self.create("killed", 1, slow)
        results = campaign / "results" / "0.jsonl"
        reference = (self.reference / "results" / "0.jsonl").read_text().splitlines(keepends=True)
        results.write_text("".join(reference[:3]) + reference[3][:50])  # the worker before died while writing
        worker = subprocess.Popen([sys.executable, "-B", FOLDER / "campaign.py", "work", campaign, "0"],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while results.read_text() != "".join(reference[:3]):
            time.sleep(0.05)
        self.call("campaign.py", "work", campaign, 0, expected=1)  # it is being worked on
        worker.send_signal(signal.SIGKILL)
        worker.wait()
        hold.unlink()
        self.call("campaign.py", "work", campaign, 0)
        self.assert_complete(campaign)

    def test_page(self):
        self.call("summary_page.py", self.reference)
        page = (self.reference / "index.html").read_text()
        self.assertNotRegex(page, r"@\w+@|https?://(?!www\.w3\.org)")
        self.assertEqual(page.count("<tr"), 1 + NUMBER_OF_MESHES)
        records = [json.loads(line) for line in (self.reference / "results" / "0.jsonl").read_text().splitlines()]
        proven = [record for record in records if record["outcome"] == "certified"]
        self.assertEqual(page.count("<img"), len(proven))
        self.assertEqual(len(list((self.reference / "pictures").iterdir())), len(proven))
        self.assertIn(f"{PROGRAM} {self.folder}/meshes/nothing.off --threads 1", page)

    @needs("parallel")
    def test_parallel(self):
        campaign = self.create("parallel", 5)
        self.call("run_with_parallel.sh", campaign, 2)
        self.assert_complete(campaign)

    @needs("parallel", "ssh", "sshd", "ssh-keygen")
    def test_hosts(self):
        options = shlex.split(self.call("local_sshd.sh", "start", "sshd"))
        self.addCleanup(self.call, "local_sshd.sh", "stop", "sshd")
        campaign = self.create("hosts", 4)
        self.call("run_with_parallel.sh", campaign, 2, *options)
        self.assert_complete(campaign)
        self.assertIn("Accepted publickey", (self.folder / "sshd" / "sshd.log").read_text())

    @needs("slurmctld", "slurmd", "munged", "sbatch")
    @unittest.skipUnless(os.geteuid() == 0, "Slurm is started by root")
    def test_slurm(self):
        settings = dict(line.split("=", 1) for line in self.call("local_slurm.sh", "start", "slurm").split())
        self.addCleanup(self.call, "local_slurm.sh", "stop", "slurm")
        campaign = self.create("slurm_campaign", 4)
        self.assertIn("Submitted batch job", self.call("run_with_slurm.sh", campaign, environment=settings))
        self.assert_complete(campaign)


main()
