# Copyright (c) 2026 The Surface_mesh_cutting authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Short cuts of surfaces, and maps without flips and with low isometric distortion.

>>> import numpy as np
>>> import surface_mesh_cutting
>>> points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.]])
>>> faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
>>> result = surface_mesh_cutting.unwrap(points, faces)
>>> result.corner_uv.shape
(4, 3, 2)
"""

import atexit as _atexit
import os as _os

from . import _extension
from ._extension import __version__
from .charts import certify_unwrap, pack_charts
from .connecting import connect_points, cut_handles
from .cutting import detect_feature_points, greedy_cut, unwrap
from .errors import ComputationError, Error, Finding, InputError, StoppedError
from .graphs import steiner_tree
from .options import ConnectionOptions, ConstraintOptions, CuttingOptions, RunOptions, SurfaceOptions
from .results import (Certificate, ConnectionResult, CutResult, FeatureResult, HandlesResult, Interpretation,
                      PackingResult, Result, SteinerTree, SurfaceResult, UnwrapResult)

__all__ = ["Certificate", "ComputationError", "ConnectionOptions", "ConnectionResult", "ConstraintOptions", "CutResult",
           "CuttingOptions", "Error", "FeatureResult", "Finding", "HandlesResult", "InputError", "Interpretation",
           "PackingResult", "Result", "RunOptions", "SteinerTree", "StoppedError", "SurfaceOptions", "SurfaceResult",
           "UnwrapResult", "certify_unwrap", "connect_points", "cut_handles", "detect_feature_points", "greedy_cut",
           "pack_charts", "steiner_tree", "unwrap", "__version__"]

_atexit.register(_extension.stop_all_calls)  # of daemon threads
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=_extension.forget_calls)
