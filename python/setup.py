"""Builds the module with CMake, for pip install --no-build-isolation ./python.

All that is built lies in the folder SURFACE_MESH_CUTTING_BUILD_DIR, by default build/package of the project. If the
project is built there already, nothing is compiled again."""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parent.parent
BUILD = Path(os.environ.get("SURFACE_MESH_CUTTING_BUILD_DIR", PROJECT / "build" / "package")).resolve()


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        if not (BUILD / "CMakeCache.txt").exists():
            subprocess.run(["cmake", "-S", PROJECT, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
                            f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        environment = {"CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count()), **os.environ}
        subprocess.run(["cmake", "--build", BUILD, "--target", "surface_mesh_cutting_python"], env=environment, check=True)
        built = BUILD / "python" / "surface_mesh_cutting" / ("_extension" + sysconfig.get_config_var("EXT_SUFFIX"))
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)


def project_version():
    text = (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(Surface_mesh_cutting VERSION (\S+)", text).group(1)


# Nothing is written next to the sources.
work = BUILD / "pip"
work.mkdir(parents=True, exist_ok=True)
setup(version=project_version(), ext_modules=[Extension("surface_mesh_cutting._extension", sources=[])],
      cmdclass={"build_ext": BuildWithCMake},
      options={"build": {"build_base": str(work)}, "egg_info": {"egg_base": str(work)}})
