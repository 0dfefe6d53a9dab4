"""The command line: what is refused, and that nothing happens then."""

import os
import unittest

from support import Case, PROGRAM, main, sphere, to_off


class Usage(Case):
    def setUp(self):
        super().setUp()
        self.write("sphere.off", to_off(sphere(1)))

    def assert_usage(self, *arguments):
        return self.assert_refused(2, *arguments)

    def test_help_and_version(self):
        for option in ("--help", "-h", "--version"):
            run = self.unwrap(option)
            self.assertEqual((run.returncode, run.stderr), (0, b""))
            self.assertIn(b"unwrap", run.stdout)

    def test_help_names_exit_status(self):
        text = self.unwrap("--help").stdout.decode()
        for word in ("Exit status", "Examples", "--json", "--seed", "--threads", "--quiet"):
            self.assertIn(word, text)

    def test_arguments(self):
        self.assert_usage()
        self.assert_usage("sphere.off", "other.off")
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
