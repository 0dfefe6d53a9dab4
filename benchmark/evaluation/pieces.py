"""Runs many commands, some at a time, and keeps what each printed: what is finished is not run again."""

import concurrent.futures
import dataclasses
import hashlib
import json
import pathlib
import signal
import subprocess
import sys
import time


@dataclasses.dataclass
class Outcome:
    """How a command ended: its exit code, or None if its time was up or it was not started."""
    exit_code: int | None = None
    output: str = ""
    seconds: float = 0.


def signature(command):
    return hashlib.sha256("\0".join(map(str, command)).encode()).hexdigest()


class Pieces:
    """Each piece is a file in the folder, named after its command. No command is started once
    `minutes` have passed; those left are run by the next call of the program."""

    def __init__(self, folder, jobs, time_limit, minutes):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.jobs, self.time_limit = jobs, time_limit
        self.deadline = time.monotonic() + 60 * minutes
        self.number_left = self.number_run = 0
        self.crashed = []  # commands

    def run(self, commands):
        """{key: Outcome} of {key: command}; the commands are started in this order."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            outcomes = dict(zip(commands, pool.map(self._run_one, commands.values())))
        self.crashed += [" ".join(map(str, commands[key])) for key, outcome in outcomes.items()
                         if outcome.exit_code is not None and outcome.exit_code < 0]
        return outcomes

    def _run_one(self, command):
        file = self.folder / f"{signature(command)}.json"
        if file.exists():
            outcome = Outcome(**json.loads(file.read_text())["outcome"])
            if outcome.exit_code is not None or outcome.seconds >= self.time_limit:
                return outcome  # not so if it may take longer now
        if time.monotonic() > self.deadline:
            self.number_left += 1
            return Outcome()
        outcome = self._execute(command)
        self.number_run += 1
        print(f"{outcome.seconds:7.1f} s  {' '.join(map(str, command))[:150]}", file=sys.stderr)
        unfinished = file.with_suffix(".part")
        unfinished.write_text(json.dumps({"command": list(map(str, command)), "outcome": dataclasses.asdict(outcome)}))
        unfinished.rename(file)
        return outcome

    def _execute(self, command):
        start = time.monotonic()
        with subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              stdin=subprocess.DEVNULL, text=True, errors="replace") as process:
            try:
                output, _ = process.communicate(timeout=self.time_limit)
                code = process.returncode
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                output, _ = process.communicate()
                code = None
        return Outcome(code, output, time.monotonic() - start)
