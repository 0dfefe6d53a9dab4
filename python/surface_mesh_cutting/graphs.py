# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steiner trees."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional, cast

import numpy as np

from . import _arrays, _extension
from .errors import Finding, InputError
from .options import INT_MAX, RunOptions, choice, integer, read, real, takes
from .results import SteinerTree, make

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack

METHODS = ("best", "exact", "local_search", "greedy", "shortest_path_heuristic", "metric_closure")


@takes(RunOptions)
def steiner_tree(edges: ArrayLike, weights: ArrayLike, terminals: ArrayLike, *, number_of_vertices: Optional[int] = None,
                 method: Literal["best", "exact", "local_search", "greedy", "shortest_path_heuristic",
                                 "metric_closure"] = "best",
                 minimum_length_decrease: float = 0, maximum_number_of_states: int = 20_000_000,
                 **options: Unpack[RunOptions]) -> SteinerTree:
    """Find a short or shortest tree in an undirected graph that connects some of its vertices.

    The tree has no cycle, and all its leaves are terminals. Ctrl-C ends the run with the best tree so far;
    `progress` is not called.

    Parameters
    ----------
    edges : array_like of int, shape (m, 2)
        The two vertices of each edge, from 0. Parallel edges and self loops may occur.
    weights : array_like of float, shape (m,)
        The weight of each edge: finite and not negative.
    terminals : array_like of int, shape (k,)
        The vertices to connect; they may be repeated.
    number_of_vertices : int, optional
        By default, one more than the highest vertex that is mentioned.
    method : {"best", "exact", "local_search", "greedy", "shortest_path_heuristic", "metric_closure"}
        ``"best"``: a shortest tree if the budget suffices, otherwise the best one found, with a lower bound. ``"exact"``: the
        same, but its status is ``"bound_not_reached"`` without a proof. The others are heuristics, from good to fast.
    minimum_length_decrease : float
        What makes an auxiliary point worth adding, for ``"greedy"`` only.
    maximum_number_of_states : int
        The budget of the exact search, of about 50 bytes each.

    Returns
    -------
    SteinerTree

    Raises
    ------
    InputError
        With ``"terminals_not_connected"``; or with ``"wrong_parameter"`` and, in `Error.elements`, the edges with an invalid
        weight or vertex.
    TypeError, ValueError
        An argument has the wrong type, shape or range.
    """
    pairs = _arrays.edges("edges", edges)
    costs = _arrays.vector("weights", _arrays.numbers("weights", weights), len(pairs))
    ends = _arrays.vector("terminals", _arrays.indices("terminals", terminals))
    highest = max(pairs.max(initial=-1), ends.max(initial=-1))
    number = int(highest) + 1 if number_of_vertices is None else integer(0, INT_MAX)("number_of_vertices", number_of_vertices)
    if max(number, 2 * len(pairs)) > INT_MAX:
        raise ValueError("the graph is too large")
    _refuse_if(~(np.isfinite(costs) & (costs >= 0)), "weights that are negative, infinite or not a number")
    _refuse_if(((pairs < 0) | (pairs >= number)).any(axis=1), "edges with a vertex that does not exist")
    if np.any((ends < 0) | (ends >= number)):
        raise ValueError(f"terminals must be from 0 to {number - 1}")
    call = {"edges": pairs, "weights": costs, "terminals": ends, "number_of_vertices": number,
            "method": choice(*METHODS)("method", method),
            "minimum_length_decrease": real("minimum_length_decrease", minimum_length_decrease),
            "maximum_number_of_states": integer(0, 2**63 - 1)("maximum_number_of_states", maximum_number_of_states),
            **read(steiner_tree, RunOptions, options)}
    return cast(SteinerTree, make(SteinerTree, _extension.connect_terminals(call)))


def _refuse_if(is_wrong: np.ndarray, message: str) -> None:
    if is_wrong.any():
        raise InputError(Finding("wrong_parameter", message, "edges", np.flatnonzero(is_wrong)))
