# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts through given points, and cuts of handles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, cast

from . import _arrays, _extension
from .options import ConnectionOptions, ConstraintOptions, read, takes
from .results import ConnectionResult, HandlesResult, make

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack


@takes(ConnectionOptions)
def connect_points(points: ArrayLike, faces: ArrayLike, terminals: ArrayLike, offsets: Optional[ArrayLike] = None,
                   **options: Unpack[ConnectionOptions]) -> ConnectionResult:
    """Connect points of a surface by a short cut that leaves only disks.

    Surfaces with handles lose these first. The cut also connects borders: each counts as one point. A part that is
    already a disk and contains no terminal is not cut further. Ctrl-C is handled as by `unwrap`.

    Parameters
    ----------
    points, faces, offsets
        The surface, as for `unwrap`.
    terminals : array_like of int, shape (k,)
        The points to connect: at least two on each closed component of genus 0.

    Returns
    -------
    ConnectionResult

    Raises
    ------
    InputError, StoppedError, TypeError, ValueError
        As `unwrap` does.
    """
    call, _ = _arrays.surface(points, faces, offsets)
    call["terminals"] = _arrays.vector("terminals", _arrays.indices("terminals", terminals))
    call.update(read(connect_points, ConnectionOptions, options))
    return cast(ConnectionResult, make(ConnectionResult, _extension.connect(call)))


@takes(ConstraintOptions)
def cut_handles(points: ArrayLike, faces: ArrayLike, offsets: Optional[ArrayLike] = None,
                **options: Unpack[ConstraintOptions]) -> HandlesResult:
    """Find short loops that cut the handles of a surface: opened along them, each component stays connected and has genus 0.

    A run that is stopped has no result.

    Parameters
    ----------
    points, faces, offsets
        The surface, as for `unwrap`.

    Returns
    -------
    HandlesResult

    Raises
    ------
    InputError, StoppedError, TypeError, ValueError
        As `unwrap` does.
    """
    call, _ = _arrays.surface(points, faces, offsets)
    call.update(read(cut_handles, ConstraintOptions, options))
    found = _extension.find_handles(call)
    return cast(HandlesResult, make(HandlesResult, found, loops=tuple(found["loops"])))
