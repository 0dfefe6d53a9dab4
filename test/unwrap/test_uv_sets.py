"""Other sets of texture coordinates than the first one, and the preset for light maps."""

from atlas import check_atlas
from gltf_files import File, full, without_data
from support import Case, main, read_obj, sphere, to_off, to_ply


class Sets(Case):
    def test_gltf(self):
        self.write("a.glb", full().glb())
        before = File(self.folder / "a.glb")
        for number in (0, 1, 2, 4):
            code, report = self.report("a.glb", "-o", "b.glb", "--uv-set", str(number), "--effort", "fast")
            self.assertEqual((code, report["flips"], report["overlaps"]), (0, 0, 0), report["message"])
            after = File(self.folder / "b.glb")
            name = f"TEXCOORD_{number}"
            new = {name, *(f"TEXCOORD_{i}" for i in range(2, number))}  # the format wants all sets before
            first, second = before.primitives()[0], after.primitives()[0]
            self.assertEqual(set(second["attributes"]), set(first["attributes"]) | new)
            self.assertEqual(sorted(before.corner_bytes(first, new)), sorted(after.corner_bytes(second, new)))
            uvs = after.numbers_of(second["attributes"][name])
            for other in new:
                self.assertEqual(after.numbers_of(second["attributes"][other]), uvs)
            corners = after.corners(second)
            faces = [[(v, v) for v in corners[i:i + 3]] for i in range(0, len(corners), 3)]
            check_atlas(self, [(u, 1 - v) for u, v in uvs], faces, [0] * len(faces), 2, 1024)
            about_textures = [w for w in report["warnings"] if "belong to its former texture coordinates" in w]
            self.assertEqual(len(about_textures), number == 0)
            self.assertEqual(without_data(after.description), without_data(before.description))
            self.assertEqual(after.other_bytes(), before.other_bytes())
            line, same_line = before.primitives()[1], after.primitives()[1]
            self.assertEqual(before.corner_bytes(line), after.corner_bytes(same_line))

    def test_gltf_of_others(self):
        points, faces = sphere(1)
        lines = ["v " + " ".join(map(repr, p)) for p in points]
        lines += [f"vt {i / 100} {i / 50}" for i in range(len(points))]
        lines += ["f " + " ".join(f"{v + 1}/{v + 1}" for v in face) for face in faces]
        self.write("a.obj", "\n".join(lines) + "\n")
        self.write("a.off", to_off((points, faces)))
        for name in ("a.obj", "a.off"):
            code, report = self.report(name, "-o", "b.glb", "--uv-set", "1", "--texture", "t.png")
            self.assertEqual(code, 0, report["message"])
            file = File(self.folder / "b.glb")
            primitive, = file.primitives()
            attributes = primitive["attributes"]
            first, second = (file.numbers_of(attributes[f"TEXCOORD_{i}"]) for i in (0, 1))
            positions = file.numbers_of(attributes["POSITION"])
            if name == "a.off":
                self.assertEqual(first, second)
            else:
                for p, (u, v) in zip(positions, first):
                    i = points.index(p)
                    self.assertAlmostEqual(u, i / 100, places=6)
                    self.assertAlmostEqual(1 - v, i / 50, places=6)
            self.assertEqual(file.description["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1)

    def test_ply(self):
        mesh = sphere(1)
        for form in ("ascii", "binary_big_endian"):
            self.write("a.ply", to_ply(mesh, form))
            self.assertEqual(self.unwrap("a.ply", "-o", "b.ply", "--quiet").returncode, 0)
            self.assertEqual(self.unwrap("b.ply", "-o", "c.ply", "--uv-set", "1", "--margin", "9", "--quiet").returncode, 0)
            self.assertEqual(self.unwrap("c.ply", "-o", "d.ply", "--uv-set", "1", "--quiet").returncode, 0)
            header = (self.folder / "d.ply").read_bytes().split(b"end_header")[0]
            self.assertEqual(header.count(b"double texcoord\n"), 1)
            self.assertEqual(header.count(b"double texcoord_1\n"), 1)
            # The first set is what it was, bit for bit: without the second one, the files are the same.
            self.assertEqual(self.unwrap("d.ply", "-o", "e.obj", "--must-cut", "uv", "--quiet").returncode, 0)
            self.assertEqual(self.unwrap("b.ply", "-o", "f.obj", "--must-cut", "uv", "--quiet").returncode, 0)
            self.assertEqual((self.folder / "e.obj").read_text().split("usemtl")[0],
                             (self.folder / "f.obj").read_text().split("usemtl")[0])

    def test_lightmap(self):
        self.write("a.glb", full().glb())
        for texels, margin in ((64, 2), (512, 8)):
            code, report = self.report("a.glb", "-o", "b.glb", "--lightmap", str(texels))
            self.assertEqual(code, 0, report["message"])
            after = File(self.folder / "b.glb")
            primitive = after.primitives()[0]
            uvs, corners = after.numbers_of(primitive["attributes"]["TEXCOORD_1"]), after.corners(primitive)
            faces = [[(v, v) for v in corners[i:i + 3]] for i in range(0, len(corners), 3)]
            check_atlas(self, [(u, 1 - v) for u, v in uvs], faces, [0] * len(faces), margin, texels)
            self.assertAlmostEqual(report["texels_per_unit"], report["uv_scale"] * texels)
        self.write("a.off", to_off(sphere(1)))
        self.assertEqual(self.report("a.off", "-o", "a.obj", "--lightmap", "128")[0], 0)
        _, uvs, faces = read_obj(self.folder / "a.obj")
        check_atlas(self, uvs, faces, [0] * len(faces), 2, 128)

    def test_errors(self):
        self.write("a.off", to_off(sphere(1)))
        for words in (["-o", "a.obj", "--uv-set", "1"], ["-o", "a.glb", "--uv-set", "8"], ["-o", "a.glb", "--uv-set", "-1"],
                      ["-o", "a.glb", "--uv-set", "1", "--tangents"], ["--lightmap", "0"]):
            self.assert_refused(2, "a.off", *words)


main()
