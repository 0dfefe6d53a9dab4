"""Runs that are stopped at a random moment, by the time limit or a signal."""

import functools
import math
import signal
import subprocess
import sys
import time
from pathlib import Path

from judge import Fault, changes, check_no_temporary_file, check_obj, check_report, require, snapshot
from support import MESH_DIR, PROGRAM, STATUS, joined, sphere, to_off, torus, without_face

# Names and how often they are used: small meshes mostly.
MESHES = {"sphere_2": 4, "sphere_3": 8, "arms_3": 6, "torus": 4, "open_3": 4, "two_3": 4, "arms_4": 6, "sphere_5": 2,
          "arms_5": 2, "sphere_7": 1}
DATA_MESHES = {"eight.off": 4, "bear.off": 3, "triceratops.off": 3, "cow.off": 3, "camel.off": 1, "homer.off": 1}
LARGEST_MOMENT = 4  # seconds
LOADING = 0.2  # seconds until the program can take signals
ATTEMPTS = 3  # a busy machine is not late every time
PATIENCE = 120  # seconds, for a run that is not stopped
PATIENCE_AFTER_STOP = 10
SIZE_OF_PROMISE = 100000  # triangles; the steps between two questions grow with the surface


@functools.lru_cache(maxsize=None)
def mesh(name):
    kind, _, levels = name.partition("_")
    surface = sphere(int(levels)) if levels else torus(12)
    if kind == "arms":
        arm = lambda p: 1 + 2 * (math.sin(4 * p[0]) * math.sin(4 * p[1]) * math.cos(3 * p[2])) ** 2
        surface = [tuple(arm(p) * x for x in p) for p in surface[0]], surface[1]
    return {"open": without_face, "two": lambda m: joined(m, m)}.get(kind, lambda m: m)(surface)


def pick_mesh(generator, folder):
    """Returns the numbers of vertices and faces, too."""
    choices = dict(MESHES)
    choices.update({name: weight for name, weight in DATA_MESHES.items() if (MESH_DIR / name).is_file()})
    name = generator.choices(list(choices), list(choices.values()))[0]
    path = folder / "mesh.off"
    if name in DATA_MESHES:
        text = (MESH_DIR / name).read_text()
        path.write_text(text)
        faces = [line.split()[1:4] for line in text.splitlines()[-100:] if line.startswith("3 ")]
        return name, None, [tuple(map(int, face)) for face in faces]
    points, faces = mesh(name)
    path.write_text(to_off((points, faces)))
    return name, (len(points), len(faces)), faces


def pick_options(generator, folder, faces):
    """Some of the faces are used for constraints."""
    options = ["--effort", generator.choice(["fast", "default", "default", "best"]), "--seed", generator.randrange(100),
               "--threads", generator.choice([1, 2])]
    some = lambda share: generator.random() < share
    options += ["--faithful"] * some(0.1) + ["--bijective"] * some(0.3)
    if some(0.3):
        options += ["--max-distortion", generator.choice([4.02, 4.05, 4.1, 4.3])]
    if some(0.2):
        options += ["--connect", generator.choice(["mst", "sph", "greedy", "exact", "best"])]
    if some(0.1):
        options += ["--alpha", generator.choice([0, 0.5, 1])]
    if some(0.3):
        options += ["--edge-weights", generator.choice(["concave", "straight", "visibility", "sky"])]
    if faces and some(0.3):
        face = generator.choice(faces)
        (folder / "s.txt").write_text(f"{face[2]}\n\n{face[0]} {face[1]}\n")
        options += [generator.choice(["--must-cut", "--never-cut", "--initial-cut", "--terminals"]), "s.txt"]
    return [str(option) for option in options]


class Stop:
    """The moment is more often early than late."""

    def __init__(self, generator):
        self.moment = math.exp(generator.uniform(math.log(0.003), math.log(LARGEST_MOMENT)))
        self.signal = generator.choice([None, None, signal.SIGINT, signal.SIGTERM, signal.SIGHUP])

    def __str__(self):
        return f"{'limit' if self.signal is None else self.signal.name} at {self.moment:.3f} s"


def run_stopped(folder, arguments, stop):
    """Returns the exit code, the messages, and the seconds from the stop to the end (negative: before it)."""
    if stop.signal is None:
        arguments = [*arguments, "--time-limit", f"{stop.moment:.6f}"]
    start = time.monotonic()
    with subprocess.Popen([PROGRAM, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True) as program:
        try:
            messages = program.communicate(timeout=stop.moment)[1]
        except subprocess.TimeoutExpired:
            start = time.monotonic() - stop.moment
            if stop.signal is not None:
                program.send_signal(stop.signal)
            messages = wait_for_end(program)
    return program.returncode, messages, time.monotonic() - start - stop.moment


def wait_for_end(program):
    try:
        return program.communicate(timeout=PATIENCE_AFTER_STOP)[1]
    except subprocess.TimeoutExpired:
        program.kill()
        raise Fault(f"no end within {PATIENCE_AFTER_STOP} s after the stop") from None


def check_same_as_unstopped(folder, arguments, exit_code, after):
    """A run that ends as if nothing had happened has to be as if nothing had happened."""
    try:
        run = subprocess.run([PROGRAM, *arguments, "-o", "full.obj"], cwd=folder, stdin=subprocess.DEVNULL,
                             capture_output=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        raise Fault(f"exit code {exit_code} after a stop; without it, it takes more than {PATIENCE} s") from None
    require(run.returncode == exit_code,
            f"exit code {exit_code} after a stop, but {run.returncode} without: {run.stderr.decode()}")
    if exit_code in (0, 7):
        full = (folder / "full.obj").read_bytes()
        require(full == after[str(folder / "out.obj")][1], f"exit code {exit_code}, but not the whole result")


def run_case(generator, folder, slack):
    """Returns a description for the log, and the exit code."""
    name, size, faces = pick_mesh(generator, folder)
    if size:
        slack *= max(1, size[1] / SIZE_OF_PROMISE)
    options = ["mesh.off", *pick_options(generator, folder, faces)]
    outputs = ["-o", "out.obj", "--json", "r.json"] + ["--svg", "a.svg"] * (generator.random() < 0.3)
    stop = Stop(generator)
    description = f"{name}: {' '.join(options + outputs)}; {stop}"
    try:
        before = snapshot(folder)
        for attempt in range(ATTEMPTS):
            exit_code, messages, lateness = run_stopped(folder, [*options, *outputs], stop)
            if lateness <= slack:
                break
            remove_new_files(before, folder)
            print(f"  {lateness:.2f} s late (attempt {attempt + 1}): {description}", file=sys.stderr)
            if attempt == ATTEMPTS - 1:
                raise Fault(f"ended {lateness:.2f} s after the stop")
        if stop.signal and exit_code == -stop.signal and stop.moment < LOADING:
            require(snapshot(folder) == before, "files changed before the program was there")
            return description, exit_code
        judge(folder, before, exit_code, messages, size)
        if exit_code != 6 and lateness > 0:
            check_same_as_unstopped(folder, options, exit_code, snapshot(folder))
    except Fault as fault:
        raise Fault(f"{description}: {fault}") from None
    return description, exit_code


def remove_new_files(before, folder):
    for path in snapshot(folder).keys() - before.keys():
        Path(path).unlink()


def judge(folder, before, exit_code, messages, size):
    require(exit_code in STATUS and exit_code != 2, f"exit code {exit_code}: {messages}")
    after = snapshot(folder)
    check_no_temporary_file(after)
    changed = {path.rpartition("/")[2] for path in changes(before, after)}
    report = check_report(after[str(folder / "r.json")][1], exit_code)
    has_result = exit_code in (0, 7) or "the best result so far is written" in report["message"]
    require(("out.obj" in changed) == has_result, f"exit code {exit_code}, {report['message']}: {changed}")
    require(changed <= {"out.obj", "r.json", "a.svg"}, f"changed: {changed}")
    if has_result:
        check_obj(after[str(folder / "out.obj")][1], *(size or (report["vertices"], report["faces"])))
