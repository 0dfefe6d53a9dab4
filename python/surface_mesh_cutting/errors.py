# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is found about a mesh, and the exceptions that say why there is no result."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

_OF_INPUT = {"empty_mesh", "not_triangulated", "non_manifold", "invalid_point", "wrong_parameter",
             "infeasible_constraints", "terminals_not_connected"}


@dataclass(frozen=True, eq=False)
class Finding:
    """Something about a mesh, and where.

    Attributes
    ----------
    status : str
        ``"ok"`` for a warning, else why the call ended; see `Error`.
    message : str
        One line for a human reader.
    kind : {"vertices", "edges", "faces", ""}
        What the elements are; empty if there are none.
    elements : numpy.ndarray
        Indices of points or faces, of shape (k,), or pairs of points, of shape (k, 2).
    """

    status: str
    message: str
    kind: str
    elements: np.ndarray[Any, np.dtype[np.int64]]

    def __str__(self) -> str:
        return self.message


class Error(RuntimeError):
    """There is no result. The subclasses tell whose fault that is.

    Attributes
    ----------
    status : str
        The reason: a status code of the C++ library in lower case, such as ``"non_manifold"``.
    kind, elements
        Where, as in `Finding`.
    """

    def __init__(self, finding: Finding) -> None:
        super().__init__(finding.message)
        self.status = finding.status
        self.kind = finding.kind
        self.elements = finding.elements

    def __reduce__(self) -> tuple[Any, ...]:
        """Other processes get the finding, from which the exception is made anew, and what else it carries."""
        return type(self), (Finding(self.status, str(self), self.kind, self.elements),), self.__dict__


class InputError(Error, ValueError):
    """The mesh or what is asked of it cannot be served: ``"empty_mesh"``, ``"not_triangulated"``, ``"non_manifold"``,
    ``"invalid_point"``, ``"wrong_parameter"``, ``"infeasible_constraints"`` or ``"terminals_not_connected"``."""


class ComputationError(Error):
    """No valid result was found: ``"numerical_failure"``, ``"not_certified"`` or ``"not_cut_to_disks"``."""


class StoppedError(Error):
    """The time limit or the progress callback ended the run before there was a result: ``"stopped"``."""


def to_finding(found: dict[str, Any]) -> Finding:
    return Finding(found["status"], found["message"], found["kind"], found["elements"])


def error_of(finding: Finding) -> Error:
    if finding.status == "stopped":
        return StoppedError(finding)
    return InputError(finding) if finding.status in _OF_INPUT else ComputationError(finding)
