"""Builds the module with CMake, for pip install ./python.

All that is built lies in the folder SURFACE_MESH_CUTTING_BUILD_DIR. By default, that is the folder build of the project if
the library is built there for this version of Python, whose files are not compiled again; else build/package."""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parent.parent
SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")


def is_built_for_this_python(folder):
    if not (folder / "src" / "libsurface_mesh_cutting.a").exists():
        return False
    python = re.search(r"^Python_EXECUTABLE:\w+=(.+)", (folder / "CMakeCache.txt").read_text(), re.MULTILINE)
    suffix = "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'), end='')"
    return python is not None and subprocess.run([python[1], "-c", suffix], capture_output=True, text=True).stdout == SUFFIX


def build_folder():
    chosen = os.environ.get("SURFACE_MESH_CUTTING_BUILD_DIR")
    if chosen:
        return Path(chosen).resolve()
    of_project = PROJECT / "build"
    return of_project if is_built_for_this_python(of_project) else of_project / "package"


BUILD = build_folder()


def options_of_cmake():
    yield from ("-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", f"-DPython_EXECUTABLE={sys.executable}")
    try:  # where pip has installed it for the build; Debian's is found without help
        import pybind11
        yield f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"
    except ImportError:
        pass


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        start = time.monotonic()
        print(f"Compiling into {BUILD}: minutes, unless all is there already", file=sys.stderr, flush=True)
        if not (BUILD / "CMakeCache.txt").exists():
            subprocess.run(["cmake", "-S", PROJECT, "-B", BUILD, *options_of_cmake()], check=True)
        environment = {"CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count()), **os.environ}
        subprocess.run(["cmake", "--build", BUILD, "--target", "surface_mesh_cutting_python"], env=environment, check=True)
        print(f"Compiled in {time.monotonic() - start:.0f} s", file=sys.stderr, flush=True)
        built = BUILD / "python" / "surface_mesh_cutting" / ("_extension" + SUFFIX)
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
