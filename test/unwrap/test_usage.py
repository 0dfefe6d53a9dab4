"""The command line: what is refused, and that nothing happens then."""

import os
import re
import unittest

from support import Case, PROGRAM, main, sphere, to_off


class Usage(Case):
    def setUp(self):
        super().setUp()
        self.write("sphere.off", to_off(sphere(1)))

    def assert_usage(self, *arguments):
        return self.assert_refused(2, *arguments)

    def test_help_and_version(self):
        for option in ("--help", "-h", "--help-all", "--version"):
            run = self.unwrap(option)
            self.assertEqual((run.returncode, run.stderr), (0, b""))
            self.assertIn(b"unwrap", run.stdout)
        self.assertRegex(self.unwrap("--version").stdout.decode(), r"^unwrap \d+\.\d+\.\d+ \(CGAL \d+\.\d+.*\)\n$")

    def test_version(self):
        text = self.unwrap("--version").stdout.decode()
        self.assertRegex(text, r"^unwrap \d+\.\d+(\.\d+)* \(CGAL \d.*\)\n$")

    def test_help_fits_two_screens(self):
        lines = self.unwrap("--help").stdout.decode().splitlines()
        self.assertLessEqual(len(lines), 80)
        self.assertLessEqual(max(map(len, lines)), 100)
        text = "\n".join(lines)
        for word in ("Exit status", "Examples", "--output", "--json", "--html", "--max-distortion", "--effort", "--must-cut",
                     "--never-cut", "--margin", "--rotate", "--help-all"):
            self.assertIn(word, text)
        for word in ("--alpha", "--beta", "--eps-iso", "--eps-len", "--faithful", "--connect"):
            self.assertNotIn(word, text)

    def test_help_tells_all(self):
        text = self.unwrap("--help-all").stdout.decode()
        for word in ("Exit status", "Examples", "--json", "--seed", "--threads", "--quiet", "--alpha", "--beta", "--eps-iso",
                     "--eps-len", "--faithful", "--connect", "--up", "visibility"):
            self.assertIn(word, text)
        short = self.unwrap("--help").stdout.decode()
        for option in set(re.findall(r"--[a-z-]+", short)):
            self.assertIn(option, text)
        self.assertLess(text.index("--must-cut"), text.index("--alpha"))

    def test_near_misses(self):
        for wrong, meant in (("--maxdistortion", "--max-distortion"), ("--max_distortion", "--max-distortion"),
                             ("--nevercut", "--never-cut"), ("--marign=4", "--margin"), ("--Quiet", "--quiet"),
                             ("-margin", "--margin"), ("-texture-size=4", "--texture-size"), ("--output-file", "--output"),
                             ("--weld_tolerance", "--weld-tolerance"), ("--max", "--max-distortion")):
            message = self.assert_usage("sphere.off", wrong)["message"]
            self.assertIn(f"no option {wrong.split('=')[0]}; did you mean {meant}?", message)
        self.assertNotIn("did you mean", self.assert_usage("sphere.off", "--xyzzy")["message"])
        for option, wrong, meant, words in (("--effort", "fsat", "fast", "fast, default, best"),
                                            ("--rotate", "quarters", "quarter", "any, quarter, none, upright"),
                                            ("--uv-scale", "units", "unit", "unit, surface")):
            message = self.assert_usage("sphere.off", option, wrong)["message"]
            self.assertIn(f"{option}: '{wrong}' is none of {words}; did you mean {meant}?", message)
        for wrong in ("hidden", "visibilty"):
            message = self.assert_refused(3, "sphere.off", "--edge-weights", wrong)["message"]
            for word in ("crease", "concave", "straight", "visibility", "occlusion", "sky", "colors", "paint:FILE"):
                self.assertIn(word, message)
        self.assertIn("did you mean visibility?", message)

    def test_arguments(self):
        self.assert_usage()
        self.assertIn("other.off; the output is named with -o", self.assert_usage("sphere.off", "other.off")["message"])
        self.assert_usage("sphere.off", "--no-such-option")
        self.assert_usage("sphere.off", "--seed")
        self.assert_usage("sphere.off", "--seed", "1", "--seed", "2")
        self.assert_usage("sphere.off", "--solver", "magic")

    def test_numbers(self):
        bad = {"--seed": ["-1", "1.5", "4294967296", "1e3", "nan", "", "x", "0x10", "1 "],
               "--threads": ["0", "-2", "1025", "1.5", "99999999999999999999", "nan", "two"],
               "--time-limit": ["-1", "nan", "inf", "-inf", "1e400", "", "1s"],
               "--max-distortion": ["4", "3.9", "-5", "1e10", "nan", "four"]}
        for option, values in bad.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.assert_usage("sphere.off", f"{option}={value}")

    def test_bound_is_above_the_ideal(self):
        for value in ("4", "3", "four"):
            message = self.assert_usage("sphere.off", "--max-distortion", value)["message"]
            self.assertIn("must be greater than 4 ", message)
            self.assertIn(f"'{value}'", message)

    def test_empty_values(self):
        for option in ("-o", "--svg", "--texture", "--obj-cut", "--must-cut", "--never-cut", "--initial-cut",
                       "--terminals", "--edge-weights"):
            with self.subTest(option=option):
                self.assertIn("--output" if option == "-o" else option,
                              self.assert_usage("sphere.off", option, "")["message"])
        self.assertIn("INPUT", self.assert_usage("")["message"])
        self.assertIn(b"--json", self.unwrap("sphere.off", "--json", "").stderr)
        self.assertEqual(self.files(), ["sphere.off"])

    def test_values_that_look_like_options(self):
        for arguments in (["--json", "--bogus"], ["--json", "--quiet"], ["-o", "--svg", "a.svg"], ["--svg", "-o"],
                          ["--must-cut", "--quiet"], ["--texture=", "--quiet"], ["--svg=", "a.svg"]):
            with self.subTest(arguments=arguments):
                run = self.unwrap("sphere.off", *arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn(arguments[0].rstrip("=").encode(), run.stderr)
                self.assertEqual(self.files(), ["sphere.off"])
        self.assertEqual(self.unwrap("sphere.off", "-o", "./--a.obj", "--json=--b").returncode, 0)
        self.assertEqual(self.files(), ["--a.obj", "--b", "sphere.off"])

    def test_usage_error_is_reported_in_file(self):
        self.assertEqual(self.unwrap("sphere.off", "--json", "report.json", "--bad").returncode, 2)
        self.assertEqual(self.files(), ["report.json", "sphere.off"])

    def test_outputs_that_cannot_be_written(self):
        os.mkdir(self.folder / "folder")
        for option in ("-o", "--svg", "--texture", "--obj-cut"):
            for place in ("missing/file", "folder", "sphere.off/file", "x" * 300, "sphere.off"):
                with self.subTest(option=option, place=place):
                    self.assert_usage("sphere.off", option, place)
        self.assertEqual(self.unwrap("sphere.off", "--json", "missing/file").returncode, 2)
        self.assertEqual(self.files(), ["folder", "sphere.off"])

    def test_endings_of_outputs(self):
        """A file is what its name says."""
        for name in ("a.fbx", "a.dae", "a.stl", "a.off", "a.obj.zip", "a.Txt"):
            message = self.assert_usage("sphere.off", "-o", name)["message"]
            for ending in (".obj", ".glb", ".ply"):
                self.assertIn(ending, message)
        for option, name in (("--texture", "a.jpg"), ("--texture", "a.txt"), ("--svg", "a.jpg"), ("--svg", "a.PNG"),
                             ("--html", "a.svg"), ("--obj-cut", "a.ply")):
            with self.subTest(option=option, name=name):
                self.assertIn(name, self.assert_usage("sphere.off", option, name)["message"])
        self.assertEqual(self.unwrap("sphere.off", "--json", "a.csv").returncode, 2)
        self.assertEqual(self.files(), ["sphere.off"])
        self.assertEqual(self.unwrap("sphere.off", "-o", "a", "--svg", "b", "--json", "c.txt", "--obj-cut", "d",
                                     "--texture", "e.PNG").returncode, 0)
        self.assertEqual(self.files(), ["a", "a.mtl", "b", "c.txt", "d", "e.PNG", "sphere.off"])
        for name in ("b.GLB", "b.Ply", "b.OBJ"):
            self.assertEqual(self.unwrap("sphere.off", "-o", name).returncode, 0)
        starts = [(self.folder / name).read_bytes()[:4] for name in ("a", "b.GLB", "b.Ply", "b.OBJ")]
        self.assertEqual(starts, [b"mtll", b"glTF", b"ply\n", b"v 1 "])

    def test_messages_do_not_control_the_terminal(self):
        for name in ("a\x1b[31m.off", "a\r\n.off", "a\x9b2J.off", "a\u202egnp.off"):
            for make in (True, False):
                with self.subTest(name=name, make=make):
                    if make:
                        self.write(name, to_off(sphere(1)))
                    run = self.unwrap(name, "-o", "out.obj")
                    self.assertEqual(run.returncode, 0 if make else 3)
                    text = run.stderr.decode()
                    self.assertFalse([c for c in text if c != "\n" and (ord(c) < 32 or 126 < ord(c) < 160 or c == "\u202e")])
                    self.assertEqual(text.count("\n"), 2 if make else 1)
                    if make:
                        (self.folder / name).unlink()
        self.write("a.obj", "x\x1b[31m 1\n" + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertNotIn(b"\x1b", self.unwrap("a.obj", "--b\x1b[31m").stderr + self.unwrap("a.obj").stderr)

    def test_one_file_for_two_outputs(self):
        self.assert_usage("sphere.off", "-o", "a.obj", "--svg", "./a.obj")
        self.assert_usage("sphere.off", "-o", "a.obj", "--texture", "a.mtl")

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_full_disk(self):
        self.assert_usage("sphere.off", "-o", "/dev/full")
        self.assertEqual(os.system(f"cd '{self.folder}' && '{PROGRAM}' sphere.off --quiet"
                                   " --json - > /dev/full 2> /dev/null"), 2 << 8)
        self.assertEqual(self.files(), ["sphere.off"])


main()
