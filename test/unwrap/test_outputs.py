"""The files that the program writes: complete, exact, and the same every time."""

import base64
import itertools
import json
import math
import os
import re
import signal
import subprocess
import time
import xml.etree.ElementTree
from fractions import Fraction
from pathlib import Path

from support import Case, PROGRAM, TIME_LIMIT, joined, main, read_obj, sphere, to_off

SPHERE = sphere(3)
ALL_OUTPUTS = ["--svg", "a.svg", "--texture", "a.png", "--obj-cut", "cut.obj"]


def energy(points, uvs):
    """Area and symmetric Dirichlet energy of a triangle."""
    a, b = ([t - s for s, t in zip(points[0], points[k])] for k in (1, 2))
    u, v = ([t - s for s, t in zip(uvs[0], uvs[k])] for k in (1, 2))
    dot = lambda s, t: sum(x * y for x, y in zip(s, t))
    area = math.sqrt(dot(a, a) * dot(b, b) - dot(a, b) ** 2)
    uv_area = u[0] * v[1] - u[1] * v[0]
    norm = (dot(u, u) * dot(b, b) - 2 * dot(u, v) * dot(a, b) + dot(v, v) * dot(a, a)) / area ** 2
    return area, norm * (1 + (area / uv_area) ** 2), uv_area


def benchmark_measures(points, uvs, faces):
    """The columns of the parameterization benchmark, from their definitions, that have no need of the cut."""
    corners = [([points[v] for v, _ in face], [uvs[uv] for _, uv in face]) for face in faces]
    areas = [area / 2 for area, _, _ in (energy(*corner) for corner in corners)]
    images = [abs(uv_area) / 2 for _, _, uv_area in (energy(*corner) for corner in corners)]
    width = max(max(uv[i] for uv in uvs) - min(uv[i] for uv in uvs) for i in (0, 1))
    scale = math.sqrt(sum(areas) / sum(images))

    def angles(triangle):
        sides = [math.dist(triangle[(k + 1) % 3], triangle[(k + 2) % 3]) for k in range(3)]
        return [math.acos((sides[k - 1] ** 2 + sides[k - 2] ** 2 - sides[k] ** 2) / (2 * sides[k - 1] * sides[k - 2]))
                for k in range(3)]

    result = dict.fromkeys(("max_area_distortion", "average_area_discrepancy", "max_singular_value",
                            "max_angle_distortion", "average_angle_discrepancy", "resolution",
                            "symmetric_dirichlet_energy"), 0)
    result["min_singular_value"] = math.inf
    for (surface, image), area, uv_area in zip(corners, areas, images):
        norm = energy(surface, image)[1] / (1 + (area / uv_area) ** 2)  # the sum of both squares
        product = uv_area / area
        large = (math.sqrt(norm + 2 * product) + math.sqrt(max(0, norm - 2 * product))) / 2
        small = product / large
        share, uv_share = area / sum(areas), uv_area / sum(images)
        excess = lambda x: x + 1 / x - 2
        result["average_area_discrepancy"] += abs(share - uv_share)
        result["average_angle_discrepancy"] += share * sum(abs(a - b) for a, b in zip(angles(surface), angles(image)))
        result["symmetric_dirichlet_energy"] += share / 2 * sum(
            (scale * s) ** 2 + (scale * s) ** -2 for s in (small, large))
        result["min_singular_value"] = min(result["min_singular_value"], scale * small)
        for key, value in (("max_area_distortion", excess(uv_share / share)), ("max_singular_value", scale * large),
                           ("max_angle_distortion", excess(large / small)), ("resolution", width / small)):
            result[key] = max(result[key], value)
    return result, sum(areas)


def with_arms(mesh):
    """A body with arms in many directions; the chart of such a surface overlaps itself."""
    points, faces = mesh
    arm = lambda p: 1 + 2 * (math.sin(4 * p[0]) * math.sin(4 * p[1]) * math.cos(3 * p[2])) ** 2
    return [tuple(arm(p) * x for x in p) for p in points], faces


def has_crossing(uvs, faces):
    """Whether two edges on the border of the layout properly cross each other; exact."""
    sides = {}
    for face in faces:
        for k in range(3):
            edge = face[k][1], face[(k + 1) % 3][1]
            sides.setdefault(frozenset(edge), []).append(edge)
    exact = [tuple(map(Fraction, uv)) for uv in uvs]
    border = [tuple(exact[v] for v in edges[0]) for edges in sides.values() if len(edges) == 1]

    def side(p, q, r):
        area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        return (area > 0) - (area < 0)

    def boxes_meet(edge, other):
        return all(min(edge[0][i], edge[1][i]) <= max(other[0][i], other[1][i])
                   and min(other[0][i], other[1][i]) <= max(edge[0][i], edge[1][i]) for i in (0, 1))

    return any(boxes_meet(edge, other) and side(*edge, other[0]) * side(*edge, other[1]) < 0
               and side(*other, edge[0]) * side(*other, edge[1]) < 0
               for edge, other in itertools.combinations(border, 2))


class Outputs(Case):
    def setUp(self):
        super().setUp()
        self.write("sphere.off", to_off(SPHERE))

    def successful_report(self, *arguments):
        exit_code, report = self.report("sphere.off", *arguments)
        self.assertEqual(exit_code, 0, report["message"])
        return report

    def test_report(self):
        report = self.successful_report("--seed", "7", "--threads", "1")
        self.assertEqual(self.files(), ["sphere.off", "sphere.uv.obj"])
        for key, value in {"vertices": len(SPHERE[0]), "faces": len(SPHERE[1]), "components": 1,
                           "genus": 0, "borders": 0, "flips": 0, "overlaps": 0, "charts": 1, "witness": None,
                           "seed": 7, "threads": 1, "effort": "default"}.items():
            self.assertEqual(report[key], value, key)
        for key in ("cut_length", "E_iso", "E_max", "uv_scale", "fill", "peak_memory_mb"):
            self.assertGreater(report[key], 0, key)
        self.assertGreater(report["seconds"]["total"], 0)
        # At least one map of the whole surface.
        self.assertGreaterEqual(report["factorized_unknowns"]["total"], 2 * report["vertices"])
        self.assertGreaterEqual(report["factorized_unknowns"]["parameterize"], 2 * report["vertices"])
        page = Path(__file__).parents[2] / "examples/Surface_mesh_cutting/unwrap/README.md"
        for key in (*report, *report["seconds"]):
            self.assertIn(f"`{key}`", page.read_text())

    def test_report_in_file(self):
        run = self.unwrap("sphere.off", "--json", "report.json")
        self.assertEqual((run.returncode, run.stdout), (0, b""))
        self.assertEqual(json.loads((self.folder / "report.json").read_text())["status"], "done")

    def test_texture_coordinates_follow_the_cut(self):
        report = self.successful_report(*ALL_OUTPUTS)
        points, uvs, faces = read_obj(self.folder / "sphere.uv.obj")
        cut_text = (self.folder / "cut.obj").read_text()
        cut_points = [tuple(map(float, line.split()[1:])) for line in cut_text.splitlines()
                      if line.startswith("v ")]
        vertex = {point: v for v, point in enumerate(points)}
        cut = {frozenset(vertex[cut_points[int(i) - 1]] for i in line.split()[1:])
               for line in cut_text.splitlines() if line.startswith("l ")}
        features = {vertex[cut_points[int(line.split()[1]) - 1]]
                    for line in cut_text.splitlines() if line.startswith("p ")}
        self.assertEqual(len(features), report["features"])
        self.assertLessEqual(features, set().union(*cut))

        sides = {}
        for face in faces:
            for k in range(3):
                (a, uv_a), (b, uv_b) = face[k], face[(k + 1) % 3]
                sides.setdefault(frozenset((a, b)), []).append({a: uv_a, b: uv_b})
        for edge, (one, other) in sides.items():
            self.assertEqual(one != other, edge in cut)
        # A sphere that is cut to a disk along a tree.
        self.assertEqual(len(uvs), len(points) + len(cut) - 1)
        self.assertEqual({uv for face in faces for _, uv in face}, set(range(len(uvs))))
        diagonal = math.dist(*([f(p[i] for p in points) for i in range(3)] for f in (min, max)))
        length = sum(math.dist(*(points[v] for v in edge)) for edge in cut)
        self.assertAlmostEqual(report["cut_length"], length / diagonal, places=9)

    def test_measures_are_those_of_the_file(self):
        for options in ([], ["--uv-scale", "surface"], ["--allow-overlap"]):
            report = self.successful_report(*options)
            points, uvs, faces = read_obj(self.folder / "sphere.uv.obj")
            if "surface" in options:
                self.assertEqual((report["uv_scale"], report["fill"]), (1, None))
            scaled = [[x / report["uv_scale"] for x in uv] for uv in uvs]
            measures = [energy([points[v] for v, _ in face], [scaled[uv] for _, uv in face]) for face in faces]
            self.assertGreater(min(uv_area for _, _, uv_area in measures), 0)
            mean = sum(a * e for a, e, _ in measures) / sum(a for a, _, _ in measures)
            self.assertAlmostEqual(report["E_iso"] / mean, 1, places=9)
            self.assertAlmostEqual(report["E_max"] / max(e for _, e, _ in measures), 1, places=9)
            if report["fill"] is not None:
                area = sum(uv_area for _, _, uv_area in measures) * report["uv_scale"] ** 2 / 2
                self.assertAlmostEqual(report["fill"], area, places=9)

    def test_measures_of_the_benchmark(self):
        for options in ([], ["--uv-scale", "surface", "--allow-overlap"]):
            report = self.successful_report("-o", "out.obj", *options)
            expected, area = benchmark_measures(*read_obj(self.folder / "out.obj"))
            for key, value in expected.items():
                self.assertAlmostEqual(report["distortion"][key] / value, 1, places=6, msg=key)
            self.assertEqual(report["distortion"]["proportion_flipped_triangles"], 0)
            diagonal = math.dist(*([f(p[i] for p in SPHERE[0]) for i in range(3)] for f in (min, max)))
            self.assertAlmostEqual(report["distortion"]["mesh_cut_length"],
                                   report["cut_length"] * diagonal / math.sqrt(area), places=6)
            self.assertEqual(report["distortion"]["overlaps"], 0)

    def test_unit_square(self):
        self.write("parts.off", to_off(joined(joined(sphere(1), sphere(2)), sphere(2))))
        for options, margin in (([], 2 / 1024), (["--margin", "8", "--texture-size", "256"], 8 / 256), (["--margin", "0"], 0)):
            exit_code, report = self.report("parts.off", *options)
            self.assertEqual((exit_code, report["charts"], report["overlaps"]), (0, 3, 0))
            uvs = read_obj(self.folder / "parts.uv.obj")[1]
            self.assertTrue(all(margin <= x <= 1 - margin for uv in uvs for x in uv))
        for options in (["--margin", "8", "--texture-size", "16"], ["--margin", "-1"], ["--texture-size", "0"],
                        ["--uv-scale", "large"], ["--allow-overlap", "--bijective"]):
            self.assert_refused(2, "parts.off", *options)

    def test_bijective(self):
        self.write("arms.off", to_off(with_arms(sphere(3))))
        exit_code, plain = self.report("arms.off", "-o", "plain.obj", "--allow-overlap")
        self.assertEqual((exit_code, plain["overlaps"]), (0, None))
        self.assertTrue(has_crossing(*read_obj(self.folder / "plain.obj")[1:]))
        exit_code, report = self.report("arms.off")
        self.assertEqual((exit_code, report["overlaps"], report["flips"]), (0, 0, 0))
        self.assertFalse(has_crossing(*read_obj(self.folder / "arms.uv.obj")[1:]))
        # Another cut may have more room, but is no better than the best one that may overlap.
        total = lambda r: r["E_iso"] + 0.15 * r["cut_length"]
        self.assertGreaterEqual(total(report), total(plain))
        self.assertLess(report["E_iso"], plain["E_iso"] + 0.1)

    def test_pictures(self):
        self.successful_report(*ALL_OUTPUTS)
        self.assertEqual(self.files(), ["a.png", "a.svg", "cut.obj", "sphere.off", "sphere.uv.mtl",
                                        "sphere.uv.obj"])
        text = (self.folder / "a.svg").read_text()
        self.assertTrue(xml.etree.ElementTree.fromstring(text).tag.endswith("svg"))
        image = re.search('base64,([^"]*)"', text).group(1)
        for data in (base64.b64decode(image, validate=True), (self.folder / "a.png").read_bytes()):
            self.assertTrue(data.startswith(b"\x89PNG\r\n\x1a\n") and b"IEND" in data)
        self.assertIn("mtllib sphere.uv.mtl\n", (self.folder / "sphere.uv.obj").read_text())
        self.assertRegex((self.folder / "sphere.uv.mtl").read_text(), "map_Kd .* a.png\n")

    def test_plot_of_the_trade_off(self):
        def plot(*arguments):
            report = self.successful_report("--svg", "a.svg", *arguments)
            root = xml.etree.ElementTree.parse(self.folder / "a.svg").getroot()
            parts = {(node.tag.split("}")[1], node.get("class")): node for node in root.iter()}
            places = [tuple(float(node.get(key)) for key in ("cx", "cy")) for node in parts["g", "tradeoff"]]
            self.assertEqual(len(places), len(report["tradeoff"]))
            self.assertGreater(len(places), 1)
            # Longer cuts lie to the right, less distorted ones below (y goes down); all within the picture.
            self.assertEqual(places, sorted(places))
            self.assertEqual([y for _, y in places], sorted(y for _, y in places))
            width, height = map(float, root.get("viewBox").split()[2:])
            self.assertTrue(all(0 < x < width and 0 < y < height for x, y in places))
            own = parts["g", "result"][0]
            self.assertLess(min(math.dist(place, (float(own.get("cx")), float(own.get("cy")))) for place in places), 0.1)
            # The axes end near the points, and have numbers.
            texts = [node.text for node in root.iter() if node.tag.endswith("text")]
            numbers = [float(text) for text in texts if re.fullmatch(r"[\d.]+", text)]
            lengths, energies = zip(*report["tradeoff"])
            for values in (lengths, energies):
                self.assertGreaterEqual(sum(min(values) - 0.3 < number < max(values) + 0.3 for number in numbers), 2)
            xs = [x for x, _ in places]
            self.assertGreater(max(xs) - min(xs), 300)  # of 422
            return [y for _, y in places], report["tradeoff"], parts.get(("path", "bound"))

        self.assertIsNone(plot()[2])
        places, trade_offs, bound = plot("--max-distortion", "4.15")
        y = float(re.match(r"M\S+ ([^L]+)L", bound.get("d")).group(1))
        for place, (_, e_iso) in zip(places, trade_offs):
            self.assertEqual(place >= y, e_iso <= 4.15)

    def test_sides_of_the_cut(self):
        self.successful_report("--svg", "a.svg", "--svg-style", "partners", "--obj-cut", "cut.obj")
        root = xml.etree.ElementTree.parse(self.folder / "a.svg").getroot()
        number = (self.folder / "cut.obj").read_text().count("\nl ")
        sides = [node.get("d").count("M") for node in root.iter() if node.get("class") == "partners"]
        self.assertEqual(sum(sides), 2 * number)
        self.assertTrue(all(side % 2 == 0 for side in sides))
        colors = [node.get("stroke") for node in root.iter() if node.get("class") == "partners"]
        self.assertEqual(len(set(colors)), len(colors))

    def test_texture_in_other_folder(self):
        for folder in ("meshes", "images"):
            os.mkdir(self.folder / folder)
        self.successful_report("-o", "meshes/a.obj", "--texture", "images/a.png")
        self.assertIn("../images/a.png\n", (self.folder / "meshes" / "a.mtl").read_text())

    def test_ply(self):
        self.write("in.off", to_off(SPHERE))
        for name in "out.obj", "out.ply":
            self.assertEqual(self.report("in.off", "-o", name)[0], 0)
        points, uvs, faces = read_obj(self.folder / "out.obj")
        head, body = (self.folder / "out.ply").read_text().split("end_header\n")
        self.assertIn(f"element vertex {len(points)}\n", head)
        lines = [line.split() for line in body.splitlines()]
        self.assertEqual([tuple(map(float, line)) for line in lines[:len(points)]], [tuple(p) for p in points])
        self.assertEqual([[int(v) for v in line[1:4]] for line in lines[len(points):]],
                         [[v for v, _ in face] for face in faces])
        self.assertEqual([list(map(float, line[5:])) for line in lines[len(points):]],
                         [[x for _, uv in face for x in uvs[uv]] for face in faces])
        # what is written can be read: its own seams are a cut
        exit_code, report = self.report("out.ply", "--must-cut", "uv", "-o", "again.obj")
        self.assertEqual(exit_code, 0, report["message"])

    def test_same_bytes_every_time(self):
        def run(*arguments):
            report = self.successful_report(*ALL_OUTPUTS, *arguments)
            for key in ("seconds", "cpu_seconds", "factorized_unknowns", "peak_memory_mb", "threads", "message"):
                del report[key]
            return report, [(self.folder / name).read_bytes() for name in self.files()]
        first = run("--threads", "2")
        self.assertEqual(first, run("--threads", "2"))
        self.assertEqual(first, run("--threads", "1"))

    def test_quiet(self):
        run = self.unwrap("sphere.off", "--quiet")
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, b"", b""))
        self.assertIn(b"missing.off", self.unwrap("missing.off", "--quiet").stderr)

    def test_no_progress_unless_on_a_terminal(self):
        run = self.unwrap("sphere.off")
        self.assertEqual((run.returncode, run.stdout), (0, b""))
        self.assertNotIn(b"\r", run.stderr)

    def test_progress_for_other_programs(self):
        run = self.unwrap("sphere.off", "--progress", "--quiet")
        self.assertEqual((run.returncode, run.stdout), (0, b""))
        lines = [line.split(" ", 1) for line in run.stderr.decode().splitlines()]
        self.assertGreater(len(lines), 1)
        for percent, phase in lines:
            self.assertTrue(0 <= int(percent) <= 100)
            self.assertIn(phase, ("finding candidates", "filtering", "connecting", "refining", "flattening",
                                  "packing"))
        self.assertIn(["100", "packing"], lines)

    def test_existing_files_are_replaced(self):
        self.write("sphere.uv.obj", "old")
        self.successful_report()
        self.assertEqual(len(read_obj(self.folder / "sphere.uv.obj")[2]), len(SPHERE[1]))

    def test_links_and_devices_stay(self):
        os.symlink("target.obj", self.folder / "link.obj")
        self.successful_report("-o", "link.obj", "--svg", "/dev/null")
        self.assertTrue((self.folder / "link.obj").is_symlink())
        self.assertTrue((self.folder / "target.obj").is_file())
        self.assertFalse(os.path.isfile("/dev/null"))

    def test_failure_leaves_old_files_alone(self):
        self.write("sphere.off", "OFF\n")
        self.write("sphere.uv.obj", "old")
        self.assert_refused(3, "sphere.off", *ALL_OUTPUTS)
        self.assertEqual((self.folder / "sphere.uv.obj").read_text(), "old")

    def test_time_limit(self):
        exit_code, report = self.report("sphere.off", "--time-limit", "0")
        self.assertEqual(exit_code, 6)

    def test_interruption(self):
        self.write("large.off", to_off(sphere(6)))
        program = subprocess.Popen([PROGRAM, "large.off", "--quiet"], cwd=self.folder,
                                   stderr=subprocess.PIPE)
        time.sleep(0.3)
        program.send_signal(signal.SIGINT)
        program.communicate(timeout=TIME_LIMIT)
        self.assertIn(program.returncode, (0, 6))  # it may have been fast enough
        if "large.uv.obj" in self.files():  # the program may not have come to its search
            self.assert_no_flips("large.uv.obj")


main()
