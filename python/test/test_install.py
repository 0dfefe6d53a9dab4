"""pip install ./python, without a network."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

SOURCES = Path(__file__).resolve().parent.parent


def test_pip_install(tmp_path):
    build = os.environ.get("SURFACE_MESH_CUTTING_BUILD_DIR")
    if not build:
        pytest.skip("SURFACE_MESH_CUTTING_BUILD_DIR does not name a build folder")
    before = sorted(SOURCES.rglob("*"))
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", tmp_path], check=True)
    python = tmp_path / "bin" / "python"
    ignored = {"PYTHONPATH"}
    if Path(build) == SOURCES.parent / "build":  # which is found
        ignored.add("SURFACE_MESH_CUTTING_BUILD_DIR")
    environment = {key: value for key, value in os.environ.items() if key not in ignored}
    run = subprocess.run([python, "-B", "-m", "pip", "install", "--verbose", "--no-index", "--no-build-isolation", "--no-compile",
                          "--disable-pip-version-check", SOURCES], env=environment, check=True, capture_output=True, text=True)
    assert f"Compiling into {build}:" in run.stdout + run.stderr
    code = """
import numpy, surface_mesh_cutting as smc
points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.]])
faces = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
assert smc.certify_unwrap(points, faces, smc.unwrap(points, faces).corner_uv)
print(smc.__file__, smc.__version__)
"""
    run = subprocess.run([python, "-c", code], env=environment, check=True, capture_output=True, text=True, cwd=tmp_path)
    file, version = run.stdout.split()
    folder = Path(file).parent
    assert (folder.parent / f"surface_mesh_cutting-{version}.dist-info").is_dir()
    assert tmp_path in folder.parents
    assert {"py.typed", "_extension.pyi"} <= {path.name for path in folder.iterdir()}
    assert [path for path in sorted(SOURCES.rglob("*")) if "__pycache__" not in path.parts] == [
        path for path in before if "__pycache__" not in path.parts]
