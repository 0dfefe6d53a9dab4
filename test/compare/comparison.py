"""Shared by the tests of the comparison: its modules, those of the tests of unwrap, and small maps."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmark" / "compare"), str(ROOT / "test" / "unwrap")]

import numpy as np  # noqa: E402


def grid(width=2, height=1):
    """Points and triangles of unit squares in the plane z = 0, two triangles each."""
    points = np.array([(x, y, 0.0) for y in range(height + 1) for x in range(width + 1)])
    corners = [x + y * (width + 1) for y in range(height) for x in range(width)]
    faces = [face for a in corners for face in ((a, a + 1, a + width + 2), (a, a + width + 2, a + width + 1))]
    return points, np.array(faces)


def flat(points, faces):
    """The UVs of the corners that are the points themselves."""
    return points[faces][:, :, :2].copy()
