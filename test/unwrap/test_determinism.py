"""The same bytes for every number of threads, and every time."""

import json
import os
from pathlib import Path

from support import Case, joined, main, sphere, to_off, torus

MESHES = Path(os.environ.get("CGAL_DATA_DIR", "")) / "meshes"
FILES = [MESHES / f"{name}.off" for name in ("blob", "eight", "dragknob")]
OPTIONS = [["--effort", "fast"], ["--effort", "default"], ["--bijective"], ["--faithful"],
           ["--max-distortion", "4.2"]]
CHANGING = ("seconds", "cpu_seconds", "factorized_unknowns", "threads", "peak_memory_mb")


class Determinism(Case):
    def outputs(self, mesh, options, threads):
        run = self.unwrap(mesh, "-o", "out.obj", "--json", "out.json", "--threads", threads, *options)
        self.assertEqual(run.returncode, 0, run.stderr)
        report = json.loads((self.folder / "out.json").read_text())
        for key in CHANGING:
            del report[key]
        return (self.folder / "out.obj").read_bytes(), report

    def test_same_every_time(self):
        self.write("components.off", to_off(joined(joined(sphere(3), torus()), sphere(2))))
        for mesh in ["components.off", *filter(Path.exists, FILES)]:
            for options in OPTIONS:
                with self.subTest(mesh=str(mesh), options=options):
                    first = self.outputs(mesh, options, 1)
                    for threads in (1, 2, 2):
                        self.assertEqual(self.outputs(mesh, options, threads), first)

    # All solvers lead to the same cut and, but for rounding, to the same map.
    def test_solvers(self):
        points, faces = sphere(4)  # without its symmetries, which leave ties to rounding
        self.write("egg.off", to_off(([(x * (1 + y / 5), 1.3 * y, z + x * x / 10) for x, y, z in points], faces)))
        expected = self.outputs("egg.off", [], 1)[1]
        self.assertEqual(expected["solver"], "supernodal")
        for solver in ("supernodal", "eigen"):
            report = self.outputs("egg.off", ["--solver", solver], 1)[1]
            self.assertEqual(report["solver"], solver)
            self.assertEqual(report["cut_length"], expected["cut_length"])
            self.assertAlmostEqual(report["E_iso"], expected["E_iso"], 5)

    # So large that threads share the work on one chart.
    def test_large_chart(self):
        self.write("large.off", to_off(sphere(6)))
        first = self.outputs("large.off", ["--effort", "fast"], 1)
        for threads in (2, 3):
            self.assertEqual(self.outputs("large.off", ["--effort", "fast"], threads), first)


main()
