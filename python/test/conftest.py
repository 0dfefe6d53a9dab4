"""Where the tests find the program, and what they share."""

import os
from pathlib import Path

import pytest


def pytest_report_header():
    import surface_mesh_cutting

    return f"surface_mesh_cutting from {Path(surface_mesh_cutting.__file__).parent}"


@pytest.fixture(scope="session")
def program():
    """The program unwrap, whose results are compared."""
    path = os.environ.get("UNWRAP_PROGRAM", "")
    if not os.access(path, os.X_OK):
        pytest.skip("UNWRAP_PROGRAM does not name the program unwrap")
    return path
