"""Meshes that are no manifolds of triangles: nothing is repaired, everything is interpreted."""

import random
import re
from collections import Counter

from support import Case, joined, main, octahedron, read_obj, selection, sphere, to_binary_stl, to_obj, to_off, torus

SEED = 20261122
SPHERE = sphere(2)
QUADS = [tuple(pair[0]) + (pair[1][2],) for pair in zip(torus(8)[1][::2], torus(8)[1][1::2])]
TORUS = ([(x + 0.1 * y, y - 0.2 * x * x, z + 0.01 * x * y) for x, y, z in torus(8)[0]], QUADS)


def pairs(face):
    return [frozenset(pair) for pair in zip(face, face[1:] + face[:1])]


def without_repetitions(face):
    """Of neighbors; these corners count as one."""
    return tuple(v for v, former in zip(face, face[-1:] + face[:-1]) if v != former)


def is_degenerate(face):
    """Of three or four corners, of which no neighbors are equal."""
    return len(set(face)) < 3


def rotated(face):
    start = face.index(min(face))
    return tuple(face[start:] + face[:start])


def expected_counts(faces):
    """By the definitions, those kinds that do not depend on how sheets are connected."""
    counts, surface, former = Counter(), [], set()
    for given in faces:
        face = without_repetitions(given)
        if is_degenerate(face):
            counts["degenerate_faces"] += 1
        elif rotated(face) in former:
            counts["duplicate_faces"] += 1
        else:
            counts["repeated_corners"] += len(face) < len(given)
            surface.append(face)
            former.add(rotated(face))
    edges = Counter(pair for face in surface for pair in pairs(face))
    counts["non_manifold_edges"] = sum(number > 2 for number in edges.values())
    for vertex in {v for face in surface for v in face}:
        links = [{p for p in pairs(face) if vertex in p} for face in surface if vertex in face]
        fan = links.pop()
        while any(link & fan for link in links):
            fan |= set().union(*(link for link in links if link & fan))
            links = [link for link in links if not link <= fan]
        counts["non_manifold_vertices"] += bool(links)
    return +counts


class Interpretation(Case):
    def unwrap_all(self, mesh, *options):
        """The report of a run that leaves points and faces as they are."""
        self.write("in.obj", to_obj(mesh))
        exit_code, report = self.report("in.obj", "-o", "out.obj", *options)
        self.assertEqual(exit_code, 0, report["message"])
        self.assertEqual(report["flips"], 0)
        points, uvs, faces = read_obj(self.folder / "out.obj")
        self.assertEqual(points, [tuple(map(float, point)) for point in mesh[0]])
        self.assertEqual([tuple(v for v, _ in face) for face in faces], [tuple(face) for face in mesh[1]])
        self.assertTrue(all(0 <= uv < len(uvs) for face in faces for _, uv in face))
        self.assertEqual(report["polygons"], sum(len(face) != 3 for face in mesh[1]))
        for finding in report["interpreted"]:
            self.assertEqual(finding["count"], len(finding["elements"]))
            self.assertGreater(finding["count"], 0)
        return report, {finding["what"]: finding["elements"] for finding in report["interpreted"]}

    def test_polygons(self):
        report, interpreted = self.unwrap_all(TORUS)
        self.assertEqual((report["genus"], report["components"], interpreted), (1, 1, {}))
        concave = ([(0, 0, 0), (4, 0, 0), (4, 4, 0), (2, 0.5, 0), (0, 4, 0)], [(0, 1, 2, 3, 4)])
        report, _ = self.unwrap_all(concave)
        self.assertAlmostEqual(report["E_iso"], 4)
        self.assert_refused(4, "in.obj", "-o", "other.obj", "--strict")

    def test_findings(self):
        print(f"seed {SEED}")
        generator = random.Random(SEED)
        for number in range(60):
            mesh = generator.choice((SPHERE, TORUS, joined(octahedron(), octahedron())))
            faces = [list(face) for face in mesh[1]]
            for _ in range(generator.randrange(1, 8)):
                face = generator.choice(faces)
                kind = generator.randrange(5)
                if kind == 0:
                    face.reverse()
                elif kind == 1:
                    faces.append(face[1:] + face[:1])
                elif kind == 2:
                    face[generator.randrange(len(face))] = generator.randrange(len(mesh[0]))
                elif kind == 3:
                    faces.append([face[0], face[1], generator.randrange(len(mesh[0]))])
                else:
                    faces.remove(face)
            with self.subTest(number=number):
                _, interpreted = self.unwrap_all((mesh[0], faces))
                counts = {what: len(elements) for what, elements in interpreted.items()
                          if what not in ("reoriented_faces", "non_orientable_edges")}
                self.assertEqual(counts, expected_counts([tuple(face) for face in faces]))

    def test_welding(self):
        soup = ([SPHERE[0][v] for face in SPHERE[1] for v in face],
                [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(SPHERE[1]))])
        welded = len(soup[0]) - len(SPHERE[0])
        for options, components in (((), 1), (("--weld", "on"), 1), (("--weld", "off"), len(SPHERE[1])),
                                    (("--strict",), len(SPHERE[1]))):
            report, interpreted = self.unwrap_all(soup, *options)
            self.assertEqual(report["components"], components)
            self.assertEqual(len(interpreted.get("welded_vertices", [])), welded if components == 1 else 0)
        self.write("a.stl", to_binary_stl(SPHERE))
        self.assertEqual(self.report("a.stl")[1]["components"], 1)
        self.assertEqual(self.report("a.stl", "--weld", "off")[1]["components"], len(SPHERE[1]))

    def test_welding_where_few_share(self):
        """Programs that write each triangle for itself may still let the halves of a quadrilateral share points."""
        points, faces = sphere(4)
        for number_of_pairs in (1, len(faces) // 4):
            corners, soup, of_edges = [], [], {}  # of the faces that are in no pair
            for face in faces:
                partner = next((of_edges[edge] for edge in pairs(face) if edge in of_edges), {}) if number_of_pairs else {}
                number_of_pairs -= bool(partner)
                of_edges = {edge: found for edge, found in of_edges.items() if found is not partner}
                shared = {v: partner[v] for v in face if v in partner}
                soup.append(tuple(shared.get(v, len(corners) + k) for k, v in enumerate(face)))
                corners += [points[v] for v in face]
                if not partner:
                    of_edges.update(dict.fromkeys(pairs(face), dict(zip(face, soup[-1]))))
            self.assertEqual(number_of_pairs, 0)
            report, _ = self.unwrap_all((corners, soup), "--effort", "fast")
            self.assertEqual(report["components"], 1)

    def test_obj_keeps_what_it_says(self):
        lines = ["# made by a test", "mtllib a.mtl", "o thing"]
        lines += ["v " + " ".join(map(repr, point)) + " 0.5 0.25 1" for point in SPHERE[0]]
        lines += ["vt 0 0"] + ["vn " + " ".join(map(repr, point)) for point in SPHERE[0]]
        for i, face in enumerate(SPHERE[1]):
            lines += {0: ["g first half", "usemtl red"], 40: ["s 1"], 64: ["g", "usemtl blue"]}.get(i, [])
            lines.append("f " + " ".join(f"{v + 1}/1/{v + 1}" for v in face))
        self.write("in.obj", "\n".join(lines) + "\n")
        exit_code, report = self.report("in.obj", "-o", "out.obj")
        self.assertEqual(exit_code, 0, report["message"])

        def kept(path):  # without texture points
            result = []
            for line in path.read_text().splitlines():
                if line.startswith("f "):
                    line = re.sub("/[0-9]+/", "//", line)
                elif line.startswith(("v ", "vn ")):
                    keyword, *numbers = line.split()
                    line = " ".join([keyword, *(repr(float(word)) for word in numbers)])
                if not line.startswith(("#", "vt ")):
                    result.append(line)
            return result

        before, after = kept(self.folder / "in.obj"), kept(self.folder / "out.obj")
        for keyword in ("v ", "vn ", "f "):
            self.assertEqual([line for line in after if line.startswith(keyword)],
                             [line for line in before if line.startswith(keyword)])
        statements = ("f", "g", "o", "s", "usemtl", "mtllib")
        self.assertEqual([line for line in after if line.split()[0] in statements],
                         [line for line in before if line.split()[0] in statements])
        self.report("in.obj", "-o", "out.obj", "--texture", "check.png")
        self.assertIn("mtllib out.mtl", kept(self.folder / "out.obj"))
        self.assertNotIn("usemtl red", kept(self.folder / "out.obj"))

    def test_constraints_name_edges_of_the_input(self):
        points, faces = joined(octahedron(), octahedron())
        touching = [tuple(0 if v == 6 else v for v in face) for face in faces]  # in a vertex
        self.write("in.off", to_off((points, touching)))
        self.write("edges.txt", selection(edges=[(0, 8), (0, 2)], vertices=[0]))
        exit_code, report = self.report("in.off", "-o", "out.obj", "--must-cut", "edges.txt", "--terminals", "edges.txt",
                                        "--obj-cut", "cut.obj")
        self.assertEqual(exit_code, 0, report["message"])
        self.write("wrong.txt", selection(edges=[(0, 1)]))
        self.assert_refused(4, "in.off", "--must-cut", "wrong.txt")


main()
