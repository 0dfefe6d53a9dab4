"""What the program keeps of a glTF file: everything but the texture coordinates, checked byte for byte."""

import json
import struct
from fractions import Fraction

from gltf_files import IMAGE, Builder, File, full, without_data
from support import Case, main, octahedron, read_obj, sphere

# A cube whose faces have vertices of their own.
AXES = [(axis, side) for axis in range(3) for side in (-1, 1)]
CUBE = []
for axis, side in AXES:
    for a, b in ((-1, -1), (side, -side), (1, 1), (-side, side)):
        point = [0, 0, 0]
        point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
        CUBE.append(tuple(point))
NORMALS = [tuple(side if i == axis else 0 for i in range(3)) for axis, side in AXES for _ in range(4)]
FACES = [v for f in range(6) for v in (4 * f, 4 * f + 1, 4 * f + 2, 4 * f, 4 * f + 2, 4 * f + 3)]


class Kept(Case):
    def edit(self, content, name="in.glb", out="out.glb", *options):
        """The file before and after a run, and the report."""
        self.write(name, content)
        exit_code, report = self.report(name, "-o", out, *options)
        self.assertEqual((exit_code, report["flips"], report["overlaps"]), (0, 0, 0), report["message"])
        before, after = File(self.folder / name), File(self.folder / out)
        self.assertEqual(without_data(after.description), without_data(before.description))
        self.assertEqual(after.description["asset"], before.description["asset"])
        for one, two in zip(before.primitives(), after.primitives(), strict=True):
            if one.get("mode", 4) >= 4:
                self.assert_unwrapped_alike(before, one, after, two)
            else:
                self.assertEqual(before.corner_bytes(one, ()), after.corner_bytes(two, ()))
        return before, after, report

    def assert_unwrapped_alike(self, before, one, after, two):
        """The corners have the same attributes, but for texture coordinates, which form triangles."""
        self.assertEqual(before.corner_bytes(one), after.corner_bytes(two))
        for objects in [(one["attributes"], two["attributes"]), *zip(one.get("targets", []), two.get("targets", []))]:
            for name in objects[0]:
                if name != "TEXCOORD_0":
                    old, new = (file.description["accessors"][attributes[name]]
                                for file, attributes in zip((before, after), objects))
                    for key in ("componentType", "type", "normalized", "min", "max", "name"):
                        self.assertEqual(old.get(key), new.get(key), name)
        uvs = after.numbers_of(two["attributes"]["TEXCOORD_0"])
        corners = after.corners(two)
        points = before.numbers_of(one["attributes"]["POSITION"])
        for triangle, at in zip(zip(*[iter(corners)] * 3), zip(*[iter(before.corners(one))] * 3)):
            a, b, c = ([Fraction(u), -Fraction(v)] for u, v in (uvs[i] for i in triangle))
            if len({points[i] for i in at}) == 3:
                self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)
        self.assertTrue(all(0 <= x <= 1 for uv in uvs for x in uv))

    def test_everything(self):
        content = full()
        for name, out in (("in.glb", "out.glb"), ("in.gltf", "out.gltf"), ("in.glb", "other.gltf"), ("in.gltf", "other.glb")):
            before, after, report = self.edit(content.glb() if name == "in.glb" else content.gltf(), name, out)
            with self.subTest(name=name, out=out):
                self.assertEqual(after.other_bytes(), before.other_bytes())
                self.assertEqual(after.view(after.description["images"][0]["bufferView"]), IMAGE)
                count = after.description["accessors"][after.primitives()[0]["attributes"]["POSITION"]]["count"]
                self.assertGreater(count, len(sphere(1)[0]))  # vertices are repeated at seams, and only there
                self.assertLess(count, 2 * len(sphere(1)[0]))
                self.assertLess(len(after.buffer), 2 * len(before.buffer))  # without the former data
                self.assertIn("textures and tangents", report["warnings"][0])

    def test_twice(self):
        """The second run replaces what the first one added."""
        self.edit(full().glb())
        _, once, _ = self.edit((self.folder / "out.glb").read_bytes(), "once.glb", "twice.glb")
        self.assertLess(len(once.buffer), 1.5 * len(File(self.folder / "once.glb").buffer))

    def test_lost_in_other_formats(self):
        self.write("in.glb", full().glb())
        for name in ("out.obj", "out.ply"):
            warnings = " ".join(self.report("in.glb", "-o", name)[1]["warnings"])
            for kind in ("animations", "skins", "morph targets", "cameras", "tangents", "textures", "lines", "extras",
                         "other sets of texture coordinates", "transparency"):
                self.assertIn(kind, warnings)

    def test_colors_of_faces(self):
        file = Builder()
        colors = [(i // 4 * 40, 0, 255 - i // 4, 128) for i in range(24)]
        attributes = {"POSITION": file.positions(CUBE), "NORMAL": file.accessor(NORMALS, "VEC3"),
                      "COLOR_0": file.accessor(colors, "VEC4", 5121, normalized=True)}
        file.description |= {"meshes": [{"primitives": [{"attributes": attributes,
                                                         "indices": file.accessor(FACES, "SCALAR", 5123)}]}]}
        _, after, report = self.edit(file.glb())
        self.assertEqual((report["vertices"], report["components"], report["charts"]), (8, 1, 1))
        self.assertEqual(len(set(after.numbers_of(after.primitives()[0]["attributes"]["COLOR_0"]))), 6)

        # OBJ has them at points, which are repeated; the surface stays connected.
        _, report = self.report("in.glb", "-o", "out.obj")
        self.assertEqual((report["components"], report["charts"]), (1, 1))
        self.assertEqual([warning for warning in report["warnings"] if "isolated" in warning], [])
        lines = [line.split() for line in (self.folder / "out.obj").read_text().splitlines()]
        colors = {tuple(map(float, words[1:4])): set() for words in lines if words[0] == "v"}
        for words in lines:
            if words[0] == "v":
                colors[tuple(map(float, words[1:4]))].add(words[4])
        self.assertEqual([len(reds) for reds in colors.values()], [3] * 8)

    def test_meshes_stay_apart(self):
        """Even where nothing in them is connected."""
        points, triangles = octahedron()
        file = Builder()
        file.description |= {"meshes": [{"primitives": [{"attributes": {"POSITION": file.positions([points[v] for v in t])}}]}
                                        for t in triangles]}
        for weld in ("auto", "on"):
            _, _, report = self.edit(file.glb(), "in.glb", "out.glb", "--weld", weld)
            self.assertEqual((report["components"], report["charts"]), (8, 8))

    def test_kinds_of_accessors(self):
        """Quantized, interleaved and sparse data; strips and fans, and triangles without indices."""
        quantized = [tuple(int(32767 * x) for x in p) for p in CUBE]
        file = Builder(extensionsUsed=["KHR_mesh_quantization"], extensionsRequired=["KHR_mesh_quantization"])
        small = {"POSITION": file.positions(quantized, 5122, normalized=True),
                 "NORMAL": file.accessor([tuple(127 * x for x in n) for n in NORMALS], "VEC3", 5120, normalized=True),
                 "TEXCOORD_0": file.accessor([(i, 9 * i) for i in range(24)], "VEC2", 5123, normalized=True)}
        bytes_only = {"POSITION": file.positions([tuple(100 * x + 20 for x in p) for p in CUBE], 5120)}
        rows = [struct.pack("<3f3f", *p, *n) for p, n in zip(CUBE, NORMALS)]
        view = file.view(b"".join(rows), byteStride=24)
        mixed = {}
        for name, offset in (("POSITION", 0), ("NORMAL", 12)):
            mixed[name] = len(file.description["accessors"])
            file.description["accessors"].append({"bufferView": view, "byteOffset": offset, "componentType": 5126, "count": 24,
                                                  "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]})
        sparse = {"POSITION": len(file.description["accessors"])}
        file.description["accessors"].append({
            "componentType": 5126, "count": 24, "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1],
            "sparse": {"count": 24,
                       "indices": {"bufferView": file.view(struct.pack("<24B", *range(24))), "componentType": 5121},
                       "values": {"bufferView": file.view(b"".join(struct.pack("<3f", *p) for p in CUBE))}}})
        indices = file.accessor(FACES, "SCALAR", 5123)
        plain = {"POSITION": file.positions([CUBE[v] for v in FACES])}
        band = [(x / 2, y, (x // 2) % 2) for x in range(5) for y in range(2)]
        strip = {"POSITION": file.positions(band)}
        fan = {"POSITION": file.positions([(0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)])}
        primitives = [{"attributes": attributes, "indices": indices} for attributes in (small, bytes_only, mixed, sparse)]
        primitives += [{"attributes": plain}, {"attributes": strip, "mode": 5},
                       {"attributes": fan, "mode": 6, "indices": file.accessor([0, 1, 2, 3, 4, 1], "SCALAR", 5121)}]
        file.description |= {"meshes": [{"primitives": [primitive]} for primitive in primitives]}
        _, after, report = self.edit(file.glb())
        self.assertEqual(report["components"], len(primitives))
        self.assertTrue(all(primitive.get("mode", 4) == 4 for primitive in after.primitives()))

    def test_shared_vertices(self):
        """Primitives with the same attributes share vertices afterwards, too."""
        points, triangles = sphere(2)
        file = Builder()
        attributes = {"POSITION": file.positions(points)}
        parts = [[v for triangle in triangles[i::16] for v in triangle] for i in range(16)]
        file.description |= {"meshes": [{"primitives": [
            {"attributes": attributes, "indices": file.accessor(part, "SCALAR", 5123)} for part in parts]}]}
        before, after, report = self.edit(file.glb())
        self.assertEqual((report["vertices"], report["components"]), (len(points), 1))
        self.assertEqual(len({json.dumps(primitive["attributes"]) for primitive in after.primitives()}), 1)
        self.assertLess(len(after.buffer), 3 * len(before.buffer))

    def test_nodes_share_a_mesh(self):
        """It is unwrapped once, and measured as the scene shows it first; meshes of two nodes that touch stay apart."""
        file = Builder()
        places = file.accessor([(0, 0, 0), (9, 0, 0)], "VEC3")
        attributes = {"POSITION": file.positions(CUBE)}
        indices = file.accessor(FACES, "SCALAR", 5123)
        file.description |= {
            "extensionsUsed": ["EXT_mesh_gpu_instancing"], "extensionsRequired": ["EXT_mesh_gpu_instancing"],
            "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": [{"mesh": 0, "scale": [-4, 1, 1]}, {"mesh": 0, "translation": [2, 0, 0]},
                      {"mesh": 1, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}}}],
            "meshes": [{"primitives": [{"attributes": attributes, "indices": indices}]} for _ in range(3)]}
        _, after, report = self.edit(file.glb())
        self.assertEqual((report["components"], report["faces"]), (3, 36))
        self.assertFalse([warning for warning in report["warnings"] if "inside out" in warning])
        areas = []
        for primitive in after.primitives():
            uvs, corners = after.numbers_of(primitive["attributes"]["TEXCOORD_0"]), after.corners(primitive)
            triangles = [[uvs[v] for v in corners[i:i + 3]] for i in range(0, len(corners), 3)]
            areas.append(sum(abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) for a, b, c in triangles))
        self.assertLess(abs(areas[0] / areas[1] - 72 / 24), 0.2)
        self.assertLess(abs(areas[2] / areas[1] - 1), 0.05)

        exit_code, report = self.report("in.glb", "-o", "out.obj")  # which has no instances
        self.assertEqual((exit_code, report["components"], report["faces"]), (0, 5, 60))

    def test_skinned_node(self):
        """Its transformation does not matter."""
        file = Builder()
        attributes = {"POSITION": file.positions(CUBE), "JOINTS_0": file.accessor([(0, 0, 0, 0)] * 24, "VEC4", 5121),
                      "WEIGHTS_0": file.accessor([(1, 0, 0, 0)] * 24, "VEC4")}
        primitive = {"attributes": attributes, "indices": file.accessor(FACES, "SCALAR", 5123)}
        file.description |= {"nodes": [{"mesh": 0, "skin": 0, "scale": [50, 1, 1]}, {}], "skins": [{"joints": [1]}],
                             "meshes": [{"primitives": [primitive]}]}
        self.edit(file.glb())
        self.report("in.glb", "-o", "out.obj")
        self.assertEqual(set(read_obj(self.folder / "out.obj")[0]), set(CUBE))

    def test_other_files(self):
        """The buffer comes into the file, images stay where they are."""
        (self.folder / "scene" / "parts").mkdir(parents=True)
        content = full()
        content.description["images"] = [{"uri": "parts/skin%20color.png"}, {"uri": "data:image/png;base64,aGVsbG8="}]
        self.write("scene/parts/mesh data.bin", content.buffer)
        self.write("scene/in.gltf", content.gltf("parts/mesh%20data.bin"))
        self.report("scene/in.gltf", "-o", "scene/out.glb")
        self.report("scene/in.gltf", "-o", "out.gltf")
        images = [[image["uri"] for image in File(self.folder / name).description["images"]]
                  for name in ("scene/out.glb", "out.gltf")]
        self.assertEqual(images[0], ["parts/skin%20color.png", "data:image/png;base64,aGVsbG8="])
        self.assertEqual(images[1], ["scene/parts/skin%20color.png", "data:image/png;base64,aGVsbG8="])
        self.assertEqual(len(File(self.folder / "out.gltf").description["buffers"]), 1)

    def test_compressed_copies(self):
        """Data that an extension repeats are outdated afterwards."""
        file = Builder(extensionsUsed=["KHR_draco_mesh_compression"])
        draco = {"KHR_draco_mesh_compression": {"bufferView": file.view(b"compressed"), "attributes": {"POSITION": 0}}}
        points, triangles = octahedron()
        file.description |= {"meshes": [{"primitives": [{
            "attributes": {"POSITION": file.positions(points)}, "extensions": draco,
            "indices": file.accessor([v for triangle in triangles for v in triangle], "SCALAR", 5123)}]}]}
        self.write("in.glb", file.glb())
        self.assertEqual(self.report("in.glb", "-o", "out.glb")[0], 0)
        description = File(self.folder / "out.glb").description
        self.assertNotIn("extensionsUsed", description)
        self.assertNotIn("extensions", description["meshes"][0]["primitives"][0])

    def test_texture(self):
        self.write("in.glb", full().glb())
        self.assertEqual(self.report("in.glb", "-o", "out.glb", "--texture", "check.png")[0], 0)
        after = File(self.folder / "out.glb")
        material = after.description["materials"][after.primitives()[0]["material"]]
        texture = after.description["textures"][material["pbrMetallicRoughness"]["baseColorTexture"]["index"]]
        image = after.description["images"][texture["source"]]
        self.assertEqual(after.view(image["bufferView"]), (self.folder / "check.png").read_bytes())
        self.assertEqual(after.view(after.description["images"][0]["bufferView"]), IMAGE)


main()
