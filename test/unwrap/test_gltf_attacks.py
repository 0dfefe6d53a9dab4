"""glTF files that nobody wrote in good faith: they are refused at once, and nothing else is read or lost."""

import itertools
import json
import os
import struct
import time

from gltf_files import Builder, File, glb
from support import Case, main, octahedron, sphere

POINTS, TRIANGLES = octahedron()
CORNERS = [v for triangle in TRIANGLES for v in triangle]


def builder(**description):
    file = Builder()
    file.description |= {"meshes": [{"primitives": [{"attributes": {"POSITION": file.positions(POINTS)},
                                                     "indices": file.accessor(CORNERS, "SCALAR", 5123)}]}]} | description
    return file


class Attacks(Case):
    def assert_quick(self, seconds, *arguments):
        start = time.monotonic()
        result = self.report(*arguments)
        self.assertLess(time.monotonic() - start, seconds)
        return result

    def test_outputs_spare_inputs(self):
        """Also those to which the file refers, if it can be unwrapped or not."""
        file = builder(images=[{"uri": "skin color.png"}, {"uri": "not%20there.png"}])
        outputs = ("-o", "--json", "--svg", "--html", "--obj-cut", "--texture")
        names = (("m.bin", "m.bin"), ("m.bin", "%6d.bin"), ("m.glb", "m.glb"), ("skin color.png", "m.bin"))
        for required, option, (name, uri) in itertools.product(([], ["ACME_meshes"]), outputs, names):
            self.write(uri.replace("%6d", "m"), file.buffer)
            self.write("skin color.png", b"image")
            file.description["extensionsRequired"] = required
            self.write("in.gltf", file.gltf(uri))
            before = {path: (self.folder / path).read_bytes() for path in self.files()}
            run = self.unwrap("in.gltf", option, name)
            self.assertEqual(run.returncode, 2, (option, name, run.stderr))
            self.assertEqual({path: (self.folder / path).read_bytes() for path in self.files()}, before)

    def test_only_files_below(self):
        file = builder()
        (self.folder / "scene" / "below").mkdir(parents=True)
        for name in ("m.bin", "scene/m.bin", "scene/below/m.bin"):
            self.write(name, file.buffer)
        for uri, is_read in (("m.bin", True), ("below/m.bin", True), ("./m.bin", True), ("below%2Fm.bin", True),
                             ("../m.bin", False), ("%2e%2e/m.bin", False), ("%2e%2E%2fm.bin", False), ("below/../m.bin", False),
                             (str(self.folder / "m.bin"), False), ("%2f" + str(self.folder / "m.bin")[1:], False),
                             ("file:m.bin", False), ("http://localhost/m.bin", False), (".", False), ("", False),
                             ("m.bin%00", False), ("nothing.bin", False)):
            with self.subTest(uri=uri):
                self.write("scene/in.gltf", file.gltf(uri) if uri else file.gltf("x").replace('"x"', '""'))
                if is_read:
                    exit_code, report = self.report("scene/in.gltf", "-o", "out.glb")
                    self.assertEqual(exit_code, 0, report["message"])
                    (self.folder / "out.glb").unlink()
                else:
                    self.assert_refused(3, "scene/in.gltf", "-o", "out.glb")

    def test_pipes(self):
        """Nobody writes into them, so reading would wait for ever."""
        os.mkfifo(self.folder / "pipe")
        self.write("in.gltf", builder().gltf("pipe"))
        self.assertEqual(self.assert_quick(5, "in.gltf", "-o", "out.obj")[0], 3)
        file = builder(images=[{"uri": "pipe"}, {"uri": "."}, {"uri": "/dev/zero"}])
        file.description["buffers"] = []
        self.write("in.gltf", json.dumps(json.loads(file.gltf()) | {"buffers": [
            *json.loads(file.gltf())["buffers"], {"uri": "pipe", "byteLength": 4}]}))
        for name in ("out.obj", "out.glb"):
            exit_code, report = self.assert_quick(5, "in.gltf", "-o", name)
            self.assertEqual(exit_code, 0, report["message"])

    def test_many_nodes(self):
        points, triangles = sphere(4)
        file = Builder()
        file.description |= {"nodes": [{"mesh": 0}] * 20000, "meshes": [{"primitives": [{
            "attributes": {"POSITION": file.positions(points)},
            "indices": file.accessor([v for triangle in triangles for v in triangle], "SCALAR", 5123)}]}]}
        self.write("in.glb", file.glb())
        exit_code, report = self.assert_quick(20, "in.glb", "-o", "out.glb", "--effort", "fast")
        self.assertEqual((exit_code, report["faces"]), (0, len(triangles)), report["message"])
        self.assertEqual(self.assert_quick(15, "in.glb", "-o", "out.obj", "--time-limit", "1")[0], 6)

    def test_nesting(self):
        for number in (1000, 20000, 100000):
            nodes = [{"children": [i + 1]} for i in range(number)] + [{"mesh": 0}]
            self.write("in.glb", builder(nodes=nodes, scenes=[{"nodes": [0]}], scene=0).glb())
            exit_code, report = self.report("in.glb", "-o", "out.glb")
            self.assertEqual((exit_code, report["faces"]), (0, len(TRIANGLES)), report["message"])
            (self.folder / "out.glb").unlink()
            for text in ("[" * number + "]" * number, '{"a":' * number + "1" + "}" * number):
                data = json.dumps(builder(extras=0).description).replace('"extras": 0', '"extras": ' + text).encode()
                self.write("in.glb", glb(data, b""))
                self.assert_refused(3, "in.glb", "-o", "out.glb")

    def test_no_trees(self):
        for nodes in ([{"mesh": 0, "children": [0]}], [{"children": [1]}, {"children": [0]}],
                      [{"children": [2]}, {"children": [2]}, {}], [{"children": [7]}], [{"children": [-1]}], [{"mesh": 5}]):
            self.write("in.glb", builder(nodes=nodes).glb())
            self.assert_refused(3, "in.glb", "-o", "out.obj")

    def test_messages(self):
        """They quote a part of what is wrong, without control characters."""
        file = builder()
        for uri in ("data:application/octet-stream;base64,!" + "A" * 100000, "no\u001b[31m/" + "x" * 4000,
                    "data:,\n" + "%41" * 9999):
            self.write("in.gltf", file.gltf(uri))
            message = self.assert_refused(3, "in.gltf", "-o", "out.obj")["message"]
            self.assertLess(len(message), 300)
            self.assertTrue(message.isprintable())

    def test_extensions(self):
        """What to do about those that hide meshes is told."""
        for name, advice in (("KHR_draco_mesh_compression", "gltf-transform"), ("EXT_meshopt_compression", "gltfpack"),
                             ("ACME_meshes", "")):
            self.write("in.glb", builder(extensionsUsed=[name], extensionsRequired=[name]).glb())
            message = self.assert_refused(3, "in.glb", "-o", "out.glb")["message"]
            self.assertIn(name, message)
            self.assertIn(advice, message)

    def test_shaders(self):
        """Their extension hides no mesh; its views stay."""
        name = "KHR_techniques_webgl"
        file = builder(extensionsUsed=[name], extensionsRequired=[name])
        file.description["extensions"] = {name: {"shaders": [{"type": 35632, "bufferView": file.view(b"void main() {}")}]}}
        self.write("in.glb", file.glb())
        self.report("in.glb", "-o", "out.glb")
        data = (self.folder / "out.glb").read_bytes()
        self.assertIn(name.encode(), data)
        self.assertIn(b"void main() {}", data)

    def test_only_compressed(self):
        """Where the extension is used but not required, plain data have to be there, too."""
        file = builder(extensionsUsed=["KHR_draco_mesh_compression"])
        primitive, = file.description["meshes"][0]["primitives"]
        primitive["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}
        for accessor in file.description["accessors"]:
            del accessor["bufferView"]
        self.write("in.glb", file.glb())
        for name in ("out.glb", "out.obj"):
            message = self.assert_refused(3, "in.glb", "-o", name)["message"]
            self.assertIn("KHR_draco_mesh_compression", message)
            self.assertIn("gltf-transform copy", message)
        file = builder(extensionsUsed=["EXT_meshopt_compression"])
        fallback = {"byteLength": len(file.buffer), "extensions": {"EXT_meshopt_compression": {"fallback": True}}}
        self.write("in.gltf", json.dumps(file.description | {"buffers": [fallback]}))
        message = self.assert_refused(3, "in.gltf", "-o", "out.glb")["message"]
        self.assertIn("EXT_meshopt_compression", message)
        self.assertIn("gltfpack", message)

    def test_chunks(self):
        """Unknown ones do not matter; one that is longer than the file is told with its place."""
        data = builder().glb()
        second = 20 + struct.unpack_from("<I", data, 12)[0]
        extra = struct.pack("<I4s", 8, b"WHAT") + b"12345678"
        for at in (second, len(data)):
            changed = data[:at] + extra + data[at:]
            self.write("in.glb", changed[:8] + struct.pack("<I", len(changed)) + changed[12:])
            for name in ("out.glb", "out.obj"):
                exit_code, report = self.report("in.glb", "-o", name)
                self.assertEqual((exit_code, report["faces"]), (0, len(TRIANGLES)), report["message"])
                self.assertTrue(any("chunks of unknown kinds" in warning for warning in report["warnings"]))
                (self.folder / name).unlink()
        for length in (len(data), 2 ** 32 - 1):
            self.write("in.glb", data[:second] + struct.pack("<I", length) + data[second + 4:])
            self.assertIn(f"chunk at byte {second} ", self.assert_refused(3, "in.glb", "-o", "out.obj")["message"])

    def test_wrong_references(self):
        """Each number of the description in turn is another one; the program may refuse that, but must not fail."""
        text = json.dumps(builder(nodes=[{"mesh": 0}], scenes=[{"nodes": [0]}], scene=0).description)
        buffer = builder().buffer
        description = json.loads(text) | {"buffers": [{"byteLength": len(buffer)}]}

        def numbers(value, path=()):
            if isinstance(value, (dict, list)):
                for key, member in value.items() if isinstance(value, dict) else enumerate(value):
                    yield from numbers(member, (*path, key))
            elif isinstance(value, int):
                yield path

        for path in numbers(description):
            for number in (-1, 7, 2 ** 31, 2 ** 62, 1e300, None, "x", []):
                changed = json.loads(json.dumps(description))
                place = changed
                for key in path[:-1]:
                    place = place[key]
                place[path[-1]] = number
                self.write("in.glb", glb(changed, buffer))
                (self.folder / "out.glb").unlink(missing_ok=True)
                run = self.unwrap("in.glb", "-o", "out.glb", "--effort", "fast", "--quiet")
                self.assertIn(run.returncode, (0, 3, 4), (path, number, run.stderr))
                if run.returncode == 0:
                    File(self.folder / "out.glb")

    def test_no_version(self):
        self.write("in.gltf", '{"images":[{"uri":"%!QAAAQAAA5"}],"asset":{"version":""}}')
        self.assertIn("version", self.assert_refused(3, "in.gltf", "-o", "out.obj")["message"])

    def test_names(self):
        """Each is one word of a line of OBJ, without comments and continuations."""
        file = builder(nodes=[{"mesh": 0, "name": "a#b\\"}, {"mesh": 0, "name": "c\nf 1 1 1\r"}],
                       materials=[{"name": "m # n\\"}])
        file.description["meshes"][0]["primitives"][0]["material"] = 0
        self.write("in.glb", file.glb())
        self.report("in.glb", "-o", "out.obj")
        lines = [line for line in (self.folder / "out.obj").read_text().split("\n") if line[:1] in ("o", "u")]
        self.assertEqual(lines, ["o a_b_", "usemtl m _ n_", "o c_f 1 1 1_", "usemtl m _ n_"])


main()
