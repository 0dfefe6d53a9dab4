"""How a mesh comes in: encodings of text, the standard input, and formats that are not read."""

import os
import signal
import struct
import subprocess
import time
import zipfile

from support import (Case, PROGRAM, TIME_LIMIT, main, read_obj, selection, sphere, to_binary_stl, to_glb, to_obj, to_off,
                     to_ply, to_text_stl)

SPHERE = sphere(1)
TEXTS = {"a.off": to_off(SPHERE), "a.obj": "o caf\u00e9 \U0001f600\n" + to_obj(SPHERE),
         "a.ply": to_ply(SPHERE, "ascii").decode(), "a.stl": to_text_stl(SPHERE)}
FORMATS = {"a.off": to_off(SPHERE), "n.off": to_off(SPHERE).replace("OFF", "nOFF\n3", 1),
           "a.obj": "# comment\n" + to_obj(SPHERE), "text.ply": to_ply(SPHERE, "ascii"),
           "big.ply": to_ply(SPHERE, "binary_big_endian"), "text.stl": to_text_stl(SPHERE),
           "binary.stl": to_binary_stl(SPHERE), "a.glb": to_glb(*SPHERE)}


class Inputs(Case):
    def result(self, *arguments, **keywords):
        run = self.unwrap(*arguments, "-o", "out.obj", "--quiet", **keywords)
        self.assertEqual(run.returncode, 0, run.stderr)
        return read_obj(self.folder / "out.obj")

    def test_encodings(self):
        for name, text in TEXTS.items():
            expected = self.result(self.write(name, text))
            for encoding in ("utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"):
                with self.subTest(name=name, encoding=encoding):
                    mark = "\ufeff" if encoding[-3:] in ("-le", "-be") else ""
                    self.write(name, (mark + text).encode(encoding))
                    self.assertEqual(self.result(name), expected)
        self.write("a.obj", ("\ufeff" + TEXTS["a.obj"]).encode("utf-16-be"))
        self.result("a.obj")
        self.assertIn("o caf\u00e9 \U0001f600\n", (self.folder / "out.obj").read_text())
        self.write("lone.obj", b"\xff\xfe" + "o ".encode("utf-16-le") + b"\x00\xd8" + ("\n" + to_obj(SPHERE)).encode("utf-16-le"))
        self.result("lone.obj")
        self.assertIn("o \ufffd\n", (self.folder / "out.obj").read_text())

    def test_lines_of_old_machines(self):
        for name, text in TEXTS.items():
            expected = self.result(self.write(name, text))
            self.write(name, text.replace("\n", "\r").encode())
            with self.subTest(name=name):
                self.assertEqual(self.result(name), expected)
        expected = self.result(self.write("big.ply", FORMATS["big.ply"]))
        header, values = FORMATS["big.ply"].split(b"end_header\n", 1)
        self.write("big.ply", (header + b"end_header\n").replace(b"\n", b"\r") + values)
        self.assertEqual(self.result("big.ply"), expected)

    def test_encodings_of_constraints(self):
        self.write("a.off", to_off(SPHERE))
        for option, text in (("--terminals", selection(vertices=[0, 1])), ("--edge-weights", "0 2 3\n")):
            self.write("plain.txt", text)
            self.write("wide.txt", text.encode("utf-16"))
            self.assertEqual(self.unwrap("a.off", option, "wide.txt").returncode,
                             self.unwrap("a.off", option, "plain.txt").returncode)

    def test_standard_input(self):
        for name, content in FORMATS.items():
            with self.subTest(name=name):
                self.write(name, content)
                expected = self.result(name)
                data = (self.folder / name).read_bytes()
                self.assertEqual(self.result("-", stdin=None, input=data), expected)
                with open(self.folder / name, "rb") as file:
                    self.assertEqual(self.result("-", stdin=file), expected)
        run = self.unwrap("-", stdin=None, input=to_obj(SPHERE).encode())
        self.assertEqual(run.returncode, 0)
        self.assertIn("stdin.uv.obj", self.files())
        for data in (b"", b"to whom it may concern", bytes(1000)):
            self.assertEqual(self.unwrap("-", stdin=None, input=data).returncode, 3)
        run = self.unwrap("-", preexec_fn=lambda: os.close(0), stdin=None)
        self.assertEqual(run.returncode, 3, run.stderr)

    def test_standard_input_is_not_replaced(self):
        self.write("a.obj", to_obj(SPHERE))
        with open(self.folder / "a.obj", "rb") as file:
            self.assertEqual(self.unwrap("-", "-o", "a.obj", stdin=file).returncode, 2)
        self.assertEqual((self.folder / "a.obj").read_text(), to_obj(SPHERE))

    def test_waiting_for_standard_input(self):
        """A writer that takes its time: the time limit and signals end the run all the same."""
        for stop in ("limit", "signal"):
            with self.subTest(stop=stop):
                read_end, write_end = os.pipe()
                begin = time.monotonic()
                program = subprocess.Popen([PROGRAM, "-", *(["--time-limit", "0.5"] if stop == "limit" else [])],
                                           cwd=self.folder, stdin=read_end, stderr=subprocess.PIPE)
                os.close(read_end)
                os.write(write_end, b"v 0 0 0\n")
                if stop == "signal":
                    time.sleep(0.3)
                    program.send_signal(signal.SIGINT)
                program.communicate(timeout=TIME_LIMIT)
                os.close(write_end)
                self.assertEqual(program.returncode, 6)
                self.assertLess(time.monotonic() - begin, 20)
                self.assertEqual(self.files(), [])

    def test_formats_that_are_not_read(self):
        with zipfile.ZipFile(self.folder / "model.3mf", "w") as archive:
            archive.writestr("3D/3dmodel.model", "<model/>")
        with zipfile.ZipFile(self.folder / "scene.usdz", "w") as archive:
            archive.writestr("scene.usdc", "PXR-USDC")
        with zipfile.ZipFile(self.folder / "any.zip", "w") as archive:
            archive.writestr("a.obj", to_obj(SPHERE))
        contents = {"fbx": b"Kaydara FBX Binary  \0\x1a\0" + bytes(99), "blend": b"BLENDER-v300" + bytes(99),
                    "dae": b'<?xml version="1.0"?><COLLADA></COLLADA>', "stp": b"ISO-10303-21;\nHEADER;", "usda": b"#usda 1.0\n",
                    "usdc": b"PXR-USDC" + bytes(99), "wrl": b"#VRML V2.0 utf8\n", "x": b"xof 0303txt 0032\n",
                    "abc": b"Ogawa\xff" + bytes(99), "ma": b"//Maya ASCII 2020 scene\n", "max": b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(99)}
        words = {"fbx": "FBX", "blend": "Blender", "dae": "COLLADA", "stp": "STEP", "usda": "USD", "usdc": "USD", "wrl": "VRML",
                 "x": "DirectX", "abc": "Alembic", "ma": "Maya", "max": "3ds Max"}
        names = [("model.3mf", "3MF"), ("scene.usdz", "USD"), ("any.zip", "unpack")]
        for ending, content in contents.items():
            for name in (f"a.{ending}", f"a.{ending.upper()}", f"{ending}.obj", f"{ending}.glb", f"{ending}_without"):
                names.append((self.write(name, content), words[ending]))
        for ending in ("c4d", "skp", "3ds", "iges", "igs", "dxf", "lwo"):
            names.append((self.write(f"b.{ending}", struct.pack("<8d", *range(8))), ""))
        for name, word in names:
            with self.subTest(name=name):
                message = self.assert_refused(3, name)["message"]
                self.assertIn(word, message)
                self.assertTrue("export OBJ or GLB" in message or "unpack" in message, message)
        for name in ("a.obj", "a.stl", "a.glb", "a.gltf"):
            pointer = self.write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n")
            self.assertIn("'git lfs pull'", self.assert_refused(3, pointer)["message"])
        self.assertEqual(self.unwrap("-", stdin=None, input=contents["fbx"]).returncode, 3)
        run = self.unwrap("-", stdin=None, input=b' {"asset": {"version": "2.0"}}')
        self.assertIn(b".gltf", run.stderr)
        message = self.assert_refused(3, self.write("a.unknown", "to whom it may concern"))["message"]
        for word in ("OFF", "OBJ", "PLY", "STL", "glTF"):
            self.assertIn(word, message)

    def test_solids_have_names(self):
        two = to_text_stl(SPHERE).replace("made by a test", "first part") + to_text_stl(
            ([(x + 9, y, z) for x, y, z in SPHERE[0]], SPHERE[1])).replace("made by a test", "")
        self.write("two.stl", two)
        self.assertEqual(self.report("two.stl", "-o", "out.obj")[1]["warnings"], [])
        lines = (self.folder / "out.obj").read_text().splitlines()
        self.assertEqual([line for line in lines if line[0] == "o"], ["o first part", "o solid"])
        self.assertIn("groups", " ".join(self.report("two.stl", "-o", "out.ply")[1]["warnings"]))
        self.write("one.stl", to_text_stl(SPHERE))
        self.report("one.stl", "-o", "out.obj")
        self.assertNotIn("\no ", (self.folder / "out.obj").read_text())

    def test_other_data_of_ply_and_stl(self):
        header = "ply\nformat ascii 1.0\ncomment by hand\ncomment TextureFile a.png\nelement vertex 3\n" + "".join(
            f"property float {name}\n" for name in ("x", "y", "z", "quality")) + (
                "property uchar alpha\nelement face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                "element edge 1\nproperty int vertex1\nend_header\n")
        self.write("a.ply", header + "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n3 0 1 2 9\n0\n")
        self.assertEqual(self.report("a.ply", "-o", "out.ply")[1]["warnings"], [])
        warning, = self.report("a.ply", "-o", "out.obj")[1]["warnings"]
        self.assertEqual(warning.split(": ")[1].split(", "), ["colors of faces", "transparency of colors", "images of textures",
                                                             "other properties and elements"])
        self.assertTrue((self.folder / "out.obj").read_text().startswith("# by hand\n"))
        painted = bytearray(to_binary_stl(SPHERE))
        painted[84 + 48] = 1
        self.write("a.stl", bytes(painted))
        self.assertIn("attribute bytes (colors)", " ".join(self.report("a.stl")[1]["warnings"]))
        self.write("a.stl", to_binary_stl(SPHERE))
        self.assertEqual(self.report("a.stl")[1]["warnings"], [])


main()
