"""Random command lines of unwrap, in folders with inputs, links, former files and other traps."""

import contextlib
import os
import re
import resource
import signal
import subprocess
import unittest
from pathlib import Path, PurePath

from judge import CHECKS, Fault, changes, check_no_temporary_file, check_report, require, snapshot
from support import (PROGRAM, STATUS, as_nobody, decorated_obj, decorated_ply, joined, sphere, to_glb, to_obj, to_off, to_ply,
                     to_text_stl, torus, without_face)

COW = sphere(2)
A, B, C = COW[1][0]
QUADS = torus()[0], [tuple(one) + (two[2],) for one, two in zip(torus()[1][::2], torus()[1][1::2])]
SOUP = [COW[0][v] for face in COW[1] for v in face], [(i, i + 1, i + 2) for i in range(0, 3 * len(COW[1]), 3)]
START_OF_REPORT = b'{\n  "status": "'
FILES = {
    "cow.off": to_off(COW), "torus.obj": to_obj(torus()), "text.stl": to_text_stl(sphere(1)),
    "open.ply": to_ply(without_face(sphere(1)), "binary_little_endian"), "two.off": to_off(joined(COW, COW)),
    "truncated.off": to_off(COW)[:500], "quad.off": to_off((COW[0], [(0, 1, 2, 3)])), "empty.off": "",
    "s.txt": f"{A} {C}\n\n{A} {B}\n", "wrong.txt": "x\n", "far.txt": "1000000\n\n1 2\n", "none.txt": "",
    "weights.txt": f"{A} {B} 3\n{B} {C} inf\n", "huge.txt": f"{A} {B} 1e308\n", "paint.txt": "1 5\n2 0\n",
    "decorated.obj": decorated_obj(COW), "quads.obj": to_obj(QUADS), "quads.ply": to_ply(QUADS, "binary_big_endian"),
    "soup.off": to_off(SOUP), "repeated.off": to_off((COW[0], COW[1] + COW[1][::9] + [(1, 1, 2)])),
    "scene.glb": to_glb(*COW), "decorated.ply": decorated_ply(COW),
    "former.obj": "former", "report.json": START_OF_REPORT + b'usage"', "notes.txt": "precious",
}
CONSTRAINTS = ["s.txt", "s.txt", "s.txt", "wrong.txt", "far.txt", "none.txt", "weights.txt", "huge.txt", "cow.off",
               "missing.txt", "folder", "", "soft.off", "/dev/null"]
PLACES = [*FILES, "hard.off", "soft.off", "./cow.off", "folder/../cow.off", "dangling", "loop", "folder", "missing/x",
          "cow.off/x", "", "-", "--bogus", "x" * 300, "/dev/null", "/dev/full", "/dev/stdout", "/dev/stdin", "/dev/fd/1",
          "/dev/fd/77", "/proc/version", "a file", "locked/x", "pipe"]
OUTPUTS = {"--output": "a.obj", "--svg": "a.svg", "--html": "a.html", "--texture": "a.png", "--obj-cut": "cut.obj", "--json": "r.json"}
WORDS = {"--must-cut": ["uv", "angle:40", "materials", "groups"], "--initial-cut": ["uv"],  # no files
         "--edge-weights": ["crease", "concave", "straight", "visibility", "occlusion", "sky", "sky:z", "sky:w", "colors",
                            "paint:paint.txt", "paint:weights.txt"]}
INPUT_OPTIONS = ["--must-cut", "--never-cut", "--initial-cut", "--terminals", "--edge-weights"]
VALUES = {
    "--effort": ["fast", "default", "best"], "--connect": ["mst", "sph", "greedy", "exact", "best"],
    "--max-distortion": ["4.05", "4.2", "5", "1e9"], "--alpha": ["0", "0.1", "1", "1e-300"], "--beta": ["0", "20", "1e9"],
    "--eps-iso": ["0", "0.01", "1e9"], "--eps-len": ["0", "0.01"], "--seed": ["0", "1", "4294967295"],
    "--threads": ["1", "2", "1024"], "--solver": ["supernodal", "eigen"], "--weld": ["auto", "on", "off"],
    "--symmetry": ["auto", "off", "x", "y", "z"], "--seam-smoothness": ["0", "1", "100"],
    "--max-face-distortion": ["4.5", "8"], "--face-quantile": ["0.5", "0.99"], "--max-chart-distortion": ["4.05", "4.2"],
    "--texels-per-unit": ["10", "300", "1e9"], "--pages": ["1", "3"], "--uv-set": ["0", "1", "7"], "--lightmap": ["64", "512"],
    "--min-fill": ["0.2", "0.9"], "--stack-tolerance": ["0", "0.01"], "--time-limit": ["0", "0.001", "0.05", "5", "1e9", "1e-300"],
}
ODD_VALUES = ["", "nan", "inf", "-1", "4", "1e999", "4294967296", "none", "FAST", "x", "--svg", "-o", "0x10", " 1"]
FLAGS = ["--faithful", "--bijective", "--allow-overlap", "--quiet", "--quiet", "--quiet", "--progress", "--strict", "--tangents",
         "--hard-surface", "--udim", "--page-files", "--pack-only", "--stack", "--no-such-option"]
PATIENCE = 20  # seconds, of a run on such small meshes


def fill(folder):
    for name, content in FILES.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    os.link(folder / "cow.off", folder / "hard.off")
    os.mkfifo(folder / "pipe")
    for name, target in (("soft.off", "cow.off"), ("dangling", "target.obj"), ("loop", "loop")):
        os.symlink(target, folder / name)
    (folder / "folder").mkdir()
    (folder / "locked").mkdir(0o500)
    (folder / "former.obj").chmod(0o640)


class Case:
    """A command line, and what surrounds it."""

    def __init__(self, generator, folder):
        self.generator, self.folder = generator, folder
        self.inputs, self.outputs, self.arguments = [], [], []  # outputs: option and name
        self.pick_arguments()
        self.pick_surroundings()

    def some(self, share):
        return self.generator.random() < share

    def pick_arguments(self):
        groups = [[name] for name in self.pick_input()]
        for option, usual in OUTPUTS.items():
            for _ in range(self.some(0.5) + self.some(0.03)):
                if option == "--output":
                    usual = self.generator.choice(["a.obj", "a.obj", "a.ply", "a.glb", "a.gltf"])
                place = usual if self.some(0.8) else self.generator.choice(PLACES)
                if self.some(0.1):
                    place = str(self.folder / place)
                self.outputs.append((option, place))
                groups.append(self.spell(option, place))
        for option in INPUT_OPTIONS:
            if self.some(0.1):
                name = self.generator.choice(CONSTRAINTS + WORDS.get(option, []))
                self.inputs.append(name[len("paint:"):] if name.startswith("paint:") else name)
                groups.append(self.spell(option, name))
        for option, values in VALUES.items():
            if self.some(0.12):
                odd = self.some(0.08)
                groups.append(self.spell(option, self.generator.choice(ODD_VALUES if odd else values)))
        groups += [[flag] for flag in FLAGS if self.some(0.04)]
        self.generator.shuffle(groups)
        self.arguments = [word for group in groups for word in group]
        if self.some(0.03):
            self.arguments.append(self.generator.choice([*OUTPUTS, *INPUT_OPTIONS]))  # without a value

    def pick_input(self):
        name = "cow.off" if self.some(0.5) else self.generator.choice([*FILES, "soft.off", "hard.off", "missing.off", ""])
        self.inputs.append(name)
        return [name] * (1 if self.some(0.95) else self.generator.choice([0, 2]))

    def spell(self, option, value):
        if option == "--output" and self.some(0.7):
            return ["-o", value]
        return [option, value] if self.some(0.8) else [f"{option}={value}"]

    def pick_surroundings(self):
        self.stdout = self.generator.choices(["captured", "closed", "/dev/full", "log"], [20, 1, 1, 1])[0]
        self.file_size = self.generator.choice([0, 100, 5000]) if self.some(0.08) else None
        self.umask = self.generator.choice([0o022, 0o022, 0o077, 0o777])
        self.signal = self.generator.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
        self.moment = self.generator.uniform(0.05, 0.3)
        self.user = {}
        if os.geteuid() == 0 and self.some(0.15):
            with contextlib.suppress(unittest.SkipTest):
                self.user = as_nobody()
                self.folder.chmod(self.generator.choice([0o555, 0o777, 0o1777]))
                (self.folder / "notes.txt").chmod(0o666)

    def __str__(self):
        words = " ".join(repr(str(word)) for word in self.arguments)
        return (f"unwrap {words} (output {self.stdout}, limit {self.file_size}, umask {self.umask:o}, "
                f"{'nobody' if self.user else 'owner'}, folder {self.folder.stat().st_mode & 0o7777:o})")

    def prepare(self):
        if self.stdout == "closed":
            os.close(1)
        if self.file_size is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (self.file_size, self.file_size))

    def run(self, slack):
        """A signal ends what waits for a reader of the pipe."""
        log = open(self.folder / "log", "ab") if self.stdout == "log" else None
        stdout = {"captured": subprocess.PIPE, "closed": None, "log": log}.get(self.stdout)
        with contextlib.ExitStack() as stack:
            if log:
                stack.enter_context(log)
            if self.stdout == "/dev/full":
                stdout = stack.enter_context(open("/dev/full", "wb"))
            program = stack.enter_context(subprocess.Popen(
                [PROGRAM, *self.arguments], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=stdout,
                stderr=subprocess.PIPE, preexec_fn=self.prepare, umask=self.umask, **self.user))
            try:
                if self.is_signaled():
                    with contextlib.suppress(subprocess.TimeoutExpired):
                        return program, *program.communicate(timeout=self.moment)
                    program.send_signal(self.signal)
                    return program, *program.communicate(timeout=slack)
                return program, *program.communicate(timeout=PATIENCE)
            except subprocess.TimeoutExpired:
                program.kill()
                raise Fault("does not end") from None

    def is_signaled(self):
        return any("pipe" in name for _, name in self.outputs) or int(self.moment * 1e6) % 5 == 0

    # ------------------------------------------------------------------------------ what it may do

    def path(self, name):
        return os.path.realpath(self.folder / name)

    def declared(self):
        """Paths of regular files that may be written, by option; more than one if an option is repeated."""
        outputs = [(option, name) for option, name in self.outputs if name and not (option == "--json" and name == "-")]
        meshes = [name for option, name in outputs if option == "--output"]
        if not meshes:
            meshes = [PurePath(name).stem + ".uv.obj" for name in self.inputs[:1] if name]
            outputs += [("--output", name) for name in meshes]
        if any(option == "--texture" for option, _ in outputs):
            outputs += [("material", str(PurePath(name).with_suffix(".mtl"))) for name in meshes
                        if PurePath(name).name and PurePath(name).suffix not in (".ply", ".glb", ".gltf")]
        if "--page-files" in self.arguments:
            outputs = [(option, first_page(name) if option in ("--output", "--svg") else name) for option, name in outputs]
        return [(option, self.path(name)) for option, name in outputs
                if not self.path(name).startswith(("/dev/", "/proc/"))]


def first_page(name):
    path = PurePath(name)
    return str(path.with_name(f"{path.stem}.1001{path.suffix}")) if path.name else name


def is_of_later_page(path):
    return re.search(r"\.1(00[2-9]|0[1-9]\d|[1-9]\d\d)(\.\w+)?$", path) is not None


def inodes(paths):
    return {(os.stat(path).st_dev, os.stat(path).st_ino) for path in paths if os.path.isfile(path)}


def judge_files(case, exit_code, messages, before, after, is_understood):
    changed = {os.path.realpath(path) for path in changes(before, after)
               if not path.endswith("/log") and (path in before or not is_of_later_page(path))}
    inputs = inodes(case.path(name) for name in case.inputs if name)
    touched = {path for path in changed if path in before and inodes([path]) & inputs}
    if not is_understood:  # a former report is nobody's input
        touched = {path for path in touched if not before[path][1].startswith(START_OF_REPORT)}
    require(not touched, f"inputs changed: {touched}")
    declared = case.declared()
    reports = {path for option, path in declared if option == "--json"}
    others = [path for option, path in declared if option != "--json"]
    if not is_understood:
        require(all(path not in before or before[path][1] is None or before[path][1].startswith(START_OF_REPORT)
                    for path in changed), f"replaced: {changed}")
        require(changed <= reports, f"changed by a command line that is not understood: {changed}")
    elif exit_code in (0, 7) or (exit_code == 6 and "best result" in messages):
        require(len({path for _, path in declared}) == len(declared), "two outputs at the same place")
        require(changed == set(others) | reports, f"changed: {changed}, asked for: {declared}")
        for option, path in declared:
            if option in CHECKS:
                CHECKS[option](after[path][1])
            require(path not in before or before[path][0] == after[path][0], f"other permissions: {path}")
    else:
        require(changed <= reports - set(others), f"changed without a result: {changed}")
    for path in changed & reports:
        check_report(after[path][1], exit_code)


def judge_standard_output(case, exit_code, output):
    """A report that was asked for is there, whatever happened, unless something else got into its way."""
    names = [name for option, name in case.outputs if option == "--json"]
    is_mixed = any(name.startswith(("/dev/stdout", "/dev/fd/1")) for _, name in case.outputs)
    if case.stdout == "captured" and names == ["-"] and not is_mixed and case.arguments[-1] != "--json":
        check_report(output, exit_code)


def run_case(generator, folder, slack):
    """Returns a description for the log, and the exit code."""
    fill(folder)
    case = Case(generator, folder)
    description = str(case)
    try:
        before = snapshot(folder)
        program, output, errors = case.run(slack)
        messages, exit_code = errors.decode(errors="replace"), program.returncode
        is_asked_for_help = exit_code == 0 and not messages
        if exit_code == -case.signal and case.is_signaled():
            # It came before the program could watch for it.
            require(snapshot(folder) == before, "ended by the first signal, and left a trace")
            return description, exit_code
        require(exit_code in STATUS, f"exit code {exit_code}: {messages}")
        require(exit_code == 0 or messages.count("unwrap: ") - messages.count("unwrap: warning: ") >= 1, "no message")
        after = snapshot(folder)
        check_no_temporary_file(after)
        if not is_asked_for_help or "--quiet" in case.arguments:
            judge_files(case, exit_code, messages, before, after, "(see unwrap --help)" not in messages)
            judge_standard_output(case, exit_code, output)
    except Fault as fault:
        raise Fault(f"{description}: {fault}") from None
    finally:
        Path(folder, "locked").chmod(0o700)
    return description, exit_code
