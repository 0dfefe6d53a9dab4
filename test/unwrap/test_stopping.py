"""The time limit and signals: the run ends soon wherever it is, and leaves a whole result or nothing."""

import fcntl
import json
import math
import os
import signal
import subprocess
import time

from support import (Case, PROGRAM, TIME_LIMIT, joined, main, scaled, sphere, to_glb, to_obj, to_off, torus,
                     without_face)

# Seconds from the limit or the signal to the end.
SLACK = float(os.environ.get("UNWRAP_TEST_SLACK", "1"))
SPHERE = sphere(1)
LARGE = to_off(sphere(7))  # 131,072 triangles
MANY = 60000
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Stopping(Case):
    def start(self, *arguments, **keywords):
        program = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   **{"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, **keywords})
        self.addCleanup(lambda: (program.kill(), program.communicate()))
        return program

    def assert_ends(self, program, *codes):
        start = time.monotonic()
        _, message = program.communicate(timeout=TIME_LIMIT)
        self.assertLess(time.monotonic() - start, SLACK)
        self.assertIn(program.returncode, codes, message)

    def wait_for_content(self, name, former):
        """Until a file has another one. A busy machine may take a while to get there."""
        deadline = time.monotonic() + TIME_LIMIT
        while (self.folder / name).read_text() == former:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def test_while_weighing(self):
        """Rays to everywhere: the longest computation ahead of the library's run."""
        self.write("large.off", LARGE)
        arguments = ["large.off", "--edge-weights", "visibility", "--effort", "fast", "--json", "r.json"]
        start = time.monotonic()
        run = self.unwrap(*arguments, "--time-limit", "0.8")
        self.assertLess(time.monotonic() - start, 0.8 + SLACK)
        self.assertEqual(run.returncode, 6, run.stderr)
        self.assertEqual(self.files(), ["large.off", "r.json"])
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["status"], "stopped")
        for number in SIGNALS:
            with self.subTest(signal=number):
                program = self.start(*arguments)
                time.sleep(0.8)
                program.send_signal(number)
                self.assert_ends(program, 6)

    def test_while_a_library_handles_the_signal(self):
        """METIS catches SIGTERM for itself while it orders a large system."""
        self.write("large.off", LARGE)
        for tenths in range(2, 9):
            with self.subTest(moment=tenths / 10):
                program = self.start("large.off", "--faithful", "--json", "r.json")
                time.sleep(tenths / 10)
                program.send_signal(signal.SIGTERM)
                self.assert_ends(program, 6)

    def test_the_clock_starts_with_the_program(self):
        """What reading takes counts."""
        self.write("large.off", LARGE)
        start = time.monotonic()
        exit_code, report = self.report("large.off", "--time-limit", "0.05")
        self.assertLess(time.monotonic() - start, 0.05 + SLACK)
        self.assertEqual((exit_code, report["message"]), (6, "stopped by the time limit"))
        self.assertIsNone(report["components"])

    def test_soonest(self):
        """There is a layout from the start of the search on."""
        hole = without_face(sphere(4))
        parts = joined(joined(torus(20), scaled(sphere(4), 3)), scaled(hole, 0.5))
        for mesh in (sphere(4), torus(40), hole, parts):
            self.write("mesh.off", to_off(mesh))
            for options in (["--max-distortion", "4.00001"], ["--effort", "best", "--allow-overlap"]):
                with self.subTest(faces=len(mesh[1]), options=options):
                    program = self.start("mesh.off", *options, "-o", "out.obj", "--json", "r.json", "--progress")
                    program.stderr.readline()
                    program.send_signal(signal.SIGINT)
                    self.assert_ends(program, 6)
                    report = json.loads((self.folder / "r.json").read_text())
                    self.assertRegex(report["message"], "^stopped by a signal.*; the best result so far is written: ")
                    self.assertEqual((report["flips"], report["overlaps"] or 0), (0, 0))
                    self.assert_no_flips("out.obj")

    def test_gltf(self):
        """The file is edited after the stop."""
        self.write("in.glb", to_glb(*sphere(4)))
        for options in ([], ["--tangents"]):
            with self.subTest(options=options):
                program = self.start("in.glb", "--max-distortion", "4.00001", *options, "-o", "out.glb", "--progress")
                program.stderr.readline()
                program.send_signal(signal.SIGINT)
                self.assert_ends(program, 6)
                self.assertIn(b"TEXCOORD_0", (self.folder / "out.glb").read_bytes())
                (self.folder / "out.glb").unlink()

    def test_without_layout(self):
        """In the program's words, with what helps."""
        self.write("large.off", LARGE)
        exit_code, report = self.report("large.off", "--time-limit", "0.8")
        self.assertEqual(exit_code, 6)
        self.assertIn(report["message"], ("stopped by the time limit",
                                          "stopped by the time limit before there was a layout; --effort fast takes least time"))

    def test_many_neighbors(self):
        """Time that is quadratic in the number of neighbors would be minutes."""
        rim = [(math.cos(2 * math.pi * i / MANY), math.sin(2 * math.pi * i / MANY), 0.1 * math.sin(50 * math.pi * i / MANY))
               for i in range(MANY)]
        faces = [(2 + i, 2 + (i + 1) % MANY, 0) for i in range(MANY)]
        cones = ([(0, 0, 1), (0, 0, -1), *rim], faces + [(b, a, 1) for a, b, _ in faces])
        self.write("cones.off", to_off(cones))
        start = time.monotonic()
        exit_code, _ = self.report("cones.off", "--time-limit", "3")
        self.assertLess(time.monotonic() - start, 3 + 3 * SLACK)
        self.assertIn(exit_code, (0, 6))

    def test_while_triangulating(self):
        """A single face: a comb, whose long teeth cross what connects their ends, and a ring as a polygon with a bridge.
        A run that is stopped makes do with a rough layout of less than 50,000 triangles, which takes a second or two."""
        teeth = 30000
        comb = [(2 * i + k, k * teeth, 0) for i in range(teeth) for k in range(2)] + [(2 * teeth, -1, 0), (0, -1, 0)]
        side = 100000
        circles = [(r * math.cos(i), r * math.sin(i), 0) for r in (2, 1) for i in (2 * math.pi * k / side for k in range(side))]
        ring = [*range(side), 0, side, *range(2 * side - 1, side, -1), side]
        for mesh in (comb, [tuple(range(len(comb)))]), (circles, [tuple(ring)]):
            self.write("face.obj", to_obj(mesh))
            start = time.monotonic()
            run = self.unwrap("face.obj", "-o", "out.obj", "--time-limit", "1")
            self.assertLess(time.monotonic() - start, 1 + SLACK)
            self.assertEqual(run.returncode, 6, run.stderr)
            program = self.start("face.obj", "-o", "out.obj")
            time.sleep(1)
            program.send_signal(signal.SIGINT)
            self.assert_ends(program, 6)

    def test_progress(self):
        """One estimate of the whole run, which never decreases."""
        self.write("mesh.off", to_off(joined(torus(12), scaled(sphere(3), 3))))
        for options in (["--effort", "best"], ["--max-distortion", "4.1"], ["--uv-scale", "surface"]):
            with self.subTest(options=options):
                run = self.unwrap("mesh.off", *options, "--progress", "--quiet")
                self.assertEqual(run.returncode, 0, run.stderr)
                percents = [int(line.split()[0]) for line in run.stderr.decode().splitlines() if line[:1].isdigit()]
                self.assertEqual(percents, sorted(percents))
                self.assertEqual(percents[-1], 100)
                self.assertGreater(len(percents), 5)

    def test_while_reading_constraints(self):
        self.write("small.off", to_off(SPHERE))
        self.write("weights.txt", "0 8 1\n" * 3000000)
        exit_code, report = self.report("small.off", "--edge-weights", "weights.txt", "--time-limit", "0.02")
        self.assertEqual((exit_code, report["message"]), (6, "stopped by the time limit"))
        self.assertLess(report["peak_memory_mb"], 100)  # it did not read it all

    def test_while_waiting_for_a_reader(self):
        self.write("small.off", to_off(SPHERE))
        os.mkfifo(self.folder / "pipe")
        for arguments in (["-o", "pipe"], ["-o", "pipe", "--svg", "a.svg", "--json", "r.json"]):
            self.write("a.svg", "former")
            program = self.start("small.off", *arguments)
            time.sleep(0.3)
            self.assertIsNone(program.poll())
            program.terminate()
            self.assert_ends(program, 6)
            self.assertEqual((self.folder / "a.svg").read_text(), "former")
        self.assertEqual(json.loads((self.folder / "r.json").read_text())["status"], "stopped")
        exit_code, _ = self.report("small.off", "-o", "pipe", "--time-limit", "0.3")
        self.assertEqual(exit_code, 6)

    def test_while_a_reader_is_busy(self):
        self.write("small.off", to_off(sphere(5)))
        read_end, write_end = os.pipe()
        self.addCleanup(os.close, read_end)
        fcntl.fcntl(write_end, fcntl.F_SETPIPE_SZ, 4096)
        program = self.start("small.off", "--effort", "fast", "-o", "/dev/stdout", "--svg", "a.svg", stdout=write_end)
        os.close(write_end)
        time.sleep(2)
        self.assertIsNone(program.poll())
        program.send_signal(signal.SIGINT)
        self.assert_ends(program, 6)
        self.assertEqual(self.files(), ["small.off"])

    def test_second_signal(self):
        """It ends the program at once, as SIGQUIT does at first, and nothing is left behind."""
        self.write("small.off", to_off(SPHERE))
        os.mkfifo(self.folder / "pipe")
        for number in (*SIGNALS, signal.SIGQUIT):
            self.write("small.svg", "former")
            program = self.start("small.off", "--effort", "fast", "-o", "pipe", "--svg", "small.svg")
            self.wait_for_content("small.svg", "former")
            self.assertEqual(len(self.files()), 4)  # with the former one, until there is a reader of the pipe
            for _ in range(1 if number == signal.SIGQUIT else 2):
                program.send_signal(number)
            self.assert_ends(program, -number, *([] if number == signal.SIGQUIT else [6]))
            self.assertEqual(self.files(), ["pipe", "small.off", "small.svg"])

    def test_hang_up_may_be_ignored(self):
        self.write("large.off", to_off(sphere(6)))
        program = self.start("large.off", "--effort", "fast", "--quiet",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.2)
        program.send_signal(signal.SIGHUP)
        program.communicate(timeout=TIME_LIMIT)
        self.assertEqual(program.returncode, 0)


main()
