"""Tries the packages that scripts/package.sh makes, each in an empty folder and without the environment:

    test_packages.py FOLDER [program|library|wheel]"""

import json
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path

PACKAGES = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(Surface_mesh_cutting VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
TETRAHEDRON = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
PATH = {"PATH": "/usr/bin:/bin"}  # of compilers, which need others


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "tetrahedron.off").write_text(TETRAHEDRON)

    def run_here(self, *arguments, environment=None):
        run = subprocess.run(arguments, cwd=self.folder, env=environment or {}, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def package(self, pattern):
        found = list(PACKAGES.glob(pattern))
        self.assertEqual(len(found), 1, found)
        return found[0]

    def check_program(self, program):
        """Does all that its libraries are for: pictures, pages and glTF."""
        needed = set(re.findall(r"(\S+)(?: =>| \()", self.run_here("/usr/bin/ldd", program)))
        names = {re.sub(r"\.so.*|-linux.*|-vdso.*", "", Path(name).name) for name in needed}
        self.assertLessEqual(names, {"libc", "libm", "ld", "linux"})
        self.assertEqual(self.run_here(program, "--version").split()[:2], ["unwrap", VERSION])
        report = json.loads(self.run_here(program, "tetrahedron.off", "-o", "out.glb", "--json", "-", "--texture", "texture.png",
                                          "--html", "page.html", "--svg", "layout.svg"))
        self.assertEqual((report["status"], report["flips"], report["overlaps"]), ("done", 0, 0))
        self.assertTrue((self.folder / "texture.png").read_bytes().startswith(b"\x89PNG"))
        self.assertIn("WebGLRenderer", (self.folder / "page.html").read_text())
        report = json.loads(self.run_here(program, "out.glb", "-o", "again.obj", "--json", "-", "--initial-cut", "uv"))
        self.assertEqual((report["status"], report["faces"]), ("done", 4))


class Program(Case):
    def test_archive(self):
        archive = self.package(f"unwrap-{VERSION}-linux-*.tar.gz")
        with tarfile.open(archive) as files:
            files.extractall(self.folder)
        folder = self.folder / archive.name[:-len(".tar.gz")]
        self.assertTrue({"README.md", "LICENSE", "licenses"} <= {path.name for path in folder.iterdir()})
        self.check_program(folder / "unwrap")

    def test_addon(self):
        with zipfile.ZipFile(self.package("surface_mesh_cutting_addon.zip")) as files:
            files.extractall(self.folder)  # as Blender does, which takes the right to run it away
        self.assertTrue((self.folder / "surface_mesh_cutting_addon" / "__init__.py").exists())
        program, = self.folder.glob("surface_mesh_cutting_addon/bin/linux-*/unwrap")
        program.chmod(0o755)
        self.check_program(program)

    @unittest.skipUnless(shutil.which("blender"), "Blender is not installed")
    def test_addon_in_blender(self):
        """Unwraps once it is installed and enabled, without a path in the preferences."""
        (self.folder / "try.py").write_text(f"""
import bpy
bpy.ops.preferences.addon_install(filepath={str(self.package("surface_mesh_cutting_addon.zip"))!r})
bpy.ops.preferences.addon_enable(module="surface_mesh_cutting_addon")
print(bpy.context.preferences.addons["surface_mesh_cutting_addon"].preferences.find_program())
bpy.ops.mesh.primitive_monkey_add()
bpy.ops.uv.unwrap_with_shortest_cuts()
assert any(edge.use_seam for edge in bpy.context.object.data.edges)
""")
        scripts = self.folder / "scripts"
        said = self.run_here(shutil.which("blender"), "--background", "--factory-startup", "--python-exit-code", "1",
                             "--python", "try.py", environment={"BLENDER_USER_SCRIPTS": str(scripts), "HOME": str(self.folder)})
        self.assertRegex(said, rf"{scripts}/addons/surface_mesh_cutting_addon/bin/linux-\w+/unwrap\n")


class Library(Case):
    def test_debian_package(self):
        package = self.package(f"libsurface-mesh-cutting-dev_{VERSION}_*.deb")
        for dependency in self.run_here("/usr/bin/dpkg-deb", "--field", package, "Depends").split(","):
            name = dependency.split()[0]
            self.assertIn("installed", self.run_here("/usr/bin/dpkg-query", "--show", "--showformat", "${db:Status-Status}", name))
        self.run_here("/usr/bin/dpkg-deb", "-x", package, self.folder, environment=PATH)
        self.assertIn("License: GPL-3+", (self.folder / "usr/share/doc/libsurface-mesh-cutting-dev/copyright").read_text())
        readme = (ROOT / "README.md").read_text()
        for language, name in ("cmake", "CMakeLists.txt"), ("cpp", "main.cpp"):
            (self.folder / name).write_text(re.search(rf"\n```{language}\n([^`]*)```\n", readme)[1])
        self.run_here("cmake", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1",
                      f"-DCMAKE_PREFIX_PATH={self.folder}/usr", environment=PATH)
        self.run_here("cmake", "--build", "build", environment=PATH)
        self.assertIn("1 chart(s)", self.run_here("build/my_program", "tetrahedron.off"))


class Wheel(Case):
    def test_wheel(self):
        wheel = self.package(f"surface_mesh_cutting-{VERSION}-*.whl")
        self.run_here("/usr/bin/python3", "-m", "venv", "--system-site-packages", "env")
        self.run_here("env/bin/python", "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", wheel)
        (self.folder / "try.py").write_text("""
import numpy, surface_mesh_cutting as smc
points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.]])
faces = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
assert smc.certify_unwrap(points, faces, smc.unwrap(points, faces).corner_uv)
print(smc.__file__, smc.__version__)
""")
        file, version = self.run_here("env/bin/python", "try.py").split()
        self.assertEqual(version, VERSION)
        self.assertIn(self.folder / "env", Path(file).parents)


if __name__ == "__main__":
    kinds = [word.capitalize() for word in sys.argv[2:]] or None
    unittest.main(argv=sys.argv[:1], defaultTest=kinds, verbosity=2)
