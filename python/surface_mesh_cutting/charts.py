# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packing and certificates of maps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional, cast

from . import _arrays, _extension
from .errors import error_of, to_finding
from .options import EFFORTS, INT_MAX, SYMMETRIES, SurfaceOptions, atlas, choice, flag, integer, read, real, rotation, takes
from .results import Certificate, PackingResult, make

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack


@takes(SurfaceOptions)
def pack_charts(points: ArrayLike, faces: ArrayLike, corner_uv: ArrayLike, offsets: Optional[ArrayLike] = None, *,
                margin: float = 2, texture_size: int = 1024, bijective: bool = True,
                effort: Literal["fast", "default", "best"] = "default",
                rotate: Optional[Literal["any", "quarter", "none", "upright"]] = None,
                symmetry: Literal["off", "auto", "x", "y", "z"] = "off",
                texels_per_unit: Optional[float] = None, pages: Optional[int] = None,
                **options: Unpack[SurfaceOptions]) -> PackingResult:
    """Move charts into the unit square: turn and translate each one, and scale all by the same factor.

    The surface is cut where the UVs of neighbors differ. All triangles must be counterclockwise. Ctrl-C is handled as by
    `unwrap`; `progress` is not called.

    Parameters
    ----------
    points, faces, offsets
        The surface, as for `unwrap`.
    corner_uv : array_like of float, shape (m, k, 2) or (c, 2)
        The UV of each corner.
    margin, texture_size
        As for `unwrap`.
    rotate : {"any", "quarter", "none", "upright"}, optional
        How charts may be turned: by any angle, by quarter turns from where they are aligned with the axes, or not at all;
        "upright": such that the axes of symmetric charts are vertical. By default, aligned charts are taken where that costs at
        most 3 % of what is filled.
    symmetry : {"off", "auto", "x", "y", "z"}
        As for `unwrap`: a plane that mirrors the surface and its seams. Charts that are mirrored then lie side by side.
    texels_per_unit : float, optional
        The number of texels of a unit of length of the given UVs, on as many pages as that takes. By default, as many as fit.
    pages : int, optional
        The number of pages to fill at one scale, by default one; with `texels_per_unit`, the largest one allowed.
    bijective : bool
        Whether no chart may overlap itself, either.
    effort : {"fast", "default", "best"}
        How long to look for a larger scale: "fast" a tenth as long as "default", "best" four times as long.

    Returns
    -------
    PackingResult

    Raises
    ------
    InputError
        Also with ``"infeasible_constraints"``, where the margins leave no room for so many charts.
    ComputationError
        With ``"not_certified"`` and the faces that are not counterclockwise or overlap.
    TypeError, ValueError
        An argument has the wrong type, shape or range.
    """
    call, shape = _arrays.surface(points, faces, offsets)
    call["corner_uv"] = _arrays.uvs_of_corners(corner_uv, shape)
    call.update(read(pack_charts, SurfaceOptions, options), bijective=flag("bijective", bijective),
                margin=real("margin", margin), texture_size=integer(1, INT_MAX)("texture_size", texture_size),
                effort=choice(*EFFORTS)("effort", effort), symmetry=choice(*SYMMETRIES)("symmetry", symmetry),
                **rotation(rotate), **atlas(texels_per_unit, pages))
    found = _extension.pack_charts(call)
    if found["has_result"]:
        found["corner_uv"] = found["corner_uv"].reshape(*shape, 2)
    return cast(PackingResult, make(PackingResult, found))


@takes(SurfaceOptions)
def certify_unwrap(points: ArrayLike, faces: ArrayLike, corner_uv: ArrayLike, offsets: Optional[ArrayLike] = None, *,
                   bijective: bool = True, **options: Unpack[SurfaceOptions]) -> Certificate:
    """Prove that a surface is unwrapped: cut where the UVs of neighbors differ, it consists of disks, and the map takes each
    triangle to a strictly counterclockwise one. All decisions are exact. The proof takes one thread and cannot be stopped.

    Parameters
    ----------
    points, faces, offsets
        The surface, as for `unwrap`.
    corner_uv : array_like of float, shape (m, k, 2) or (c, 2)
        The UV of each corner.
    bijective : bool
        Whether to prove, too, that no two triangles overlap.

    Returns
    -------
    Certificate
        `False` as a condition, with the faces concerned, if the map is not valid.

    Raises
    ------
    InputError
        The mesh cannot be served.
    TypeError, ValueError
        An argument has the wrong type or shape.
    """
    call, shape = _arrays.surface(points, faces, offsets)
    call["corner_uv"] = _arrays.uvs_of_corners(corner_uv, shape)
    call.update(read(certify_unwrap, SurfaceOptions, options), bijective=flag("bijective", bijective))
    found = _extension.certify(call)
    if found["was_interrupted"]:
        raise KeyboardInterrupt
    finding = to_finding(found["finding"])
    if finding.status not in ("ok", "not_certified", "not_cut_to_disks"):
        raise error_of(finding)
    return Certificate(finding.status == "ok", finding)
