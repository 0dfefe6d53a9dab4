#!/usr/bin/env python3
"""Runs unwrap on one mesh, within limits, and says in one line of JSON how it ended:

  mesh, options   what was run; the mesh as it was named on the command line
  outcome         the class of the outcome (see outcomes.py)
  exit_code       of the program; negative for a signal
  seconds, peak_memory_mb   wall clock and memory of the process
  report          the program's own report, or null
  messages        the end of what the program wrote on standard error
  digest          SHA-256 of the mesh with texture coordinates, or null
  judgement       what the judge printed, if there is one

Exit status: 0, whatever the outcome.
"""

import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from outcomes import classify

MESSAGE_LIMIT = 2000  # characters


def read_json(text):
    try:
        return json.loads(text)
    except (json.JSONDecodeError, UnicodeDecodeError):
        return None


def limit_memory(megabytes):
    size = megabytes << 20 if megabytes else resource.RLIM_INFINITY
    resource.setrlimit(resource.RLIMIT_AS, (size, size))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run_limited(command, seconds, megabytes):
    """The exit code, standard output and error, and whether the time was up."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          start_new_session=True, preexec_fn=lambda: limit_memory(megabytes)) as process:
        try:
            return *process.communicate(timeout=seconds), process.returncode, False
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return *process.communicate(), process.returncode, True
        except BaseException: # of a runner that is ended nothing is to stay behind
            os.killpg(process.pid, signal.SIGKILL)
            raise


def judge(program, mesh, result, seconds):
    output, _, exit_code, is_timed_out = run_limited([program, mesh, result], seconds, 0)
    return {"exit_code": exit_code, "is_timed_out": is_timed_out, "output": read_json(output)}


def run_mesh(arguments, options):
    with tempfile.TemporaryDirectory() as folder:
        result = pathlib.Path(folder, "result.obj")
        start = time.monotonic()
        output, errors, exit_code, is_timed_out = run_limited(
            [arguments.program, arguments.mesh, "-o", result, "--json", "-", "--quiet", *options],
            arguments.time_limit, arguments.memory_limit)
        seconds = time.monotonic() - start
        memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        report = read_json(output)
        record = {
            "mesh": arguments.mesh, "options": options,
            "outcome": classify(exit_code, report or {}, options, result.exists(), is_timed_out),
            "exit_code": exit_code, "seconds": round(seconds, 3), "peak_memory_mb": round(memory, 1),
            "report": report, "messages": errors.decode(errors="replace")[-MESSAGE_LIMIT:],
            "digest": hashlib.sha256(result.read_bytes()).hexdigest() if result.exists() else None}
        if arguments.judge:
            record["judgement"] = (judge(arguments.judge, arguments.mesh, result, arguments.time_limit)
                                   if result.exists() else None)
        if arguments.keep and result.exists():
            pathlib.Path(arguments.keep).parent.mkdir(parents=True, exist_ok=True)
            shutil.move(result, arguments.keep)
        return record


def append(file, line):
    """In one piece, even if others append at the same time, and after a line that was left unfinished."""
    with open(file, "ab+") as output:
        fcntl.flock(output, fcntl.LOCK_EX)
        size = output.seek(0, os.SEEK_END)
        if size > 0:
            output.seek(size - 1)
            if output.read(1) != b"\n":
                line = b"\n" + line
        output.write(line)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program unwrap")
    parser.add_argument("mesh")
    parser.add_argument("--time-limit", type=float, default=600, metavar="SECONDS", help="default: %(default)s")
    parser.add_argument("--memory-limit", type=int, default=0, metavar="MB",
                        help="of address space; default: none")
    parser.add_argument("--results", metavar="FILE", help="append the line there instead of printing it")
    parser.add_argument("--keep", metavar="FILE", help="where to keep the mesh with texture coordinates")
    parser.add_argument("--judge", metavar="PROGRAM",
                        help="called with the mesh and the result; prints a JSON object")
    parser.add_argument("options", nargs="*", help="of unwrap, after --")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    line = (json.dumps(run_mesh(arguments, arguments.options)) + "\n").encode()
    if arguments.results:
        append(arguments.results, line)
    else:
        sys.stdout.buffer.write(line)


if __name__ == "__main__":
    main()
