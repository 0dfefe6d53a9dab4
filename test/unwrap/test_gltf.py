"""Binary glTF out and in, read by what the format says."""

import json
import struct

from support import Case, joined, main, sphere, to_off, torus

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
    assert struct.calcsize(form) == view["byteLength"] and view["byteOffset"] % 4 == 0
    values = struct.unpack_from(form, buffer, view["byteOffset"])
    return [values[i:i + number] for i in range(0, len(values), number)]


def write_glb(nodes, points, triangles):
    """A file with one mesh at several nodes."""
    buffer = b"".join(struct.pack("<3f", *p) for p in points) + b"".join(struct.pack("<3I", *t) for t in triangles)
    first = 12 * len(points)
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": [min(p[i] for p in points) for i in range(3)],
                       "max": [max(p[i] for p in points) for i in range(3)]},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": first},
                        {"buffer": 0, "byteOffset": first, "byteLength": len(buffer) - first}],
        "buffers": [{"byteLength": len(buffer)}]}).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON")
            + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


class Gltf(Case):
    def report_if_supported(self, *arguments):
        exit_code, report = self.report(*arguments)
        if "without tinygltf" in report["message"]:
            self.skipTest(report["message"])
        return exit_code, report

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
        exit_code, report = self.report_if_supported("out.glb", "-o", "back.obj")
        self.assertEqual(exit_code, 0, report["message"])
        self.assertEqual((report["vertices"], report["faces"], report["components"], report["borders"]),
                         (2 * len(SPHERE[0]), 2 * len(SPHERE[1]), 2, 0))

    def test_scene(self):
        nodes = [{"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0], "scale": [2, 2, 2]},
                 {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -9, 0, 0, 1]}]  # mirrored
        self.write("in.glb", write_glb(nodes, *SPHERE))
        exit_code, report = self.report_if_supported("in.glb", "-o", "out.obj")
        self.assertEqual(exit_code, 0, report["message"])
        self.assertEqual((report["components"], report["genus"], report["borders"]), (3, 0, 0))
        self.assertFalse([warning for warning in report["warnings"] if "inside out" in warning])

    def test_damaged(self):
        data = write_glb([{"mesh": 0}], *torus())
        self.write("in.glb", data)
        self.report_if_supported("in.glb", "-o", "out.obj")
        for length in range(0, len(data) - 4, 97):
            (self.folder / "out.obj").unlink(missing_ok=True)
            self.assert_refused(3, self.write("in.glb", data[:length]), "-o", "out.obj")
        wrong = data.replace(struct.pack("<3I", *torus()[1][5]), struct.pack("<3I", 1, 2, 1000000))
        self.assert_refused(3, self.write("in.glb", wrong), "-o", "out.obj")


main()
