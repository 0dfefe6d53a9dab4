"""Binary glTF out and in, read by what the format says."""

import json
import struct
from fractions import Fraction

from support import Case, joined, main, read_obj, sphere, to_glb, to_off, torus

SPHERE = sphere(2)
COMPONENTS = {5125: "I", 5126: "f"}
NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


def read_glb(path):
    """The description of the file, and its buffer."""
    data = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data)) and length % 4 == 0
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON" and size % 4 == 0
    buffer_size, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0" and buffer_size % 4 == 0
    return json.loads(data[20:20 + size]), data[28 + size:28 + size + buffer_size]


def read_accessor(description, buffer, index):
    accessor = description["accessors"][index]
    view = description["bufferViews"][accessor["bufferView"]]
    number = NUMBERS[accessor["type"]]
    form = f"<{accessor['count'] * number}{COMPONENTS[accessor['componentType']]}"
    first = accessor.get("byteOffset", 0)
    assert view["byteOffset"] % 4 == 0 and first % 4 == 0 and first + struct.calcsize(form) <= view["byteLength"]
    assert view.get("byteStride", 4 * number) == 4 * number
    values = struct.unpack_from(form, buffer, view["byteOffset"] + first)
    return [values[i:i + number] for i in range(0, len(values), number)]


def with_other_text(data, change):
    """The file with the text of its description changed by a function."""
    size, = struct.unpack_from("<I", data, 12)
    text = change(data[20:20 + size].rstrip())
    text += b" " * (-len(text) % 4)
    buffer = data[20 + size:]
    return struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(buffer), len(text), b"JSON") + text + buffer


def without(*keys):
    """A change of a description: some of its entries are gone."""
    def change(text):
        description = json.loads(text)
        return json.dumps({key: value for key, value in description.items() if key not in keys}).encode()
    return change


class Gltf(Case):
    def test_out(self):
        self.write("in.off", to_off(SPHERE))
        exit_code, report = self.report("in.off", "-o", "out.glb", "--texture", "check.png")
        self.assertEqual(exit_code, 0, report["message"])
        self.assertEqual(self.files(), ["check.png", "in.off", "out.glb"])
        description, buffer = read_glb(self.folder / "out.glb")
        primitive = description["meshes"][0]["primitives"][0]
        points = read_accessor(description, buffer, primitive["attributes"]["POSITION"])
        uvs = read_accessor(description, buffer, primitive["attributes"]["TEXCOORD_0"])
        corners = [i for (i,) in read_accessor(description, buffer, primitive["indices"])]
        self.assertEqual([points[i] for i in corners], [SPHERE[0][v] for face in SPHERE[1] for v in face])
        self.assertEqual(len(points), len(uvs))
        accessor = description["accessors"][primitive["attributes"]["POSITION"]]
        self.assertEqual(accessor["min"], [min(p[i] for p in points) for i in range(3)])
        self.assertEqual(accessor["max"], [max(p[i] for p in points) for i in range(3)])
        image = description["bufferViews"][description["images"][0]["bufferView"]]
        self.assertEqual(buffer[image["byteOffset"]:][:image["byteLength"]], (self.folder / "check.png").read_bytes())

    def test_there_and_back(self):
        self.write("in.off", to_off(joined(SPHERE, SPHERE)))
        self.assertEqual(self.report("in.off", "-o", "out.glb")[0], 0)
        exit_code, report = self.report("out.glb", "-o", "back.obj")
        self.assertEqual(exit_code, 0, report["message"])
        self.assertEqual((report["vertices"], report["faces"], report["components"], report["borders"]),
                         (2 * len(SPHERE[0]), 2 * len(SPHERE[1]), 2, 0))

    def test_scene(self):
        nodes = [{"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0], "scale": [2, 2, 2]},
                 {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -9, 0, 0, 1]}]  # mirrored
        self.write("in.glb", to_glb(*SPHERE, nodes))
        exit_code, report = self.report("in.glb", "-o", "out.obj")
        self.assertEqual(exit_code, 0, report["message"])
        self.assertEqual((report["components"], report["genus"], report["borders"]), (3, 0, 0))
        self.assertFalse([warning for warning in report["warnings"] if "inside out" in warning])

    def corners_of(self, name):
        """Per triangle corner: the name of the mesh, that of the material, and all attributes."""
        description, buffer = read_glb(self.folder / name)
        result = []
        for node in description["nodes"]:
            mesh = description["meshes"][node["mesh"]]
            for primitive in mesh["primitives"]:
                attributes = {key: read_accessor(description, buffer, index)
                              for key, index in primitive["attributes"].items()}
                for (i,) in read_accessor(description, buffer, primitive["indices"]):
                    result.append((mesh.get("name"), description["materials"][primitive["material"]].get("name"),
                                   {key: values[i] for key, values in attributes.items()}))
        return result

    def test_computed_normals(self):
        """They are unit vectors, the same on both sides of a cut, and like those of an ellipsoid."""
        points, faces = sphere(4)
        self.write("in.off", to_off((points, faces)))
        self.report("in.off", "-o", "out.glb")
        normals = {}
        for _, _, corner in self.corners_of("out.glb"):
            self.assertNotIn("COLOR_0", corner)
            normals.setdefault(corner["POSITION"], set()).add(corner["NORMAL"])
        self.assertEqual(len(normals), len(points))
        for (x, y, z), (normal, *others) in normals.items():
            self.assertEqual(others, [])
            gradient = (x, y / 1.25 ** 2, z / 1.5 ** 2)
            length = sum(c * c for c in gradient) ** 0.5
            self.assertAlmostEqual(sum(c * c for c in normal), 1, 5)
            self.assertGreater(sum(a * b for a, b in zip(normal, gradient)) / length, 0.99)

    def test_what_obj_says(self):
        """Normals where there are any, colors, groups and materials; and all of it back to OBJ."""
        points, faces = SPHERE
        lines = [f"v {x!r} {y!r} {z!r} {i % 3 / 2} 0 1" for i, (x, y, z) in enumerate(points)]
        lines += ["vn 0 0 4", "vn 0 0 0"]
        for i, face in enumerate(faces):
            lines += {0: ["o thing", "usemtl red"], 50: ["g half"], 70: ["usemtl blue"]}.get(i, [])
            normal = ("//1", "//2", "")[i % 3]  # of which only the first is one
            lines.append("f " + " ".join(f"{v + 1}{normal}" for v in face))
        self.write("in.obj", "\n".join(lines) + "\n")
        self.report("in.obj", "-o", "out.glb")
        by_part = {}
        for name, material, corner in self.corners_of("out.glb"):
            by_part.setdefault((name, material), []).append(corner)
        self.assertEqual({part: len(corners) // 3 for part, corners in by_part.items()},
                         {("thing", "red"): 50, ("thing half", "red"): 20, ("thing half", "blue"): len(faces) - 70})
        colors = {point: (i % 3 / 2, 0, 1) for i, point in enumerate(points)}
        corners = [corner for _, _, corner in self.corners_of("out.glb")]
        self.assertTrue(all(corner["COLOR_0"] == colors[corner["POSITION"]] for corner in corners))
        for corner in corners:
            self.assertAlmostEqual(sum(c * c for c in corner["NORMAL"]), 1, 5)
        given = sum(corner["NORMAL"] == (0, 0, 1) for corner in corners)
        self.assertGreaterEqual(given, 3 * len(faces[::3]))
        self.assertLess(given, 3 * len(faces[::3]) + 12)  # the poles

        self.report("out.glb", "-o", "back.obj")
        before, after = (sorted(self.polygons_by_part(name)) for name in ("in.obj", "back.obj"))
        self.assertEqual([part[2] for part in before], [part[2] for part in after])
        self.assertEqual([part[1] for part in before], [part[1] for part in after])

    def polygons_by_part(self, name):
        """Per face: its points, its material, and their colors."""
        points, material, result = [], None, []
        for words in (line.split() for line in (self.folder / name).read_text().splitlines()):
            if words[0] == "v":
                points.append(tuple(map(float, words[1:])))
            elif words[0] == "usemtl":
                material = words[1]
            elif words[0] == "f":
                corners = [points[int(word.split("/")[0]) - 1] for word in words[1:]]
                first = corners.index(min(corners))
                corners = corners[first:] + corners[:first]
                result.append((tuple(c[:3] for c in corners), material, tuple(c[3:] for c in corners)))
        return result

    def test_strips_and_fans(self):
        points = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0)]
        for mode, triangles in ((5, {(0, 1, 2), (1, 3, 2), (2, 3, 4)}), (6, {(0, 1, 2), (0, 2, 3), (0, 3, 4)})):
            form = b'"indices": 1', b'"indices": 1, "mode": %d' % mode
            self.write("in.glb", with_other_text(to_glb(points, [(0, 1, 2), (3, 4, 4)]), lambda text:
                                                 text.replace(*form).replace(b'"count": 6', b'"count": 5')))
            self.report("in.glb", "-o", "out.obj", "--allow-overlap")
            points_out, _, faces = read_obj(self.folder / "out.obj")
            found = {tuple(points.index(tuple(points_out[v])) for v, _ in face) for face in faces}
            rotations = lambda t: min((t, t[1:] + t[:1], t[2:] + t[:2]))
            self.assertEqual({rotations(t) for t in found}, {rotations(t) for t in triangles}, mode)

    def test_no_scene(self):
        """All nodes that do not hang below another one are read, each once."""
        nodes = [{"mesh": 0, "translation": [9, 0, 0]}, {"mesh": 0, "children": [0]}, {"mesh": 0, "translation": [0, 9, 0]}]
        self.write("in.glb", with_other_text(to_glb(*SPHERE, nodes), without("scene", "scenes")))
        exit_code, report = self.report("in.glb", "-o", "out.obj")
        self.assertEqual((exit_code, report["components"]), (0, 3), report["message"])

    def test_not_supported(self):
        """The reason is told."""
        data = to_glb(*SPHERE)
        self.write("in.glb", data)
        self.report("in.glb", "-o", "out.obj")
        first = {"asset": {"version": "1.0"}, "scene": "main", "scenes": {"main": {"nodes": []}}}
        compressed = with_other_text(data, lambda text: text.replace(
            b'"scene": 0', b'"scene": 0, "extensionsRequired": ["KHR_draco_mesh_compression"]'))
        for name, content, reason, program in (("in.glb", data.replace(b"glTF\2", b"glTF\1", 1), "glTF 1 ", "gltf-pipeline"),
                                               ("in.gltf", json.dumps(first), "glTF 1 ", "gltf-pipeline"),
                                               ("in.glb", compressed, "KHR_draco_mesh_compression", "gltf-transform")):
            (self.folder / "out.obj").unlink(missing_ok=True)
            message = self.assert_refused(3, self.write(name, content), "-o", "out.obj")["message"]
            self.assertIn(reason, message)
            self.assertIn(program, message)

    def test_single_precision(self):
        """The layout is proven as the file holds it: what is lost is counted and told."""
        for number, (name, mesh) in ((10, ("strip", None)), (29, ("strip", None)), (0, ("sphere", SPHERE))):
            points, faces = mesh or ([(0.5 ** i, 0.5 ** i * (i % 2), 0) for i in range(2 * number)],
                                     [(i, i + 1 + i % 2, i + 2 - i % 2) for i in range(2 * number - 2)])
            self.write("in.off", to_off((points, faces)))
            for options in ((), ("--uv-scale", "surface")):
                exit_code, report = self.report("in.off", "-o", "out.glb", *options)
                self.assertEqual(exit_code, 0, report["message"])
                description, buffer = read_glb(self.folder / "out.glb")
                primitive = description["meshes"][0]["primitives"][0]
                uvs = [(Fraction(u), -Fraction(v)) for u, v in
                       read_accessor(description, buffer, primitive["attributes"]["TEXCOORD_0"])]
                corners = [uvs[i] for (i,) in read_accessor(description, buffer, primitive["indices"])]
                flips = sum((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0
                            for a, b, c in zip(*[iter(corners)] * 3))
                self.assertEqual(report["flips"], flips, (name, number))
                self.assertEqual(any("single precision" in warning for warning in report["warnings"]),
                                 flips > 0 or report["overlaps"] > 0)
                if number < 20:
                    self.assertEqual((flips, report["overlaps"]), (0, 0))

    def test_damaged(self):
        data = to_glb(*torus())
        self.write("in.glb", data)
        self.report("in.glb", "-o", "out.obj")
        for length in range(0, len(data) - 4, 97):
            (self.folder / "out.obj").unlink(missing_ok=True)
            self.assert_refused(3, self.write("in.glb", data[:length]), "-o", "out.obj")
        wrong = data.replace(struct.pack("<3I", *torus()[1][5]), struct.pack("<3I", 1, 2, 1000000))
        self.assert_refused(3, self.write("in.glb", wrong), "-o", "out.obj")


main()
