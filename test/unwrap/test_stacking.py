"""--stack: congruent parts are cut once and lie on one place; and --min-fill: long charts are divided."""

import math
import random
import resource

from atlas import charts_of, check_atlas
from support import Case, main, read_obj, sphere, to_off


def part(seed):
    """An irregular part: no two edges have the same length."""
    numbers = random.Random(seed)
    points, faces = sphere(1)
    return [tuple(x * numbers.uniform(0.8, 1.2) for x in p) for p in points], faces


def processor_seconds():
    """Those of all runs so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def screw(segments=10, rings=16):
    """A thread with a head, whose mirror image it is not."""
    points = [(0, 0, -1)]
    for ring in range(rings):
        for segment in range(segments):
            angle = 2 * math.pi * segment / segments
            radius = 2 if ring < 2 else 1 + 0.2 * math.cos(angle - 1.5 * ring)
            points.append((radius * math.cos(angle), radius * math.sin(angle), 0.4 * ring - 0.8 * (ring == 0)))
    points.append((0, 0, 0.4 * rings))
    faces = []
    for i in range(segments):
        a, b = 1 + i, 1 + (i + 1) % segments
        faces.append((0, b, a))
        for _ in range(rings - 1):
            faces += [(a, b, b + segments), (a, b + segments, a + segments)]
            a, b = a + segments, b + segments
        faces.append((a, b, len(points) - 1))
    return points, faces


def turned(mesh, seed, is_mirrored):
    numbers = random.Random(seed)
    a, b = numbers.uniform(0, 7), numbers.uniform(0, 7)
    place = [numbers.uniform(-50, 50) for _ in range(3)]
    points = []
    for x, y, z in mesh[0]:
        x = -x if is_mirrored else x
        x, y = math.cos(a) * x - math.sin(a) * y, math.sin(a) * x + math.cos(a) * y
        y, z = math.cos(b) * y - math.sin(b) * z, math.sin(b) * y + math.cos(b) * z
        points.append(tuple(s + t for s, t in zip((x, y, z), place)))
    order = list(range(len(mesh[1])))
    numbers.shuffle(order)
    names = list(range(len(points)))
    numbers.shuffle(names)  # of the points
    renamed = [None] * len(points)
    for i, name in enumerate(names):
        renamed[name] = points[i]
    faces = []
    for f in order:
        face = [names[v] for v in mesh[1][f]]
        face = face[::-1] if is_mirrored else face
        k = numbers.randrange(3)
        faces.append(tuple(face[k:] + face[:k]))
    return renamed, faces


def scene_of(meshes):
    points, faces = [], []
    for mesh in meshes:
        faces += [tuple(v + len(points) for v in face) for face in mesh[1]]
        points += mesh[0]
    return points, faces


def scene(kinds):
    """`kinds`: of each part, its number and whether it is mirrored."""
    return scene_of(turned(part(kind), i, is_mirrored) for i, (kind, is_mirrored) in enumerate(kinds))


class Stacking(Case):
    def lengths(self, points, uvs, faces):
        """The lengths, for each component, of the edges on the surface and in the plane."""
        size = len(part(0)[1])
        return [sorted((round(math.dist(points[face[k][0]], points[face[k - 1][0]]), 6),
                        round(math.dist(uvs[face[k][1]], uvs[face[k - 1][1]]), 6))
                       for face in faces[i:i + size] for k in range(3)) for i in range(0, len(faces), size)]

    def test_congruent_parts(self):
        kinds = [(0, False), (1, False), (0, True), (0, False), (1, True), (2, False), (0, True)]
        self.write("a.off", to_off(scene(kinds)))
        code, report = self.report("a.off", "-o", "a.obj", "--stack")
        self.assertEqual((code, report["components"], report["genus"], report["borders"]), (0, 7, 0, 0), report["message"])
        self.assertEqual(report["stacked"], [[0, 2, 3, 6], [1, 4]])
        points, uvs, faces = read_obj(self.folder / "a.obj")
        lengths, size = self.lengths(points, uvs, faces), len(part(0)[1])
        for stack in report["stacked"]:
            places = [{uvs[v] for face in faces[i * size:(i + 1) * size] for _, v in face} for i in stack]
            for i, place in zip(stack, places):
                self.assertEqual(lengths[i], lengths[stack[0]])
                self.assertEqual(place, places[0])  # to the last bit
        # One of each is a layout as any other one.
        originals = [face for i in (0, 1, 5) for face in faces[i * size:(i + 1) * size]]
        self.assertEqual(check_atlas(self, uvs, originals, [0] * len(originals), 2, 1024), report["charts"])
        for i, (_, is_mirrored) in enumerate(kinds):
            for face in faces[i * size:(i + 1) * size]:
                a, b, c = (uvs[v] for _, v in face)
                self.assertEqual((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0, is_mirrored)
        # The layout is that of the originals alone.
        self.write("b.off", to_off(scene([(0, False), (1, False), (2, False)])))
        alone = self.report("b.off", "-o", "b.obj", "--stack")[1]
        self.assertEqual(alone["stacked"], [])
        self.assertEqual(alone["charts"], report["charts"])
        self.assertAlmostEqual(alone["E_iso"], report["E_iso"], delta=0.05)

    def test_crate(self):
        """Of 64 equal and 64 mirrored screws, one is cut, mapped and packed."""
        one = screw()
        crate = [one] + [turned(one, i, i % 2 == 1) for i in range(1, 128)]
        reports, layouts, seconds = {}, {}, {}
        for name, mesh in (("one", one), ("crate", scene_of(crate))):
            self.write(name + ".off", to_off(mesh))
            start = processor_seconds()
            code, reports[name] = self.report(name + ".off", "-o", name + ".obj", "--stack", "--effort", "fast")
            self.assertEqual(code, 0, reports[name]["message"])
            seconds[name] = processor_seconds() - start
            _, uvs, faces = read_obj(self.folder / (name + ".obj"))
            layouts[name] = [[uvs[v] for _, v in face] for face in faces]
        self.assertEqual(reports["crate"]["stacked"], [list(range(128))])
        self.assertEqual(reports["crate"]["components"], 128)
        size = len(one[1])
        places = [set(map(frozenset, layouts["crate"][i:i + size])) for i in range(0, 128 * size, size)]
        self.assertTrue(all(place == places[0] for place in places))
        self.assertEqual(len(places[0]), size)
        # The cut of the screw alone may differ, as its edges have other numbers there.
        self.assertEqual(reports["crate"]["charts"], reports["one"]["charts"])
        self.assertAlmostEqual(reports["crate"]["fill"], reports["one"]["fill"], delta=0.1)
        work = {name: report["factorized_unknowns"]["total"] for name, report in reports.items()}
        print("factorized unknowns:", work, "processor seconds:", seconds)
        self.assertLess(work["crate"], 1.5 * work["one"])
        self.assertLess(seconds["crate"], 16 * seconds["one"])  # as all are read, compared and written

    def test_tolerance(self):
        points, faces = scene([(0, False), (0, False)])
        points[-1] = tuple(x + 0.01 for x in points[-1])
        self.write("a.off", to_off((points, faces)))
        self.assertEqual(self.report("a.off", "--stack")[1]["stacked"], [])
        self.assertEqual(self.report("a.off", "--stack", "--stack-tolerance", "0.01")[1]["stacked"], [[0, 1]])
        self.assertIsNone(self.report("a.off")[1]["stacked"])

    def test_constraints_on_a_copy(self):
        points, faces = scene([(0, False), (0, True)])
        self.write("a.off", to_off((points, faces)))
        edge = faces[-1][:2]
        self.write("must.selection.txt", f"\n\n{edge[0]} {edge[1]}\n")
        self.assertEqual(self.report("a.off", "-o", "a.obj", "--stack", "--must-cut", "must.selection.txt")[0], 0)
        _, _, corners = read_obj(self.folder / "a.obj")
        sides = [dict(face) for face in corners if set(edge) <= {v for v, _ in face}]
        self.assertEqual(len(sides), 2)
        self.assertTrue(any(sides[0][v] != sides[1][v] for v in edge))

    def test_outputs(self):
        self.write("a.off", to_off(scene([(0, False), (0, True)])))
        for name in ("a.glb", "a.ply", "a.obj"):
            run = self.unwrap("a.off", "-o", name, "--stack", "--svg", "a.svg", "--obj-cut", "c.obj", "--quiet")
            self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("nan", (self.folder / "a.svg").read_text())
        self.assertEqual((self.folder / "c.obj").read_text().count("\nl ") % 2, 0)

    def test_errors(self):
        self.write("a.off", to_off(scene([(0, False)])))
        for words in (["--lightmap", "64"], ["--pack-only"], ["--stack-tolerance", "1"]):
            self.assert_refused(2, "a.off", "--stack", *words)


def ribbon(length, width=0.2):
    """A long strip in a plane, wound up as a spiral in space so that its chart is straight."""
    points, faces = [], []
    for i in range(length + 1):
        for y in (0, width):
            points.append((i * 0.5 + 0.01 * math.sin(i), y, 0))
    for i in range(length):
        a = 2 * i
        faces += [(a, a + 2, a + 3), (a, a + 3, a + 1)]
    return points, faces


class Fill(Case):
    def test_long_chart(self):
        self.write("a.off", to_off(ribbon(120)))
        code, plain = self.report("a.off", "-o", "a.obj")
        self.assertEqual((code, plain["charts"]), (0, 1), plain["message"])
        self.assertLess(plain["fill"], 0.05)
        self.assertTrue(any("--min-fill" in warning for warning in plain["warnings"]))
        code, divided = self.report("a.off", "-o", "b.obj", "--min-fill", "0.5")
        self.assertEqual(code, 0, divided["message"])
        self.assertGreaterEqual(divided["fill"], 0.5)
        self.assertGreater(divided["charts"], 5)
        self.assertFalse(any("--min-fill" in warning for warning in divided["warnings"]))
        points, uvs, faces = read_obj(self.folder / "b.obj")
        self.assertEqual(check_atlas(self, uvs, faces, [0] * len(faces), 2, 1024), divided["charts"])
        self.assert_no_flips("b.obj")
        # Its seams are short, and their length is told.
        self.assertEqual(len(set(charts_of(faces))), divided["charts"])
        diagonal = math.dist(points[0], points[-1])
        self.assertLess(divided["cut_length"] * diagonal, 0.7 * divided["charts"])
        self.assertGreater(divided["cut_length"] * diagonal, 0.19 * (divided["charts"] - 1))

    def test_not_worth_it(self):
        self.write("a.off", to_off(sphere(1)))
        code, report = self.report("a.off", "--min-fill", "0.999")
        self.assertEqual(code, 0, report["message"])
        self.assertTrue(any("not worth it" in warning for warning in report["warnings"]))
        self.assert_refused(2, "a.off", "--min-fill", "1.5")
        self.assert_refused(2, "a.off", "--min-fill", "0.5", "--texels-per-unit", "7")


main()
