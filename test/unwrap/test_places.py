"""Where the program writes: never over an input, all of its outputs or none, and into what is there already."""

import json
import os
import resource
import signal
import stat
import subprocess
import time
import unittest

from support import Case, PROGRAM, TIME_LIMIT, as_nobody, main, sphere, to_off

SPHERE = sphere(1)
MESH = to_off(SPHERE)
REPORT = '{\n  "status": "usage"'
SELECTION = "\n\n\n"


def has_mounts():
    return subprocess.run(["unshare", "--mount", "--map-root-user", "true"], capture_output=True,
                          check=False).returncode == 0


class Places(Case):
    def setUp(self):
        super().setUp()
        self.write("cow.off", MESH)

    def contents(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}

    def assert_untouched(self, *arguments, code=2, **keywords):
        """The program fails and changes nothing at all."""
        before = self.contents()
        run = self.unwrap(*arguments, **keywords)
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertEqual(self.contents(), before)
        return run.stderr.decode()

    # ------------------------------------------------------------------------ reports of failures

    def test_report_does_not_replace_the_input(self):
        os.link(self.folder / "cow.off", self.folder / "hard.off")
        os.symlink("cow.off", self.folder / "soft.off")
        for name in ("cow.off", "hard.off", "soft.off", "./cow.off", self.folder / "cow.off"):
            for arguments in (["--json", name], [f"--json={name}"], ["cow.off", "--json", name],
                              ["cow.off", "--json", name, "--bogus"], ["--json", name, "cow.off", "--effort", "no"]):
                with self.subTest(arguments=arguments):
                    self.assert_untouched(*arguments)

    def test_report_does_not_replace_constraints(self):
        self.write("s.txt", SELECTION)
        for option in ("--must-cut", "--never-cut", "--initial-cut", "--terminals", "--edge-weights"):
            with self.subTest(option=option):
                self.assert_untouched("cow.off", option, "s.txt", "--json", "s.txt")

    def test_report_does_not_replace_outputs(self):
        self.write("a.obj", "former")
        for arguments in (["-o", "a.obj", "--json", "a.obj"], ["--svg", "a.obj", "--json", "./a.obj"],
                          ["-o", "b.obj", "--svg", "b.obj", "--obj-cut", "a.obj", "--json", "a.obj"]):
            with self.subTest(arguments=arguments):
                self.assert_untouched("cow.off", *arguments)

    def test_report_of_another_place_is_written(self):
        for arguments in (["-o", "cow.off"], ["--svg", "a.obj", "-o", "a.obj"], ["--svg", "missing/a.svg"]):
            with self.subTest(arguments=arguments):
                self.unwrap("cow.off", *arguments, "--json", "report.json")
                self.assertEqual(self.files(), ["cow.off", "report.json"])
                self.assertEqual(json.loads((self.folder / "report.json").read_text())["status"], "usage")
                (self.folder / "report.json").unlink()

    def test_report_on_a_command_line_that_is_not_understood(self):
        self.write("notes.txt", "precious")
        self.write("empty", "")
        for name in ("notes.txt", "empty", ".", "x" * 300, "cow.off/x", "/dev/fd/99"):
            self.assert_untouched("cow.off", "--json", name, "--bogus")
        for former in (None, REPORT):
            if former is not None:
                self.write("report.json", former)
            self.unwrap("cow.off", "--json", "report.json", "--bogus")
            report = json.loads((self.folder / "report.json").read_text())
            self.assertIn("--bogus", report["message"])
        run = self.unwrap("--bogus", "--json", "/dev/stdout")
        self.assertEqual(json.loads(run.stdout)["status"], "usage")

    def test_report_that_cannot_be_written_is_told_once(self):
        for name in ("missing/report.json", "cow.off", "/dev/full"):
            with self.subTest(name=name):
                self.assertEqual(self.assert_untouched("cow.off", "--json", name).count("\n"), 1)

    # ---------------------------------------------------------------------------- all or nothing

    def test_mount_points(self):
        if not has_mounts():
            self.skipTest("no name spaces here")
        self.write("s.svg", "former")
        self.write("other", "behind the mount point")
        script = 'mount --bind other s.svg && exec "$@"'
        run = subprocess.run(["unshare", "--mount", "--map-root-user", "sh", "-c", script, "sh", PROGRAM, "cow.off",
                              "-o", "o.obj", "--svg", "s.svg"], cwd=self.folder, capture_output=True, check=False,
                             timeout=TIME_LIMIT)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertEqual(self.files(), ["cow.off", "other", "s.svg"])
        self.assertEqual((self.folder / "other").read_text(), "behind the mount point")

    @unittest.skipUnless(os.geteuid() == 0, "only root can make files of others")
    def test_sticky_folder(self):
        self.write("s.svg", "former")
        self.folder.chmod(0o1777)
        (self.folder / "s.svg").chmod(0o666)
        self.assert_untouched("cow.off", "-o", "o.obj", "--svg", "s.svg", **as_nobody())

    def test_failure_of_the_last_output(self):
        """What fails only when all are complete: all files are as they were."""
        self.write("o.obj", "former")
        with open("/dev/full", "wb") as full:
            self.assert_untouched("cow.off", "-o", "o.obj", "--svg", "new.svg", "--obj-cut", "/dev/stdout",
                                  stdout=full)

    def test_place_that_is_taken_meanwhile(self):
        """The second of two files cannot be put into its place: the first one is taken back."""
        self.write("large.off", to_off(sphere(5)))
        self.write("o.obj", "former")
        for first in ("o.obj", "new.obj"):
            program = subprocess.Popen([PROGRAM, "large.off", "-o", first, "--svg", "s.svg"], cwd=self.folder,
                                       stderr=subprocess.PIPE)
            time.sleep(0.2)
            program.send_signal(signal.SIGSTOP)
            (self.folder / "s.svg").mkdir()
            program.send_signal(signal.SIGCONT)
            _, message = program.communicate(timeout=TIME_LIMIT)
            self.assertEqual(program.returncode, 2, message)
            self.assertEqual(self.files(), ["cow.off", "large.off", "o.obj", "s.svg"])
            self.assertEqual((self.folder / "o.obj").read_text(), "former")
            (self.folder / "s.svg").rmdir()

    def test_file_size_limit(self):
        for limit in (0, 1000):
            with self.subTest(limit=limit):
                message = self.assert_untouched("cow.off", "--svg", "a.svg", preexec_fn=lambda size=limit:
                                                resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
                self.assertIn("cannot write", message)

    def test_left_over_temporary_file(self):
        """Process numbers return, in containers at each start."""
        def occupy():
            for kind in ("", "_0", "_1"):
                (self.folder / f".unwrap_{os.getpid()}{kind}.tmp").write_text("left over")
        self.assertEqual(self.unwrap("cow.off", preexec_fn=occupy).returncode, 0)
        self.assertEqual(len(self.files()), 5)

    def test_permissions(self):
        for mode in (0o600, 0o640, 0o755):
            self.write("a.obj", "former")
            (self.folder / "a.obj").chmod(mode)
            self.assertEqual(self.unwrap("cow.off", "-o", "a.obj").returncode, 0)
            self.assertEqual(stat.S_IMODE((self.folder / "a.obj").stat().st_mode), mode)
            (self.folder / "a.obj").unlink()
        self.assertEqual(self.unwrap("cow.off", "-o", "a.obj", umask=0o027).returncode, 0)
        self.assertEqual(stat.S_IMODE((self.folder / "a.obj").stat().st_mode), 0o640)

    @unittest.skipUnless(os.geteuid() == 0, "needs another user than the owner")
    def test_read_only_files(self):
        self.folder.chmod(0o777)
        self.write("a.obj", "former")
        (self.folder / "a.obj").chmod(0o444)
        self.assertIn("Permission denied", self.assert_untouched("cow.off", "-o", "a.obj", **as_nobody()))
        self.assertIn("read-only", self.assert_untouched("cow.off", "-o", "a.obj"))

    @unittest.skipUnless(os.geteuid() == 0, "only root can give files away")
    def test_owner(self):
        self.write("a.obj", "former")
        (self.folder / "a.obj").chmod(0o600)
        os.chown(self.folder / "a.obj", 65534, 65534)
        self.assertEqual(self.unwrap("cow.off", "-o", "a.obj").returncode, 0)
        status = (self.folder / "a.obj").stat()
        self.assertEqual((status.st_uid, status.st_gid, stat.S_IMODE(status.st_mode)), (65534, 65534, 0o600))
        self.assertTrue((self.folder / "a.obj").read_text().startswith("v "))
        # Who may not give files away has one of his own, with the same permissions.
        self.folder.chmod(0o777)
        (self.folder / "a.obj").chmod(0o666)
        os.chown(self.folder / "a.obj", 0, 0)
        self.assertEqual(self.unwrap("cow.off", "-o", "a.obj", **as_nobody()).returncode, 0)
        status = (self.folder / "a.obj").stat()
        self.assertEqual((status.st_uid, stat.S_IMODE(status.st_mode)), (65534, 0o666))

    @unittest.skipUnless(os.geteuid() == 0, "needs another user than the owner")
    def test_reason_why_a_file_cannot_be_read(self):
        os.mkdir(self.folder / "locked", 0o700)
        self.write("locked/cow.off", MESH)
        self.write("unreadable.off", MESH)
        (self.folder / "unreadable.off").chmod(0)
        self.folder.chmod(0o777)
        for arguments in (["locked/cow.off"], ["unreadable.off"], ["cow.off", "--must-cut", "locked/s.txt"]):
            run = self.unwrap(*arguments, **as_nobody())
            self.assertEqual(run.returncode, 3)
            self.assertIn(b"Permission denied", run.stderr)

    # ---------------------------------------------------------------------------- pipes and devices

    def shell(self, script):
        run = subprocess.run(["bash", "-c", script, "bash", PROGRAM], cwd=self.folder, capture_output=True,
                             timeout=TIME_LIMIT, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def test_pipes(self):
        expected = self.shell('"$1" cow.off --quiet; cat cow.uv.obj; rm cow.uv.obj')
        self.assertEqual(self.shell('"$1" cow.off --quiet -o /dev/stdout | cat'), expected)
        self.assertEqual(self.shell('"$1" cow.off --quiet -o >(cat > a.obj; echo > done); '
                                    'until test -e done; do sleep 0.01; done; cat a.obj; rm a.obj done'), expected)
        self.assertEqual(self.shell('mkfifo f; "$1" cow.off --quiet -o f & sleep 0.2; cat f; wait $!; rm f'), expected)
        text = self.shell('"$1" cow.off --quiet --json >(cat) -o /dev/null | cat')
        self.assertEqual(json.loads(text)["status"], "done")
        self.assertEqual(self.files(), ["cow.off"])

    def test_open_files_are_appended_to(self):
        self.write("log", "before\n")
        self.shell('"$1" cow.off --quiet --json /dev/stdout >> log; echo after >> log')
        self.shell('exec 3>> log; "$1" cow.off --quiet --json /dev/fd/3; echo last >&3')
        text = (self.folder / "log").read_text()
        self.assertTrue(text.startswith("before\n{") and text.endswith("}\nlast\n"))
        self.assertEqual((text.count("after\n"), text.count('"status": "done"')), (1, 2))

    def test_descriptors_that_cannot_be_written_to(self):
        for name in ("/dev/stdin", "/dev/fd/0", "/dev/fd/99"):
            with self.subTest(name=name), open(self.folder / "cow.off", "rb") as file:
                self.assert_untouched("cow.off", "-o", name, stdin=file)
        self.assert_untouched("cow.off", "--json", "-", preexec_fn=lambda: os.close(1))
        with open(self.folder / "cow.off", "ab") as file:  # the report would get into the input
            self.assert_untouched("cow.off", "--json", "-", stdout=file)

    def test_material_needs_a_file_beside_it(self):
        self.assert_untouched("cow.off", "-o", "/dev/null", "--texture", "a.png")
        self.assertFalse(os.path.exists("/dev/null.mtl"))


main()
