# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts, feature points, and maps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Optional, cast

from . import _arrays, _extension
from .options import INT_MAX, CuttingOptions, atlas, choice, flag, integer, read, real, rotation, takes
from .results import CutResult, FeatureResult, UnwrapResult, make

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack


@takes(CuttingOptions)
def unwrap(points: ArrayLike, faces: ArrayLike, offsets: Optional[ArrayLike] = None, *, bijective: bool = True,
           uv_scale: Literal["unit", "surface"] = "unit", margin: float = 2, texture_size: int = 1024,
           rotate: Optional[Literal["any", "quarter", "none", "upright"]] = None,
           texels_per_unit: Optional[float] = None, pages: Optional[int] = None,
           **options: Unpack[CuttingOptions]) -> UnwrapResult:
    """Cut a surface and flatten it, without flips and with low isometric distortion.

    Faces are polygons with any number of corners and need not form a manifold: what they are read as is in
    `UnwrapResult.interpreted`. Nothing is repaired or changed. The result is the same, to the last bit, for any number
    of threads, and the same as that of the C++ function ``unwrap_polygon_soup()``.

    The interpreter's lock is released during the run. Ctrl-C ends it: the call returns the best result so far, with
    `UnwrapResult.stopped`, or raises `KeyboardInterrupt` if there is none yet. A second Ctrl-C raises
    `KeyboardInterrupt` in any case, once the run has ended.

    Parameters
    ----------
    points : array_like of float, shape (n, 3)
        The points, in any unit. Contiguous `float64` is not copied.
    faces : array_like of int, shape (m, k) or (c,)
        The points of each face, from 0; contiguous `int64` is not copied. Faces with different numbers of corners come one
        after the other in a flat array, with `offsets`.
    offsets : array_like of int, shape (m + 1,), optional
        Where the corners of each face begin in the flat array; the last one is its length.
    bijective : bool
        Whether no two triangles of the map may overlap. With ``faithful=True``, they may anyway.
    uv_scale : {"unit", "surface"}
        Whether charts are packed into the unit square, at one scale, or stay as large as on the surface.
    margin : float
        The least distance of charts from each other and from the border of the square, in texels.
    texture_size : int
        The number of texels along a side of the square.
    rotate : {"any", "quarter", "none", "upright"}, optional
        How charts may be turned in the square: by any angle, by quarter turns from where they are aligned with the axes, or not
        at all from there; "upright": such that the axes of symmetric charts are vertical. By default, aligned charts are taken
        where that costs at most 3 % of what is filled.
    texels_per_unit : float, optional
        The number of texels of a unit of length, on as many pages as that takes. By default, as many as fit.
    pages : int, optional
        The number of pages to fill at one scale, by default one; with `texels_per_unit`, the largest one allowed.

    Returns
    -------
    UnwrapResult

    Raises
    ------
    InputError
        The mesh or the constraints cannot be served; `Error.elements` says where.
    ComputationError
        No valid map was found.
    StoppedError
        The time limit ended the run before there was a result.
    TypeError, ValueError
        An argument has the wrong type, shape or range.

    Notes
    -----
    Solving sparse linear systems dominates the time: for n points, each takes O(n^1.5) on usual meshes.
    """
    call, shape = _arrays.surface(points, faces, offsets)
    call.update(read(unwrap, CuttingOptions, options), output="map")
    call["bijective"] = flag("bijective", bijective) and not call.get("faithful", False)
    turns = rotation(rotate) | atlas(texels_per_unit, pages)
    if choice("unit", "surface")("uv_scale", uv_scale) == "unit":
        call.update(turns, margin=real("margin", margin), texture_size=integer(1, INT_MAX)("texture_size", texture_size))
    found = _cut(call)
    return cast(UnwrapResult, make(UnwrapResult, found, uv_faces=found["uv_corners"].reshape(shape)
                                   if found["has_result"] else None))


@takes(CuttingOptions)
def greedy_cut(points: ArrayLike, faces: ArrayLike, offsets: Optional[ArrayLike] = None,
               **options: Unpack[CuttingOptions]) -> CutResult:
    """Find a short cut that leaves only disks, which flatten with low isometric distortion.

    Parameters, exceptions, and what Ctrl-C does are those of `unwrap`.

    Returns
    -------
    CutResult
    """
    call, _ = _arrays.surface(points, faces, offsets)
    call.update(read(greedy_cut, CuttingOptions, options), output="cut")
    return cast(CutResult, make(CutResult, _cut(call)))


@takes(CuttingOptions)
def detect_feature_points(points: ArrayLike, faces: ArrayLike, offsets: Optional[ArrayLike] = None,
                          **options: Unpack[CuttingOptions]) -> FeatureResult:
    """Find the points that a cut must reach so that the surface flattens with low isometric distortion.

    Parameters and exceptions are those of `unwrap`. A run that is stopped has no result.

    Returns
    -------
    FeatureResult
    """
    call, _ = _arrays.surface(points, faces, offsets)
    call.update(read(detect_feature_points, CuttingOptions, options), output="features")
    found = _cut(call)
    found["has_result"] = found["finding"]["status"] == "ok"
    return cast(FeatureResult, make(FeatureResult, found))


def _cut(call: dict[str, Any]) -> dict[str, Any]:
    # The paper connects greedily.
    call.setdefault("connection", "greedy" if call.get("faithful") else "best")
    return _extension.cut(call)
