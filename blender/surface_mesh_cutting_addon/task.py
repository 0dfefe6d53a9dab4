# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of the program, one after the other."""

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import command, files, seams
from .run import Run
from .surface import Surface

POLLING_TIME = 0.05  # seconds


@dataclass(frozen=True, eq=False)
class Result:
    """What a run has found out about a surface."""

    surface: Surface
    exit_code: int
    report: dict
    corner_uvs: np.ndarray = None  # n x 2; None if there is no layout
    is_cut: np.ndarray = None  # by edge


def _result(surface, run):
    layout = run.layout_file()
    if layout is None:
        return Result(surface, run.exit_code(), run.report())
    texture_points, corner_vertices, corner_points = files.read_obj(layout)
    if not np.array_equal(corner_vertices, surface.corner_vertices):
        raise RuntimeError("the program returned another mesh")
    return Result(surface, run.exit_code(), run.report(), texture_points[corner_points],
                  seams.cut_edges(surface, corner_points))


class Task:
    """Unwraps surfaces; `advance()` is to be called again and again, and `close()` at the end.

    The constructor raises `command.Refusal`, and `OSError` if the program cannot be started."""

    def __init__(self, surfaces, settings, program, threads, parent_folder):
        self.results = []
        self._total = len(surfaces)
        self._program = program
        self._folder = tempfile.TemporaryDirectory(prefix="unwrap_", dir=parent_folder)
        self._run = None
        try:
            self._waiting = [self._prepare(i, surface, settings, threads) for i, surface in enumerate(surfaces)]
            self._start_next()
        except BaseException:
            self.close()
            raise

    def _prepare(self, number, surface, settings, threads):
        folder = Path(self._folder.name, str(number))
        folder.mkdir()
        return surface, folder, command.prepare(surface, settings, threads, folder)

    def _start_next(self):
        self._surface, folder, arguments = self._waiting.pop(0)
        self._run = Run(self._program, arguments, folder)

    def advance(self):
        """Takes the result of a run that has ended and starts the next; returns whether there is more to do."""
        if self._run is not None and not self._run.is_running():
            self.results.append(_result(self._surface, self._run))
            self._run = None
            if self._waiting:
                self._start_next()
        return self._run is not None

    def progress(self):
        """How far the task is, in words."""
        number = f"{len(self.results) + 1} of {self._total}: " if self._total > 1 else ""
        return number + (self._run.progress() if self._run is not None else "")

    def stop(self):
        """Ends soon, with the best result that the present run has. Those that did not start are left out."""
        self._waiting.clear()
        if self._run is not None:
            self._run.stop()

    def close(self):
        """Ends the present run at once and removes all files."""
        if self._run is not None:
            self._run.kill()
            self._run = None
        self._folder.cleanup()
