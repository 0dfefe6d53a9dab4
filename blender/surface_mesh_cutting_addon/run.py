# SPDX-License-Identifier: GPL-3.0-or-later
"""A process of the program `unwrap`."""

import json
import re
import signal
import subprocess

from . import command

NO_REPORT = {"status": "failed", "warnings": [], "witness": None, "interpreted": []}


class Run:
    """Starts the program in `folder`, where its files are. Never waits for it.

    Raises `OSError` if the program cannot be started."""

    def __init__(self, program, arguments, folder):
        self.folder = folder
        self._messages = folder / "messages.txt"
        with open(self._messages, "wb") as messages:
            self._process = subprocess.Popen([program, *arguments], cwd=folder, stdin=subprocess.DEVNULL,
                                             stdout=subprocess.DEVNULL, stderr=messages)

    def is_running(self):
        return self._process.poll() is None

    def progress(self):
        """How far the program is, such as "42 % filtering"; empty at the start."""
        lines = re.findall(r"^(\d+) (.+)\n", self._messages.read_text(errors="replace"), re.MULTILINE)
        return "{} % {}".format(*lines[-1]) if lines else ""

    def stop(self):
        """Lets the program end soon and write the best result that it has."""
        self._process.send_signal(signal.SIGINT)

    def kill(self):
        """Ends the program now."""
        self._process.kill()
        self._process.wait()

    def exit_code(self):
        """What the process returned; waits for its end. Negative if a signal ended it."""
        return self._process.wait()

    def report(self):
        """The report of a run that has ended. One without a report has crashed, or is another program."""
        try:
            return json.loads((self.folder / command.REPORT).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            lines = self._messages.read_text(errors="replace").strip().splitlines()
            return {**NO_REPORT, "message": lines[-1] if lines else f"exit code {self.exit_code()} without a message"}

    def layout_file(self):
        """The mesh with texture coordinates, or None."""
        path = self.folder / command.LAYOUT
        return path if path.exists() else None
