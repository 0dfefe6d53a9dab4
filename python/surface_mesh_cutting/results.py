# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the functions return."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Optional

import numpy as np

from .errors import Finding, error_of, to_finding

Floats = np.ndarray[Any, np.dtype[np.float64]]
Indices = np.ndarray[Any, np.dtype[np.int64]]


@dataclass(frozen=True, eq=False)
class Interpretation:
    """What in a mesh is not a plain surface, and was read as one.

    Attributes
    ----------
    what : str
        ``"non_manifold_edges"``, ``"non_manifold_vertices"``, ``"reoriented_faces"``, ``"degenerate_faces"``,
        ``"duplicate_faces"``, ``"welded_vertices"``, ``"non_orientable_edges"``, ``"repeated_corners"`` or
        ``"divided_faces"``.
    elements : numpy.ndarray of int64
        Indices of points or faces, of shape (k,), or pairs of points, of shape (k, 2).
    """

    what: str
    elements: Indices


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """What all results tell.

    Attributes
    ----------
    status : {"ok", "stopped", "bound_not_reached"}
        How the call ended.
    message : str
        One line about it; empty if all is well.
    stopped : bool
        Whether Ctrl-C, the time limit or the progress callback ended the run: the result is the best so far.
    """

    status: str
    message: str
    stopped: bool

    def __repr__(self) -> str:
        values = [(field.name, getattr(self, field.name)) for field in fields(self)]
        shown = [f"{name}=<array {value.shape}>" if isinstance(value, np.ndarray) else f"{name}={value!r}"
                 for name, value in values]
        return f"{type(self).__name__}({', '.join(shown)})"


@dataclass(frozen=True, eq=False, repr=False)
class SurfaceResult(Result):
    """What is found about a surface.

    Attributes
    ----------
    warnings : tuple of Finding
        What was handled but should be known, such as isolated points.
    interpreted : tuple of Interpretation
        What is not a plain surface.
    """

    warnings: tuple[Finding, ...]
    interpreted: tuple[Interpretation, ...]


@dataclass(frozen=True, eq=False, repr=False)
class FeatureResult(SurfaceResult):
    """The feature points of a surface.

    Attributes
    ----------
    components, genus, borders : int
        Of the surface: its connected components, the sum of their genera, its border loops.
    feature_points : numpy.ndarray of int64, shape (k,)
        Points that a cut must reach so that the surface flattens with low distortion.
    number_of_candidates : int
        Local maximizers of distortion among which most of them were found.
    bounding_box_diagonal : float
        In units of the mesh.
    seconds, cpu_seconds : dict of str to float
        Wall time, and processor time of all threads, in ``"candidates"``, ``"filter"``, ``"connect"``, ``"refine"``,
        ``"parameterize"``, ``"packing"``, and in ``"total"``.
    """

    components: int
    genus: int
    borders: int
    feature_points: Indices
    number_of_candidates: int
    bounding_box_diagonal: float
    seconds: dict[str, float]
    cpu_seconds: dict[str, float]


@dataclass(frozen=True, eq=False, repr=False)
class CutResult(FeatureResult):
    """A cut that leaves only disks. Lengths are in units of the mesh.

    Attributes
    ----------
    cut_edges : numpy.ndarray of int64, shape (k, 2)
        The edges of the cut, ordered, each as two points, the lower one first. Borders are open already and no part of it.
    cut_length : float
        Their total length.
    cut_cost : float
        Their total weight; the length unless edges have weights.
    lower_bound : float or None
        No cut through the same feature points is shorter; `None` if no bound was computed.
    is_optimal : bool or None
        Whether no such cut is shorter.
    number_of_auxiliary_points : int
        Branch points that the connection added.
    trade_offs : numpy.ndarray of float64, shape (k, 3)
        Length, cost and average distortion of the cuts that were considered, from cheap to expensive.
    symmetry : tuple or None
        The normal of the plane of symmetry, the product of the normal with points of the plane, and the share of the points
        of the surface that it matches; `None` if there is no such plane, or if it was not asked for.
    """

    cut_edges: Indices
    cut_length: float
    cut_cost: float
    lower_bound: Optional[float]
    is_optimal: Optional[bool]
    number_of_auxiliary_points: int
    trade_offs: Floats
    symmetry: Optional[tuple[tuple[float, float, float], float, float]]


@dataclass(frozen=True, eq=False, repr=False)
class UnwrapResult(CutResult):
    """A cut and a map without flips.

    Attributes
    ----------
    uv : numpy.ndarray of float64, shape (u, 2)
        The UVs. Corners share one unless a cut lies between them.
    uv_faces : numpy.ndarray of int64
        The UV of each corner, an index into `uv`; of the shape of the faces as they were given.
    uv_points : numpy.ndarray of int64, shape (u,)
        The point that each UV belongs to: ``points[uv_points]`` are the points of the opened surface.
    average_distortion, largest_face_distortion : float
        The symmetric Dirichlet energy of the map at the scale of the surface: its average by area, and that of the worst
        face. 4 is ideal.
    distortion_quantiles : dict of float to float
        For shares of the area, 0.5, 0.9, 0.99, 0.999 and 1, the least energy that the faces of so much area do not exceed.
    charts_distortion : list of dict
        For each chart, the mean and the largest energy of its faces, and their number: ``mean``, ``max``, ``faces``.
    number_of_charts : int
        Parts of the surface that are connected across edges not cut.
    uv_scale : float
        UV units per unit of length of the mesh, the same for all charts.
    fill : float or None
        The share of the unit square that the charts cover, the mean of several pages; `None` with ``uv_scale="surface"``.
    page_fills : tuple of float
        The same of each page. Page ``i`` is the square that begins at ``(i % 10, i // 10)``.
    """

    uv: Floats
    uv_faces: Indices
    uv_points: Indices
    average_distortion: float
    largest_face_distortion: float
    distortion_quantiles: dict[float, float]
    charts_distortion: list[dict[str, Any]]
    number_of_charts: int
    uv_scale: float
    fill: Optional[float]
    page_fills: tuple[float, ...]

    @property
    def corner_uv(self) -> Floats:
        """The UV of each corner: of the shape of the faces as they were given, with two columns more."""
        return self.uv[self.uv_faces]


@dataclass(frozen=True, eq=False, repr=False)
class ConnectionResult(SurfaceResult):
    """A cut through given points; see `CutResult`, but `cut_length` also counts mandatory edges, and `lower_bound` is one on
    the weight."""

    cut_edges: Indices
    cut_length: float
    lower_bound: float
    is_optimal: bool
    number_of_auxiliary_points: int


@dataclass(frozen=True, eq=False, repr=False)
class HandlesResult(SurfaceResult):
    """Loops after which a surface has genus 0.

    Attributes
    ----------
    cut_edges : numpy.ndarray of int64, shape (k, 2)
        The edges of all loops and the mandatory ones, ordered.
    cut_length : float
        Their length, in units of the mesh, without border edges and mandatory edges.
    loops : tuple of numpy.ndarray of int64
        One per handle: the points that it passes, in order. The last one is connected to the first one.
    """

    cut_edges: Indices
    cut_length: float
    loops: tuple[Indices, ...]


@dataclass(frozen=True, eq=False, repr=False)
class PackingResult(Result):
    """Charts in the unit square.

    Attributes
    ----------
    corner_uv : numpy.ndarray of float64
        The UV of each corner, of the shape in which they were given.
    scale : float
        Length of an edge in the unit square over its length before, the same for all.
    fill : float
        The share of the unit square that the charts cover, the mean of several pages.
    number_of_charts : int
    page_fills : tuple of float
        The share of each page. Page ``i`` is the square that begins at ``(i % 10, i // 10)``.
    """

    corner_uv: Floats
    scale: float
    fill: float
    number_of_charts: int
    page_fills: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Certificate:
    """Whether a map is proven to be valid; `True` as a condition if so.

    Attributes
    ----------
    is_valid : bool
    finding : Finding
        The defects and where they are: ``"not_cut_to_disks"`` or ``"not_certified"``; ``"ok"`` if there is none.
    """

    is_valid: bool
    finding: Finding

    def __bool__(self) -> bool:
        return self.is_valid


@dataclass(frozen=True, eq=False, repr=False)
class SteinerTree(Result):
    """A tree that connects terminals in a graph.

    Attributes
    ----------
    edges : numpy.ndarray of int64, shape (k,)
        Which edges of the list form the tree, increasing.
    length : float
        The sum of their weights.
    lower_bound : float
        No tree is shorter, up to rounding; 0 for methods without a bound.
    is_optimal : bool
        Whether it is proven that no tree is shorter.
    number_of_auxiliary_points : int
        Vertices at which the tree branches and that are no terminals.
    """

    edges: Indices
    length: float
    lower_bound: float
    is_optimal: bool
    number_of_auxiliary_points: int


def make(kind: type, found: dict[str, Any], **others: Any) -> Any:
    """A result of this kind from what the extension found, or the exception that says why there is none."""
    finding = to_finding(found["finding"])
    if not found["has_result"]:
        if found["was_interrupted"]:
            raise KeyboardInterrupt
        raise error_of(finding)
    values = {**found, **others, "status": finding.status, "message": finding.message,
              "stopped": found["was_interrupted"] or finding.status == "stopped",
              "warnings": tuple(map(to_finding, found.get("warnings", ()))),
              "interpreted": tuple(Interpretation(**reading) for reading in found.get("interpreted", ()))}
    return kind(**{field.name: values[field.name] for field in fields(kind)})
