"""Runs each program of a table on each mesh, one at a time, within a limit of processor seconds, and measures what it returns. A
record per run, a line of JSON, is kept, and no run is made twice."""

import dataclasses
import json
import math
import os
import pathlib
import re
import resource
import shlex
import signal
import subprocess
import time
import types

from surface_files import Unreadable, read_result, read_surface, write_surface
from uv_measures import Invalid, measure

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = pathlib.Path(__file__).resolve().parent / "programs.txt"
SUFFIXES = (".obj", ".off", ".ply")
MESSAGE_LIMIT = 300  # characters
IDLE = 20  # times as long may a run take by the clock as by the processor


@dataclasses.dataclass
class Program:
    name: str
    command: str

    def words(self, places):
        return [word.format(**places) for word in shlex.split(self.command)]

    def needs(self):
        """The programs in braces in its command."""
        return set(re.findall(r"\{(\w+)[.}]", self.command)) - {"root", "input", "output"}

    def measured(self):
        """The programs whose measures it is given, each with the measure."""
        return sorted(set(re.findall(r"\{(\w+)\.(\w+)\}", self.command)))

    def is_rival(self):
        """Whether it is another program that works alone."""
        return not self.needs() and "/bin/unwrap" not in self.command


class Output(types.SimpleNamespace):
    """The path of a result, for commands, with its measures as members."""

    def __format__(self, spec):
        return str(self.path)


def read_programs(path):
    lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines()]
    return [Program(*map(str.strip, line.split(":", 1))) for line in lines if line and not line.startswith("#")]


def find_meshes(names):
    for name in map(pathlib.Path, names):
        yield from sorted(file for file in name.iterdir() if file.suffix in SUFFIXES) if name.is_dir() else [name]


def peak_memory(pid):
    """In MB, of the process since it became that program: what wait4() tells counts this one before."""
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii", errors="replace")
    except OSError:
        return 0
    found = re.search(r"VmHWM:\s*(\d+)", status)
    return int(found[1]) / 1024 if found else 0


def run_limited(command, log, seconds):
    """The exit code, or None if the time was up, processor seconds, and the largest memory in MB."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    # Blender takes the first Python on the path for its own.
    environment = {**os.environ, "PATH": f"/usr/bin:{os.environ['PATH']}"}
    start, memory, pid, is_late = time.monotonic(), 0, 0, False
    with open(log, "wb") as file:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=file, start_new_session=True,
                                   preexec_fn=limit, env=environment)
    try:
        while not pid:
            memory = max(memory, peak_memory(process.pid))
            time.sleep(0.005)
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if not pid and time.monotonic() - start > IDLE * seconds and not is_late:
                is_late = True
                os.killpg(process.pid, signal.SIGKILL)
    finally:  # of a run that is ended nothing is to stay behind
        if not pid:
            os.killpg(process.pid, signal.SIGKILL)
    process.returncode = exit_code = os.waitstatus_to_exitcode(status)
    is_late = is_late or exit_code in (-signal.SIGXCPU, -signal.SIGKILL) and usage.ru_utime + usage.ru_stime >= seconds - 1
    return None if is_late else exit_code, usage.ru_utime + usage.ru_stime, memory


def run(program, surface, places, time_limit):
    """All of the record but what it is of."""
    missing = [name for name in sorted(program.needs()) if name not in places]
    if missing:
        return {"outcome": "failed", "message": f"no result of {missing[0]}"}
    output, log = places["output"], places["output"].with_suffix(".log")
    output.parent.mkdir(parents=True, exist_ok=True)
    output.unlink(missing_ok=True)
    try:
        exit_code, seconds, memory = run_limited(program.words(places), log, time_limit)
    except (OSError, AttributeError) as error:  # no such program, no such measure
        return {"outcome": "failed", "message": str(error)}
    text = log.read_text(encoding="utf-8", errors="replace")
    told = re.findall(r"^seconds ([\d.e+-]+)$", text, re.M)
    record = {"seconds": float(told[-1]) if told else round(seconds, 3), "memory_mb": round(memory, 1)}
    if exit_code is None:
        return {"outcome": "time is up", "message": f"after {time_limit:g} s", **record}
    try:
        if exit_code != 0:
            raise Invalid(f"exit status {exit_code}: {text[-MESSAGE_LIMIT:].strip()}")
        return {"outcome": "done", "message": "", **record, **measure(*surface, read_result(output, surface[1]))}
    except (Invalid, Unreadable, OSError, ValueError, IndexError) as error:
        return {"outcome": "failed", "message": str(error), **record}


def read_records(path):
    """By mesh and command; a line that was left unfinished is none."""
    records = {}
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        try:
            record = json.loads(line)
            records[record["mesh"], record["command"]] = record
        except (json.JSONDecodeError, KeyError):
            continue
    return records


def run_all(programs, meshes, folder, time_limit, say=print):
    """The records of all, {mesh: {program: record}}. A mesh that cannot be read is named and left out, since no program gets it."""
    folder.mkdir(parents=True, exist_ok=True)
    file, found = folder / "records.jsonl", {}
    stored = read_records(file)
    for mesh in meshes:
        name, surface = mesh.name, None
        places = {"root": ROOT, "input": folder / "input" / f"{mesh.stem}.obj"}
        for program in programs:
            places["output"] = folder / program.name / f"{mesh.stem}.obj"
            record = stored.get((name, program.command))
            if record is None:
                try:
                    surface = surface or read_surface(mesh)
                except Unreadable as error:
                    say(f"not read: {error}")
                    break
                if not places["input"].exists():
                    places["input"].parent.mkdir(parents=True, exist_ok=True)
                    write_surface(places["input"], *surface)
                record = {"mesh": name, "program": program.name, "command": program.command,
                          **run(program, surface, places, time_limit)}
                with open(file, "a", encoding="utf-8") as output:
                    output.write(json.dumps(record) + "\n")
                say(f"{name} {program.name}: {record['outcome']} {record['message']}".rstrip())
            if record["outcome"] == "done":
                places[program.name] = Output(path=places["output"], **record)
            found.setdefault(name, {})[program.name] = record
    return found
