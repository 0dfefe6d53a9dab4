# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads arrays. Contiguous ones of 64-bit numbers are not copied."""

from __future__ import annotations

from typing import Any

import numpy as np

# An edge: two points.
_PAIR = 2


def _refuse_masks(name: str, value: Any) -> None:
    if np.ma.is_masked(value):
        raise TypeError(f"{name} has masked entries: remove or fill them")


def numbers(name: str, value: Any) -> np.ndarray[Any, np.dtype[np.float64]]:
    """`value` as an array of `float64`."""
    _refuse_masks(name, value)
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} must be an array of real numbers, not of {array.dtype}")
    return np.ascontiguousarray(array, np.float64)


def indices(name: str, value: Any) -> np.ndarray[Any, np.dtype[np.int64]]:
    """`value` as an array of `int64`."""
    _refuse_masks(name, value)
    array = np.asarray(value)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError(f"{name} must be an array of integers, not of {array.dtype}")
    return np.ascontiguousarray(array, np.int64)


def _refuse_shape(name: str, expected: str, array: np.ndarray[Any, Any]) -> None:
    raise ValueError(f"{name} must have shape {expected}, not {array.shape}")


def rows(name: str, array: np.ndarray[Any, Any], columns: int) -> np.ndarray[Any, Any]:
    """Checks that an array has this number of columns; an empty list will do."""
    if array.size == 0 and array.ndim <= 2:
        return array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        _refuse_shape(name, f"(n, {columns})", array)
    return array


def vector(name: str, array: np.ndarray[Any, Any], size: int | None = None) -> np.ndarray[Any, Any]:
    if array.ndim != 1 or size not in (None, array.size):
        _refuse_shape(name, "(n,)" if size is None else f"({size},)", array)
    return array


def edges(name: str, value: Any) -> np.ndarray[Any, np.dtype[np.int64]]:
    return rows(name, indices(name, value), _PAIR)


def polygons(faces: Any, offsets: Any) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any], tuple[int, ...]]:
    """The corners of all polygons, where those of each begin, and the shape of what has an entry for each corner."""
    try:
        corners = indices("faces", faces)
    except ValueError:
        raise ValueError("faces have different numbers of corners; give all corners one after the other, "
                         "and offsets") from None
    if offsets is None:
        if corners.size == 0 and corners.ndim == 1:
            corners = corners.reshape(0, 3)
        if corners.ndim != 2:
            _refuse_shape("faces", "(m, k), or (c,) with offsets", corners)
        number, size = corners.shape
        return corners, np.arange(number + 1, dtype=np.int64) * size, corners.shape
    if np.ndim(offsets) == 0:
        raise TypeError(f"offsets must be an array, not {offsets!r}: give options by name, as in time_limit=10")
    vector("faces", corners)
    ends = vector("offsets", indices("offsets", offsets))
    if ends.size == 0 or ends[0] != 0 or ends[-1] != corners.size or np.any(ends[1:] < ends[:-1]):
        raise ValueError(f"offsets must increase from 0 to {corners.size}, the number of corners")
    return corners, ends, corners.shape


def surface(points: Any, faces: Any, offsets: Any) -> tuple[dict[str, Any], tuple[int, ...]]:
    """What the extension needs of a mesh, and the shape of what has an entry for each corner."""
    corners, ends, shape = polygons(faces, offsets)
    return {"points": rows("points", numbers("points", points), 3), "corners": corners, "offsets": ends}, shape


def uvs_of_corners(corner_uv: Any, shape: tuple[int, ...]) -> np.ndarray[Any, np.dtype[np.float64]]:
    array = numbers("corner_uv", corner_uv)
    if array.shape != (*shape, 2) and not (array.size == 0 and 0 in shape):
        _refuse_shape("corner_uv", str((*shape, 2)), array)
    return array
