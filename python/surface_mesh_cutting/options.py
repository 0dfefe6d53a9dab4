# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The options that several functions share."""

from __future__ import annotations

import difflib
import inspect
import operator
from typing import TYPE_CHECKING, Any, Callable, Literal, Mapping, Optional, Tuple, TypedDict, TypeVar, Union

import numpy as np

from . import _arrays

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

EFFORTS = ("fast", "default", "best")
ROTATIONS = ("any", "quarter", "none", "upright")
SYMMETRIES = ("off", "auto", "x", "y", "z")
CONNECTIONS = ("best", "exact", "greedy", "shortest_path_heuristic", "metric_closure")


class RunOptions(TypedDict, total=False):
    """How a call is run. `None` stands for the default of any option.

    Parameters
    ----------
    threads : int, optional
        The number of threads; as many as there are processors by default. Results do not depend on it.
    time_limit : float, optional
        Seconds after which the run ends with the best result so far; no limit by default.
    progress : callable, optional
        Called as ``progress(phase, fraction)`` with the name of the phase that goes on (a key of `CutResult.seconds`, or "pack") and the
        share of the whole call that is done, an estimate from 0 to 1 that never decreases, at most 50 times a second, by the
        thread that called the function. The last one is 1 if all was done. If it returns `False`, the run ends as at a time limit; if it raises, the run ends and the exception passes.
    """

    threads: Optional[int]
    time_limit: Optional[float]
    progress: Optional[Callable[[str, float], Any]]


class SurfaceOptions(RunOptions, total=False):
    """How the surface is read.

    Parameters
    ----------
    weld : {"auto", "on", "off"} or bool
        Whether points at exactly the same place count as one; by default where (nearly) no two faces share a point (at
        most one corner in a hundred), and where pieces of at most ten faces on average meet at three quarters of their
        border edges or more, always two in opposite directions. `True` is "on", `False` is "off".
    weld_tolerance : float
        From 0 (default) to 0.01: points within this share of the diagonal of the bounding box count as one, too, also by
        way of others between them. "auto" is "on" then.
    strict : bool
        Whether to refuse what is otherwise interpreted: polygons, places that are not manifold, inconsistent
        orientation, degenerate and duplicate faces. Points are then not welded. Default: `False`.
    """

    weld: Union[Literal["auto", "on", "off"], bool]
    weld_tolerance: float
    strict: bool


class ConstraintOptions(SurfaceOptions, total=False):
    """What must, must not, or should rather be cut. Edges are pairs of points in any order.

    Parameters
    ----------
    mandatory_edges : array_like of int, shape (k, 2), optional
        Edges that are cut from the start. If they separate the surface, each part is treated on its own.
    forbidden_edges : array_like of int, shape (k, 2), optional
        Edges that must not be cut.
    edge_weights : tuple of array_like, shapes (k, 2) and (k,), optional
        Edges, and what it costs to cut each of them: a number that is not negative, or infinity. The others cost their
        length, in units of the mesh. Where an edge is listed twice, its last weight counts.
    """

    mandatory_edges: Optional[ArrayLike]
    forbidden_edges: Optional[ArrayLike]
    edge_weights: Optional[Tuple[ArrayLike, ArrayLike]]


class ConnectionOptions(ConstraintOptions, total=False):
    """How points are connected.

    Parameters
    ----------
    connection : {"best", "exact", "greedy", "shortest_path_heuristic", "metric_closure"}
        ``"exact"``: by a shortest tree; the status is ``"bound_not_reached"`` beyond the budget. ``"best"``: by a
        shortest tree within the budget, otherwise the best one found. The others are heuristics. Default: ``"best"``,
        and ``"greedy"`` with ``faithful=True``.
    maximum_number_of_states : int
        The budget of the search for a shortest tree, which counts steps so that results are reproducible.
        Default: 20,000,000.
    """

    connection: Literal["best", "exact", "greedy", "shortest_path_heuristic", "metric_closure"]
    maximum_number_of_states: int


class CuttingOptions(ConnectionOptions, total=False):
    """How a cut is found.

    Parameters
    ----------
    effort : {"fast", "default", "best"}
        How much work to spend on a short cut and, by `unwrap`, on packing the charts.
    maximum_average_distortion : float, optional
        An upper bound, greater than 4, on the area-averaged symmetric Dirichlet energy. The cut grows until the map keeps
        it; if none does, the status is ``"bound_not_reached"``. No bound by default.
    maximum_face_distortion : float, optional
        An upper bound, greater than 4, on the symmetric Dirichlet energy of each face. The map is flattened where faces
        exceed it, and the cut grows to those that still do. No bound by default.
    face_distortion_quantile : float, optional
        The share of the area, at most 1, whose faces keep that bound. 1 by default.
    maximum_chart_distortion : float, optional
        An upper bound, greater than 4, on the area-averaged energy of each chart. No bound by default.
    terminals : array_like of int, shape (k,), optional
        Points that the cut must pass through, unless they lie on a border.
    initial_cut : array_like of int, shape (k, 2), optional
        Edges of a cut to start from, such as seams drawn by hand. They need not stay.
    faithful : bool
        Whether to do what the paper says and nothing else. Default: `False`.
    minimum_distortion_decrease : float
        The decrease of the energy that makes a candidate a feature point. Default: 0.01.
    minimum_length_decrease : float
        The decrease of the length, in bounding box diagonals, that makes an auxiliary point worth adding, with
        ``faithful=True`` only; a tenth of it is the least of a cut whose removal is worth another map. Default: 0.01.
    minimum_area_ratio : float
        The share of the area that must lie far from the first cut and its maximizers. Default: 0.1.
    influence_threshold : float
        The scope, in average edge lengths, above which a candidate is a feature point from the outset. Default: 20.
    forbidden_radius : float
        The initial distance, in average edge lengths, of the second cut from the first one. Default: 10.
    seed : int
        From 0 to 4294967295, for drawing the start vertex. Default: 0.
    symmetry : {"off", "auto", "x", "y", "z"}
        The plane at which the cut is mirrored, if the surface is: the best one, or one across an axis, wherever it lies. If
        there is none, or no such cut, a warning says so. Mirrored charts lie side by side in the square. Default: ``"off"``.
    seam_smoothness : float
        Percent, up to 100, by which parts of the cut of a map may get longer to be straighter. Default: 1, and 0 with
        ``effort="fast"``, ``connection="exact"`` or ``faithful=True``.
    """

    effort: Literal["fast", "default", "best"]
    maximum_average_distortion: Optional[float]
    maximum_face_distortion: Optional[float]
    face_distortion_quantile: Optional[float]
    maximum_chart_distortion: Optional[float]
    terminals: Optional[ArrayLike]
    initial_cut: Optional[ArrayLike]
    faithful: bool
    minimum_distortion_decrease: float
    minimum_length_decrease: float
    minimum_area_ratio: float
    influence_threshold: float
    forbidden_radius: float
    seed: int
    symmetry: Literal["off", "auto", "x", "y", "z"]
    seam_smoothness: float


# Each class extends the one before it, which a TypedDict does not tell.
_KINDS = (RunOptions, SurfaceOptions, ConstraintOptions, ConnectionOptions, CuttingOptions)

Function = TypeVar("Function", bound=Callable[..., Any])


def takes(kind: type) -> Callable[[Function], Function]:
    """A decorator of functions with `**options`: their docstrings tell the options of `kind`, too."""

    def document(function: Function) -> Function:
        if function.__doc__:  # there is none with python -OO
            kinds = _KINDS[_KINDS.index(kind)::-1]
            parameters = "\n".join(inspect.cleandoc(each.__doc__ or "").split("----------\n")[1] for each in kinds)
            summary, returned, rest = inspect.cleandoc(function.__doc__).partition("\nReturns\n")
            function.__doc__ = f"{summary}\nOther Parameters\n----------------\n{parameters}\n{returned}{rest}"
        return function

    return document


def choice(*names: str) -> Callable[[str, Any], str]:
    def read(name: str, value: Any) -> str:
        if not isinstance(value, str):
            raise TypeError(f"{name} must be a str, not {type(value).__name__}")
        if value not in names:
            raise ValueError(f"{name} must be one of {', '.join(map(repr, names))}, not {value!r}")
        return value

    return read


def rotation(value: Any) -> dict[str, str]:
    """The argument `rotate` of a call, which by default is left out."""
    return {} if value is None else {"rotate": choice(*ROTATIONS)("rotate", value)}


def atlas(texels_per_unit: Any, pages: Any) -> dict[str, Any]:
    """The arguments of a call about scale and pages, which by default are left out."""
    result: dict[str, Any] = {}
    if texels_per_unit is not None:
        result["texels_per_unit"] = real("texels_per_unit", texels_per_unit)
        if not 0 < result["texels_per_unit"] < float("inf"):
            raise ValueError("texels_per_unit must be positive and finite")
    if pages is not None:
        result["pages"] = integer(1, INT_MAX)("pages", pages)
    return result


def flag(name: str, value: Any) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} must be a bool, not {type(value).__name__}")
    return bool(value)


def integer(low: int, high: int) -> Callable[[str, Any], int]:
    def read(name: str, value: Any) -> int:
        try:
            number = operator.index(value)
        except TypeError:
            raise TypeError(f"{name} must be an integer, not {type(value).__name__}") from None
        if not low <= number <= high:
            raise ValueError(f"{name} must be from {low} to {high}, not {number}")
        return number

    return read


def real(name: str, value: Any) -> float:
    if isinstance(value, str):
        raise TypeError(f"{name} must be a number, not a str")
    return float(value)


def seconds(name: str, value: Any) -> float:
    number = real(name, value)
    if not number > 0:
        raise ValueError(f"{name} must be greater than 0, not {number}")
    return number


def _callback(name: str, value: Any) -> Callable[[str, float], Any]:
    if not callable(value):
        raise TypeError(f"{name} must be callable, not {type(value).__name__}")

    def call(phase: str, fraction: float) -> Any:
        answer = value(phase, fraction)
        return bool(answer) if isinstance(answer, np.bool_) else answer

    return call


def _weld(name: str, value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    return choice("auto", "on", "off")(name, value)


def _weld_tolerance(name: str, value: Any) -> float:
    number = real(name, value)
    if not 0 <= number <= 0.01:
        raise ValueError(f"{name} must be from 0 to 0.01, not {number}")
    return number


def _terminals(name: str, value: Any) -> np.ndarray[Any, np.dtype[np.int64]]:
    return _arrays.vector(name, _arrays.indices(name, value))


INT_MAX = 2**31 - 1
_READERS: dict[str, Callable[[str, Any], Any]] = {
    "threads": integer(1, 4096), "time_limit": seconds, "progress": _callback,
    "weld": _weld, "weld_tolerance": _weld_tolerance, "strict": flag,
    "mandatory_edges": _arrays.edges, "forbidden_edges": _arrays.edges, "initial_cut": _arrays.edges,
    "terminals": _terminals,
    "connection": choice(*CONNECTIONS), "maximum_number_of_states": integer(0, 2**63 - 1),
    "effort": choice(*EFFORTS), "faithful": flag, "seed": integer(0, 2**32 - 1),
    "symmetry": choice(*SYMMETRIES),
    **dict.fromkeys(["maximum_average_distortion", "maximum_face_distortion", "face_distortion_quantile",
                     "maximum_chart_distortion", "minimum_distortion_decrease", "minimum_length_decrease",
                     "minimum_area_ratio", "influence_threshold", "forbidden_radius", "seam_smoothness"], real)}


def _read_weights(name: str, value: Any) -> dict[str, Any]:
    try:
        edges, weights = value
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a pair: edges and their weights") from None
    pairs = _arrays.edges(name, edges)
    return {"weighted_edges": pairs, "edge_weights": _arrays.vector(name, _arrays.numbers(name, weights), len(pairs))}


# Names that the program, the C++ functions or usage elsewhere have for options.
OTHER_NAMES = {
    "max_distortion": "maximum_average_distortion", "bound": "maximum_average_distortion",
    "max_face_distortion": "maximum_face_distortion", "face_quantile": "face_distortion_quantile",
    "max_chart_distortion": "maximum_chart_distortion",
    "must_cut": "mandatory_edges", "edge_is_constrained_map": "mandatory_edges",
    "never_cut": "forbidden_edges", "edge_is_forbidden_map": "forbidden_edges",
    "edge_weight_map": "edge_weights", "weights": "edge_weights", "hard_surface": "edge_weights",
    "initial_cut_map": "initial_cut", "seams": "initial_cut",
    "vertex_is_constrained_map": "terminals",
    "allow_overlap": "bijective", "do_bijective": "bijective",
    "use_published_method": "faithful", "connect": "connection",
    "eps_iso": "minimum_distortion_decrease", "eps_len": "minimum_length_decrease",
    "alpha": "minimum_area_ratio", "beta": "influence_threshold",
    "do_weld_points": "weld", "chart_rotation": "rotate", "number_of_pages": "pages",
    "random_seed": "seed", "maximum_running_time": "time_limit", "visitor": "progress",
    "scale": "uv_scale"}


def _suggestion(name: str, function: Callable[..., Any], kind: type) -> str:
    known = [*kind.__annotations__, *inspect.signature(function).parameters]
    known.remove("options")
    near = [OTHER_NAMES[name]] if name in OTHER_NAMES else difflib.get_close_matches(name, known, 1)
    return f"; did you mean {near[0]!r}?" if near and near[0] in known else ""


def read(function: Callable[..., Any], kind: type, options: Mapping[str, Any]) -> dict[str, Any]:
    """The options of a call, checked and as the extension takes them; `kind` is the class that lists them."""
    result: dict[str, Any] = {}
    for name, value in options.items():
        if name not in kind.__annotations__:
            raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}"
                            + _suggestion(name, function, kind))
        if value is None:
            continue
        if name == "edge_weights":
            result.update(_read_weights(name, value))
        else:
            result[name] = _READERS[name](name, value)
    if result.get("weld") == "off" and result.get("weld_tolerance", 0) > 0:
        raise ValueError("weld_tolerance needs weld='on' or 'auto'")
    return result
