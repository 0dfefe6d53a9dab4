"""Several pages, and a given number of texels per unit of length."""

import math
import re

from atlas import check_atlas
from gltf_files import File, full
from support import Case, joined, main, read_obj, sphere, to_obj, to_off, to_ply


def area(points, face):
    """The area of a triangle in space or in the plane."""
    a, b = ([t - s for s, t in zip(points[face[0]], points[face[k]])] for k in (1, 2))
    return math.sqrt(max(0, sum(x * x for x in a) * sum(x * x for x in b) - sum(x * y for x, y in zip(a, b)) ** 2)) / 2


def spheres(number):
    mesh = sphere(1)
    for i in range(1, number):
        points = [(x + 5 * i, y, z) for x, y, z in sphere(1)[0]]
        mesh = mesh[0] + points, mesh[1] + [tuple(v + 18 * i for v in face) for face in sphere(1)[1]]
    return mesh


class Pages(Case):
    def setUp(self):
        super().setUp()
        self.write("parts.off", to_off(spheres(7)))

    def pages_of_groups(self, name):
        pages, page = [], None
        for line in (self.folder / name).read_text().splitlines():
            if line.startswith("g "):
                page = int(re.search(r"page_(\d+)$", line).group(1)) - 1
            elif line.startswith("f "):
                pages.append(page)
        return pages

    def check_report(self, report, uvs, faces, pages, texture_size):
        number = max(pages) + 1
        self.assertEqual(report["pages"], number)
        fills = report["fill"] if number > 1 else [report["fill"]]
        self.assertEqual(len(fills), number)
        for page, fill in enumerate(fills):
            here = sum(area(uvs, [uv for _, uv in face]) for face, p in zip(faces, pages) if p == page)
            self.assertAlmostEqual(fill, here, places=6)
        self.assertAlmostEqual(report["texels_per_unit"], report["uv_scale"] * texture_size, places=6)

    def test_pages_as_groups(self):
        code, report = self.report("parts.off", "-o", "a.obj", "--pages", "3", "--margin", "4", "--texture-size", "256")
        self.assertEqual(code, 0, report["message"])
        _, uvs, faces = read_obj(self.folder / "a.obj")
        pages = self.pages_of_groups("a.obj")
        self.assertEqual(check_atlas(self, uvs, faces, pages, 4, 256), report["charts"])
        self.check_report(report, uvs, faces, pages, 256)
        self.assertEqual(report["pages"], 3)
        one = self.report("parts.off", "-o", "b.obj", "--margin", "4", "--texture-size", "256")[1]
        self.assertEqual((one["pages"], one["overlaps"]), (1, 0))
        self.assertGreater(report["uv_scale"], one["uv_scale"])
        self.assertNotIn("page_", (self.folder / "b.obj").read_text())

    def test_tiles(self):
        options = ("--texels-per-unit", "30", "--margin", "3", "--texture-size", "256")
        groups = self.report("parts.off", "-o", "a.obj", *options)[1]
        tiles = self.report("parts.off", "-o", "b.obj", "--udim", *options)[1]
        self.assertGreater(groups["pages"], 1)
        self.assertAlmostEqual(groups["texels_per_unit"], 30, places=3)
        _, uvs, faces = read_obj(self.folder / "a.obj")
        _, tile_uvs, tile_faces = read_obj(self.folder / "b.obj")
        self.assertEqual(faces, tile_faces)
        pages = self.pages_of_groups("a.obj")
        for face, page in zip(faces, pages):
            for _, uv in face:
                self.assertEqual(tile_uvs[uv], (uvs[uv][0] + page % 10, uvs[uv][1] + page // 10))
        self.assertEqual(tiles["fill"], groups["fill"])
        check_atlas(self, uvs, faces, pages, 3, 256)
        self.check_report(groups, uvs, faces, pages, 256)

    def test_groups_stay(self):
        points, faces = spheres(2)
        lines = ["v " + " ".join(map(repr, p)) for p in points] + ["g left hand"]
        for f, face in enumerate(faces):
            lines += ["g right"] * (f == 32) + ["f " + " ".join(str(v + 1) for v in face)]
        self.write("two.obj", "\n".join(lines) + "\n")
        code, report = self.report("two.obj", "-o", "out.obj", "--pages", "2")
        self.assertEqual((code, report["pages"]), (0, 2), report["message"])
        groups = [line for line in (self.folder / "out.obj").read_text().splitlines() if line.startswith("g")]
        self.assertEqual([re.sub(r" page_\d+$", "", line) for line in groups], ["g left hand", "g right"])

    def test_ply(self):
        for form in ("ascii", "binary_little_endian"):
            self.write("parts.ply", to_ply(spheres(3), form))
            for name in ("parts.ply", "parts.off"):
                code, report = self.report(name, "-o", "out.ply", "--pages", "2")
                self.assertEqual((code, report["pages"]), (0, 2), report["message"])
                header = (self.folder / "out.ply").read_bytes().split(b"end_header")[0]
                self.assertIn(b"texcoord\nproperty int texnumber\n", header)
                self.assertEqual(self.report("out.ply", "-o", "again.obj")[1]["faces"], report["faces"])

    def test_gltf_in_single_precision(self):
        code, report = self.report("parts.off", "-o", "a.glb", "--texels-per-unit", "34", "--udim", "--texture-size", "256")
        self.assertEqual((code, report["flips"], report["overlaps"]), (0, 0, 0), report["message"])
        self.assertGreater(report["pages"], 2)
        file = File(self.folder / "a.glb")
        uvs, faces, pages = [], [], []
        for primitive in file.primitives():
            places = [(u, 1 - v) for u, v in file.numbers_of(primitive["attributes"]["TEXCOORD_0"])]
            corners = [(v + len(uvs), v + len(uvs)) for v in file.corners(primitive)]
            for i in range(0, len(corners), 3):
                faces.append(corners[i:i + 3])
                middle = [sum(places[v - len(uvs)][k] for v, _ in faces[-1]) / 3 for k in (0, 1)]
                pages.append(int(middle[0] // 1 + 10 * (middle[1] // 1)))
            uvs += places
        for page in set(pages):
            self.assertIn(page, range(report["pages"]))
        points = [None] * len(uvs)
        for face, page in zip(faces, pages):
            for _, uv in face:
                points[uv] = (uvs[uv][0] - page % 10, uvs[uv][1] - page // 10)
        check_atlas(self, points, faces, pages, 2, 256)

    def test_files_of_pages(self):
        """Each has its polygons and their points, and a layout as any other one; together they are the whole."""
        points, faces = spheres(4)
        size = len(faces) // 4
        lines = ["# parts", "mtllib my.mtl"] + ["v " + " ".join(map(repr, p)) for p in points]
        for f, face in enumerate(faces):
            if f % size == 0:
                lines += [f"o part {f // size}", "l 1 2", "odd 7"]
            lines.append("f " + " ".join(str(v + 1) for v in face))
        self.write("in.obj", "\n".join(lines) + "\n")
        options = ("--pages", "2", "--svg", "p.svg", "--texture", "t.png", "--texture-size", "256")
        code, whole = self.report("in.obj", "-o", "whole.obj", *options)
        self.assertEqual((code, whole["pages"]), (0, 2), whole["message"])
        self.assert_whole_as("whole", "out", options, points)
        _, report = self.report("in.obj", "-o", "out.obj", *options, "--page-files")
        self.assertEqual(report["fill"], whole["fill"])
        self.assertTrue(any("lines" in w and "unknown statements" in w for w in report["warnings"]), report["warnings"])

    def assert_whole_as(self, whole, name, options, points):
        """Runs anew with files of pages."""
        _, uvs, faces = read_obj(self.folder / (whole + ".obj"))
        pages = self.pages_of_groups(whole + ".obj")
        before = set(self.files())
        run = self.unwrap("in.obj", "-o", name + ".obj", *options, "--page-files")
        self.assertEqual(run.returncode, 0, run.stderr)
        new = {"out.1001.obj", "out.1002.obj", "out.mtl", "p.1001.svg", "p.1002.svg"}
        self.assertEqual(set(self.files()) - before, new)
        self.assertTrue(all(file.encode() in run.stderr for file in new - {"out.mtl"}))
        for page in range(2):
            path = self.folder / f"{name}.{1001 + page}.obj"
            own_points, own_uvs, own_faces = read_obj(path)
            self.assertEqual([[(own_points[v], own_uvs[t]) for v, t in face] for face in own_faces],
                             [[(points[v], uvs[t]) for v, t in face] for face, p in zip(faces, pages) if p == page])
            self.assertEqual({v for face in own_faces for v, _ in face}, set(range(len(own_points))))
            check_atlas(self, own_uvs, own_faces, [0] * len(own_faces), 2, 256)
            statements = [line for line in path.read_text().splitlines() if line[0] in "#olg"]
            parts = sorted({points.index(own_points[v]) // 18 for face in own_faces for v, _ in face})
            self.assertEqual(statements, ["# parts"] + [f"o part {part}" for part in parts])
            picture = (self.folder / f"p.{1001 + page}.svg").read_text()
            self.assertEqual([f">{tile}<" in picture for tile in (1001, 1002)], [page == 0, page == 1])

    def test_files_of_pages_in_other_formats(self):
        self.write("parts.ply", to_ply(spheres(3), "binary_little_endian"))
        self.write("parts.glb", full().glb())
        for name, out in (("parts.off", "a.glb"), ("parts.ply", "a.ply"), ("parts.glb", "a.gltf")):
            code, report = self.report(name, "-o", out, "--page-files", "--texels-per-unit", "30", "--texture-size", "256")
            self.assertEqual(code, 0, report["message"])
            stem, end = out.split(".")
            files = [f"{stem}.{1001 + page}.{end}" for page in range(report["pages"])]
            self.assertEqual([file for file in self.files() if file.startswith("a.") and file.endswith(end)], files)
            again = [self.report(file, "-o", "again.obj", "--pack-only")[1] for file in files]
            self.assertEqual(sum(each["faces"] for each in again), report["faces"])
            self.assertEqual(sum(each["charts"] for each in again), report["charts"])
            self.assertEqual({each["overlaps"] for each in again}, {0})
        self.assertGreater(report["pages"], 0)

    def test_pictures(self):
        self.assertEqual(self.unwrap("parts.off", "--pages", "2", "--svg", "a.svg", "--quiet").returncode, 0)
        text = (self.folder / "a.svg").read_text()
        self.assertTrue(">1001<" in text and ">1002<" in text and ">1003<" not in text)

    def test_errors(self):
        self.assert_refused(4, "parts.off", "--texels-per-unit", "1e6")
        self.assert_refused(4, "parts.off", "--texels-per-unit", "30", "--texture-size", "256", "--pages", "1")
        for words in (["--pages", "0"], ["--pages", "x"], ["--texels-per-unit", "0"], ["--texels-per-unit", "-1"],
                      ["--pages", "2", "--uv-scale", "surface"], ["--page-files", "--uv-scale", "surface"],
                      ["--page-files", "--udim"], ["--page-files", "-o", "/dev/stdout"]):
            self.assert_refused(2, "parts.off", *words)
        # A file of the second page, which is not known before, is never an input.
        self.write("a.1002.obj", to_obj(spheres(7)))
        self.assert_refused(2, "a.1002.obj", "-o", "a.obj", "--pages", "2", "--page-files")


main()
