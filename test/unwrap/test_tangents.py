"""Tangents of glTF files: what --tangents writes is compared with derivatives of the map that the file holds."""

import math

from gltf_files import Builder, File, full
from support import Case, main, octahedron, sphere, to_obj


def minus(p, q):
    return [a - b for a, b in zip(p, q)]


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def normalized(p):
    length = math.sqrt(dot(p, p))
    return tuple(x / length for x in p)


def across(normal, p):
    return normalized(minus(p, [dot(p, normal) * x for x in normal]))


def place(triangle, u, v):
    """Where the plane of a triangle has a texture point; its corners are pairs of texture point and point."""
    (a, p), (b, q), (c, r) = triangle
    whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    second = ((u - a[0]) * (c[1] - a[1]) - (v - a[1]) * (c[0] - a[0])) / whole
    third = ((b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0])) / whole
    return [x + second * (y - x) + third * (z - x) for x, y, z in zip(p, q, r)]


def derivatives(triangle, step=1e-3):
    u, v = triangle[0][0]
    return ([(x - y) / (2 * step) for x, y in zip(place(triangle, u + step, v), place(triangle, u - step, v))],
            [(x - y) / (2 * step) for x, y in zip(place(triangle, u, v + step), place(triangle, u, v - step))])


def corners_with(mesh, normals):
    """A file with one primitive whose triangles share vertices where the mesh does."""
    points, triangles = mesh
    file = Builder()
    attributes = {"POSITION": file.positions(points), "NORMAL": file.accessor(normals, "VEC3")}
    file.description |= {"meshes": [{"primitives": [{
        "attributes": attributes, "indices": file.accessor([v for t in triangles for v in t], "SCALAR", 5123)}]}]}
    return file


def separate(mesh):
    """Each triangle with corners and a normal of its own."""
    points, triangles = mesh
    normals = []
    for a, b, c in triangles:
        normals += 3 * [normalized(cross(minus(points[b], points[a]), minus(points[c], points[a])))]
    return ([points[v] for t in triangles for v in t], [(i, i + 1, i + 2) for i in range(0, 3 * len(triangles), 3)]), normals


class Tangents(Case):
    def tangents(self, name, content, *options):
        """The file after a run, and the report."""
        self.write(name, content)
        exit_code, report = self.report(name, "-o", "out.glb", "--tangents", *options)
        self.assertEqual(exit_code, 0, report["message"])
        self.assertFalse([warning for warning in report["warnings"] if "tangents" in warning])
        return File(self.folder / "out.glb"), report

    def check(self, file, primitive):
        """All tangents. Returns their last numbers, per corner."""
        points, normals, tangents, uvs = (file.numbers_of(primitive["attributes"][name])
                                          for name in ("POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"))
        kind = file.description["accessors"][primitive["attributes"]["TANGENT"]]
        self.assertEqual((kind["componentType"], kind["type"], kind["count"]), (5126, "VEC4", len(points)))
        for normal, tangent in zip(normals, tangents):
            self.assertAlmostEqual(math.hypot(*tangent[:3]), 1, 5)
            self.assertAlmostEqual(dot(normal, tangent), 0, 5)
            self.assertIn(tangent[3], (-1, 1))
        uvs = [(u, 1 - v) for u, v in uvs]  # images begin at the top, and tangents have v point up
        sums, corners = {}, file.corners(primitive)
        for triangle in zip(*[iter(corners)] * 3):
            whole = [(uvs[v], points[v]) for v in triangle]
            (a, _), (b, _), (c, _) = whole
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            by_u, by_v = derivatives(whole)
            for k, v in enumerate(triangle):
                self.assertEqual(tangents[v][3], math.copysign(1, area))
                to_v = [tangents[v][3] * x for x in cross(normals[v], tangents[v][:3])]
                facing = dot(normals[v], cross(minus(whole[1][1], whole[0][1]), minus(whole[2][1], whole[0][1])))
                self.assertGreater(facing, 0)
                self.assertGreater(dot(by_v, to_v), 0)
                sides = [across(normals[v], minus(points[triangle[(k + i) % 3]], points[v])) for i in (1, 2)]
                direction, angle = across(normals[v], by_u), math.acos(max(-1, min(1, dot(*sides))))
                key = (uvs[v], points[v], normals[v], tangents[v][3])
                sums[key] = [x + angle * y for x, y in zip(sums.get(key, (0, 0, 0)), direction)]
        for v in set(corners):
            expected = normalized(sums[uvs[v], points[v], normals[v], tangents[v][3]])
            self.assertLess(math.dist(expected, tangents[v][:3]), 1e-3)
        return [tangents[v][3] for v in corners]

    def test_derivatives(self):
        mesh = [tuple(x * (1 + 0.1 * math.sin(9 * p[0] + 5 * p[1])) for x in p) for p in sphere(3)[0]], sphere(3)[1]
        normals = [(0, 0, 0)] * len(mesh[0])
        for a, b, c in mesh[1]:
            area = cross(minus(mesh[0][b], mesh[0][a]), minus(mesh[0][c], mesh[0][a]))
            for v in (a, b, c):
                normals[v] = [x + y for x, y in zip(normals[v], area)]
        apart, flat = separate(mesh)
        for content in (corners_with(mesh, list(map(normalized, normals))), corners_with(apart, flat)):
            file, _ = self.tangents("in.glb", content.glb())
            self.assertEqual(set(self.check(file, file.primitives()[0])), {1})
        file, _ = self.tangents("in.obj", to_obj(mesh))
        self.assertEqual(set(self.check(file, file.primitives()[0])), {1})

    def test_mirrored(self):
        """Faces that are read backward are clockwise in the texture. Where they share vertices, these are repeated."""
        points, triangles = sphere(2)
        turned = set(range(0, len(triangles), 7))
        mesh = points, [t[::-1] if i in turned else t for i, t in enumerate(triangles)]
        expected = [-1 if i in turned else 1 for i in range(len(triangles)) for _ in range(3)]
        file, report = self.tangents("in.glb", corners_with(*separate(mesh)).glb(), "--weld", "on")
        self.assertEqual([entry["count"] for entry in report["interpreted"] if entry["what"] == "reoriented_faces"],
                         [len(turned)])
        self.assertEqual(self.check(file, file.primitives()[0]), expected)
        file, _ = self.tangents("in.glb", corners_with(mesh, [(0, 0, 1)] * len(points)).glb())
        corners, tangents = (file.corners(file.primitives()[0]),
                             file.numbers_of(file.primitives()[0]["attributes"]["TANGENT"]))
        self.assertEqual([tangents[v][3] for v in corners], expected)

    def test_replaced(self):
        """Former tangents, but nothing else; those of morph targets cannot be kept."""
        content = full()
        targets = content.description["meshes"][0]["primitives"][0]["targets"]
        count = content.description["accessors"][targets[0]["POSITION"]]["count"]
        self.write("in.glb", content.glb())
        self.report("in.glb", "-o", "kept.glb")
        kept = File(self.folder / "kept.glb")
        for name, out in (("in.glb", "out.glb"), ("out.glb", "again.glb")):
            exit_code, report = self.report(name, "-o", out, "--tangents")
            self.assertEqual(exit_code, 0, report["message"])
            self.assertTrue(any(warning.startswith("textures of the file stay") for warning in report["warnings"]))
            self.assertFalse([warning for warning in report["warnings"] if "tangents" in warning])
            file = File(self.folder / out)
            one, two = kept.primitives()[0], file.primitives()[0]
            besides = ("TEXCOORD_0", "TANGENT")
            self.assertEqual(kept.corner_bytes(one, besides), file.corner_bytes(two, besides))
            self.assertEqual(one["attributes"].keys(), two["attributes"].keys())
            self.assertEqual(len(kept.description["accessors"]), len(file.description["accessors"]))
            self.assertNotIn((1, 0, 0, 1), file.numbers_of(two["attributes"]["TANGENT"]))
        targets[0]["TANGENT"] = content.accessor([(0, 0, 1)] * count, "VEC3")
        self.write("in.glb", content.glb())
        _, report = self.report("in.glb", "-o", "out.glb", "--tangents")
        self.assertTrue(any(warning.endswith("tangents of morph targets") for warning in report["warnings"]))
        self.assertNotIn("TANGENT", File(self.folder / "out.glb").primitives()[0]["targets"][0])
        _, report = self.report("in.glb", "-o", "out.glb")
        self.assertFalse([warning for warning in report["warnings"] if "morph" in warning])
        self.assertIn("TANGENT", File(self.folder / "out.glb").primitives()[0]["targets"][0])

    def test_without_direction(self):
        """Vertices that no triangle of the surface uses, and normals without a direction."""
        points, triangles = octahedron()
        content = corners_with((points + [(0, 0, 9), (0, 0, 0)], triangles + [(0, 0, 1)]),
                               [(0, 0, 1)] * 5 + [(0, 0, 0)] + [(0, 1, 0)] * 2)
        file, _ = self.tangents("in.glb", content.glb())
        attributes = file.primitives()[0]["attributes"]
        for normal, tangent in zip(file.numbers_of(attributes["NORMAL"]), file.numbers_of(attributes["TANGENT"])):
            self.assertAlmostEqual(math.hypot(*tangent[:3]), 1, 5)
            self.assertAlmostEqual(dot(normal, tangent), 0, 5)

    def test_parts(self):
        """Primitives without normals need none; two materials share them along their border."""
        points, triangles = sphere(2)
        normals = list(map(normalized, points))
        file = Builder()
        indices = [file.accessor([v for t in triangles[i::2] for v in t], "SCALAR", 5123) for i in range(2)]
        attributes = [{"POSITION": file.positions(points), "NORMAL": file.accessor(normals, "VEC3")} for _ in range(2)]
        bare = {"POSITION": file.positions([(x + 9, y, z) for x, y, z in points])}
        file.description |= {"meshes": [{"primitives": [
            *({"attributes": a, "indices": i} for a, i in zip(attributes, indices)),
            *({"attributes": bare, "indices": i} for i in indices)]}]}
        after, _ = self.tangents("in.glb", file.glb())
        self.assertEqual([len(primitive["attributes"]) for primitive in after.primitives()], [4, 4, 2, 2])
        found = {}
        for primitive in after.primitives()[:2]:
            columns = [after.numbers_of(primitive["attributes"][name]) for name in ("POSITION", "TEXCOORD_0", "TANGENT")]
            for v in after.corners(primitive):
                found.setdefault((columns[0][v], columns[1][v]), set()).add(columns[2][v])
        self.assertEqual({len(tangents) for tangents in found.values()}, {1})

    def test_usage(self):
        self.write("in.obj", to_obj(octahedron()))
        for output in ((), ("-o", "out.obj"), ("-o", "out.ply")):
            self.assertIn("glTF", self.assert_refused(2, "in.obj", "--tangents", *output)["message"])
        self.report("in.obj", "-o", "out.glb")
        self.assertNotIn("TANGENT", File(self.folder / "out.glb").primitives()[0]["attributes"])


main()
