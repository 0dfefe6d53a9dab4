"""Reading: the same mesh from every format, and every kind of damage with its exit status."""

import json
import struct

from support import (Case, joined, main, octahedron, ply_header, read_obj, sphere, strips_ply,
                     to_binary_stl, to_obj, to_off, to_ply, to_text_stl, torus, without_face)

SPHERE = sphere(1)
OFF_HEADER = "".join(line + "\n" for line in to_off(SPHERE).splitlines()[:2])
OFF_POINTS = "".join(line + "\n" for line in to_off(SPHERE).splitlines()[2:20])


def several_in_a_line(off, number):
    """The points of an OFF file, so many in a line."""
    lines = off.splitlines()
    points, faces = lines[2:2 + len(SPHERE[0])], lines[2 + len(SPHERE[0]):]
    rows = [" ".join(points[i:i + number]) for i in range(0, len(points), number)]
    return "\n".join(lines[:2] + rows + faces) + "\n"


def with_more(ply, text):
    """The lines of the points and faces of a PLY file continue."""
    header, body = ply.split(b"end_header\n")
    return header + b"end_header\n" + body.replace(b"\n", text + b"\n")


# OBJ as others write it: everything that is not a point or a face is to be passed over.
DECORATED_OBJ = "\r\n".join(
    ["# a comment", "mtllib some.mtl", "o object", "", "vt 0 0", "vn 0 0 1", "g group name"]
    + ["v " + " ".join(map(repr, point)) + " 1.0 0.5 0.5 # colored" for point in SPHERE[0]]
    + ["s off", "usemtl red", "l 1 2", "p 3"]
    + [f"f {a + 1}/1/1\t{b - len(SPHERE[0])}//1 \\\r\n  {c + 1}/1 # end" for a, b, c in SPHERE[1]]
) + "\r\n"

READABLE = {
    "sphere.off": to_off(SPHERE),
    "SPHERE.OFF": to_off(SPHERE).replace("\n", " # comment\r\n\r\n"),
    "colors.off": to_off(SPHERE).replace("OFF", "COFF", 1),
    "sphere.obj": to_obj(SPHERE),
    "decorated.obj": DECORATED_OBJ,
    "text.ply": to_ply(SPHERE, "ascii"),
    "little.ply": to_ply(SPHERE, "binary_little_endian"),
    "big.PLY": to_ply(SPHERE, "binary_big_endian"),
    "old_comments.obj": "$ made by a test\n" + to_obj(SPHERE),
    "old_faces.obj": to_obj(SPHERE).replace("\nf ", "\nfo "),
    "mark.off": b"\xef\xbb\xbf" + to_off(SPHERE).encode(),
    "mark.obj": b"\xef\xbb\xbf" + DECORATED_OBJ.encode(),
    "mark_inside": b"\xef\xbb\xbf" + to_off(SPHERE).encode(),
    "returns.off": to_off(SPHERE).replace("\n", " # comment\r"),
    "returns.obj": DECORATED_OBJ.replace("\r\n", "\r"),
    "returns.ply": to_ply(SPHERE, "ascii").replace(b"\n", b"\r"),
    "more_in_lines.ply": with_more(to_ply(SPHERE, "ascii"), b" 9 1 0.5 word"),
    "broken_lines.ply": to_ply(SPHERE, "ascii").replace(b"\n3 ", b"\n3\n"),
    "all_in_a_line.ply": b"end_header\n".join(part.replace(b"\n", b" ") if i else part for i, part in enumerate(
        to_ply(SPHERE, "ascii").split(b"end_header\n"))),
    "made_by.ply": to_ply(SPHERE, "ascii").replace(b"comment made", b"Made"),
    "many_in_a_line.off": several_in_a_line(to_off(SPHERE), 4),
    "no_space.off": to_off(SPHERE).replace("OFF\n", "OFF", 1),
    "a_line_for_each_number.off": OFF_HEADER + to_off(SPHERE)[len(OFF_HEADER):].replace(" ", "\n"),
    "broken_lines.off": OFF_HEADER + OFF_POINTS + to_off(SPHERE)[len(OFF_HEADER + OFF_POINTS):].replace(" ", " \n", 7),
    "all_in_a_line.off": several_in_a_line(to_off(SPHERE), len(SPHERE[0])),
    "off_inside.mesh": to_off(SPHERE),
    "ply_inside": to_ply(SPHERE, "binary_little_endian"),
}

UNREADABLE = {
    "empty.off": "", "empty.obj": "", "empty.ply": "", "empty.stl": "", "empty.mesh": "",
    "other.off": to_obj(SPHERE), "other.ply": to_off(SPHERE), "other.obj": to_off(SPHERE),
    "zeros.off": bytes(1000), "zeros.obj": bytes(1000), "zeros.ply": bytes(1000),
    "text.mesh": "to whom it may concern",
    "binary.off": b"OFF BINARY\n" + bytes(100),
    "four.off": to_off(SPHERE).replace("OFF", "4OFF", 1),
    # indices
    "range.off": to_off(SPHERE).replace("\n3 0 ", "\n3 18 ", 1),
    "negative.off": to_off(SPHERE).replace("\n3 0 ", "\n3 -1 ", 1),
    "huge.off": to_off(SPHERE).replace("\n3 0 ", "\n3 99999999999999999999 ", 1),
    "range.obj": to_obj(SPHERE).replace("\nf 1 ", "\nf 19 ", 1),
    "zero.obj": to_obj(SPHERE).replace("\nf 1 ", "\nf 0 ", 1),
    "negative.obj": to_obj(SPHERE).replace("\nf 1 ", "\nf -19 ", 1),
    "range.ply": to_ply(SPHERE, "ascii").replace(b"\n3 0 ", b"\n3 18 ", 1),
    "negative.ply": to_ply(SPHERE, "ascii").replace(b"\n3 0 ", b"\n3 -1 ", 1),
    # no numbers where there should be some
    "word.off": to_off(SPHERE).replace("0.0", "zero", 1),
    "word.obj": to_obj(SPHERE).replace("0.0", "zero", 1),
    "statement.obj": to_obj(SPHERE).replace("v ", "w ", 1),
    "short.off": to_off(SPHERE).replace("\n3 0 ", "\n4 0 ", 1),
    "short_of_many.off": several_in_a_line(to_off(SPHERE), 4).replace("\n3 0 ", "\n4 0 ", 1),
    "more_of_many.off": several_in_a_line(to_off(SPHERE), 4) + "1 0\n",
    "negative_size.off": to_off(SPHERE).replace("\n3 0 ", "\n-3 0 ", 1),
    # headers that lie
    "points.off": "OFF\n2000000000 1 0\n0 0 0\n",
    "faces.off": "OFF\n18 2000000000 0\n" + OFF_POINTS + "3 0 1 2\n",
    "corners.off": "OFF\n18 1 0\n" + OFF_POINTS + "2000000000 0 1 2\n",
    "beyond.off": "OFF\n99999999999 1 0\n",
    "below.off": "OFF\n-1 1 0\n",
    "points.ply": ply_header("binary_little_endian", 2000000000, 1).encode() + bytes(100),
    "faces.ply": ply_header("binary_little_endian", 0, 2000000000).encode() + bytes(100),
    "text_faces.ply": ply_header("ascii", 0, 2000000000) + "0\n" * 10,
    "corners.ply": ply_header("binary_little_endian", 0, 1).replace("uchar", "uint").encode()
                   + b"\xff" * 100,
    "endless.ply": "ply\nformat ascii 1.0\nelement face 4000000000\nend_header\n",
    "no_points.ply": to_ply(SPHERE, "ascii").replace(b"property float x\n", b""),
    "no_faces.ply": to_ply(SPHERE, "ascii").replace(b"vertex_indices", b"something"),
    "type.ply": to_ply(SPHERE, "ascii").replace(b"float x", b"quaternion x"),
    "header.ply": "ply\nformat ascii 1.0\nelement vertex 3\n",
    "made_late.ply": to_ply(SPHERE, "ascii").replace(b"element face", b"made by\nelement face"),
    "strips.ply": "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int "
                  "vertex_indices\nend_header\n3 0 1 2\n",
    "strip_range.ply": strips_ply(SPHERE, "ascii", [[0, 1, 2, -1, 3, 4, 99]]),
    "strip_end.ply": strips_ply(SPHERE, "ascii", [[0, 1, 2, -2, 3, 4, 5]]),
    "strip_without_list.ply": strips_ply(SPHERE, "ascii", [[0, 1, 2]]).replace(b"list int int ", b"int "),
    "facets.stl": bytes(80) + struct.pack("<I", 4000000000) + bytes(100),
}
TRUNCATED = ["sphere.off", "text.ply", "little.ply", "big.PLY"]

UNSUPPORTED = {  # with the kind of the witness
    "no_faces.off": (to_off((SPHERE[0], [])), None),
    "no_faces.obj": (to_obj((SPHERE[0], [])), None),
    "no_faces.ply": (to_ply((SPHERE[0], []), "binary_little_endian"), None),
    "nothing.off": ("OFF\n0 0 0\n", None),
    "no_faces.stl": (bytes(84), None),
    "nan.off": (to_off(SPHERE).replace("0.0", "nan", 1), "vertices"),
    "infinite.obj": (to_obj(SPHERE).replace("0.0", "-inf", 1), "vertices"),
    "too_large.off": (to_off(SPHERE).replace("0.0", "1e999", 1), "vertices"),
}
REFUSED_IF_STRICT = {
    "quad.off": (to_off((SPHERE[0], [(0, 1, 2, 3)])), "faces"),
    "quad.obj": (to_obj((SPHERE[0], [(0, 1, 2, 3)])), "faces"),
    "segment.off": (to_off((SPHERE[0], [SPHERE[1][0], (0, 1)])), "faces"),
    "repeated.off": (to_off((SPHERE[0], SPHERE[1] + [(0, 1, 1)])), "faces"),
    "twice.off": (to_off((SPHERE[0], SPHERE[1] + [SPHERE[1][5]])), "faces"),
    "fin.off": (to_off((SPHERE[0] + [(9, 9, 9)], SPHERE[1] + [(*SPHERE[1][0][:2], 18)])), "edges"),
    "turned.off": (to_off((SPHERE[0], SPHERE[1][1:] + [SPHERE[1][0][::-1]])), "faces"),
    "moebius.off": (to_off((SPHERE[0][:5], [(i, (i + 1) % 5, (i + 2) % 5) if i % 2 == 0
                                            else (i, (i + 2) % 5, (i + 1) % 5)
                                            for i in range(5)])), "faces"),
}
TOUCHING = joined(octahedron(), octahedron())  # to be joined in a vertex

# Handles, borders and several components, with genus, borders and components.
ANY_TOPOLOGY = {
    "torus.off": (to_off(torus()), (1, 0, 1)),
    "open.off": (to_off(without_face(SPHERE)), (0, 1, 1)),
    "triangle.off": (to_off((SPHERE[0][:3], [(0, 1, 2)])), (0, 1, 1)),
    "two.off": (to_off(joined(SPHERE, SPHERE)), (0, 0, 2)),
}


class Reading(Case):
    def assert_same_mesh(self, mesh, name):
        points, _, faces = read_obj(self.folder / name)
        self.assertEqual(points, [tuple(map(float, point)) for point in mesh[0]])
        self.assertEqual([tuple(v for v, _ in face) for face in faces], mesh[1])

    def test_formats(self):
        results = set()
        for name, content in READABLE.items():
            with self.subTest(name=name):
                self.write(name, content)
                run = self.unwrap(name, "-o", "out.obj")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assert_same_mesh(SPHERE, "out.obj")
                results.add(str(read_obj(self.folder / "out.obj")))  # OBJ keeps what else it says
        self.assertEqual(len(results), 1)

    def test_triangle_strips(self):
        points = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0), (2, 1, 0), (5, 0, 0), (5, 1, 0), (6, 0, 0)]
        # the second one goes back by repeating vertices
        strips = [[0, 1, 2, 3, -1, 6, 7, 8], [2, 3, 4, 4, 4, 3, 5]]
        triangles = [(0, 1, 2), (2, 1, 3), (6, 7, 8), (2, 3, 4), (4, 3, 5)]
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            with self.subTest(form=form):
                self.write("in.ply", strips_ply((points, []), form, strips))
                self.assertEqual(self.report("in.ply", "-o", "out.obj", "--strict")[0], 0)
                self.assert_same_mesh((points, triangles), "out.obj")
                self.assertEqual(self.report("in.ply", "-o", "out.ply")[0], 0)  # whose corners have coordinates
                self.assertEqual(self.report("out.ply", "-o", "again.obj")[0], 0)
                self.assert_same_mesh((points, triangles), "again.obj")
                self.assertIn(b"texcoord", (self.folder / "out.ply").read_bytes())

    def test_stl_merges_equal_points(self):
        merged = []  # in order of appearance
        for face in SPHERE[1]:
            merged += [SPHERE[0][v] for v in face if SPHERE[0][v] not in merged]
        faces = [tuple(merged.index(SPHERE[0][v]) for v in face) for face in SPHERE[1]]
        text, binary = to_text_stl(SPHERE), to_binary_stl(SPHERE)
        solid = b"solid thing".ljust(80) + binary[80:]
        for name, content in (("text.stl", text), ("binary.stl", binary), ("upper.stl", text.upper()),
                              ("mixed.stl", text.title()), ("upper_inside", text.upper()),
                              ("returns.stl", text.replace("\n", "\r")), ("mark.stl", "\ufeff" + text),
                              ("solid.stl", solid), ("trailing.stl", solid + b"\0\0"),
                              ("long_trailing.stl", binary + bytes(1000))):
            with self.subTest(name=name):
                run = self.unwrap(self.write(name, content), "-o", "out.obj")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assert_same_mesh((merged, faces), "out.obj")

    def test_isolated_points_are_kept(self):
        mesh = ([(5, 5, 5)] + SPHERE[0] + [(6, 6, 6)], [tuple(v + 1 for v in f) for f in SPHERE[1]])
        exit_code, report = self.report(self.write("isolated.obj", to_obj(mesh)))
        self.assertEqual((exit_code, report["vertices"]), (0, 20), report["message"])
        self.assert_same_mesh(mesh, "isolated.uv.obj")

    def test_doubles_survive(self):
        points = [(x / 3, y / 7, z * 1e-3) for x, y, z in SPHERE[0]]
        run = self.unwrap(self.write("a.off", to_off((points, SPHERE[1]))))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assert_same_mesh((points, SPHERE[1]), "a.uv.obj")

    def test_unreadable(self):
        for name, content in UNREADABLE.items():
            with self.subTest(name=name):
                report = self.assert_refused(3, self.write(name, content))
                self.assertLess(report["peak_memory_mb"], 200)
        self.assert_refused(3, "missing.off")
        self.assert_refused(3, ".")
        self.assert_refused(3, "/dev/null")

    def test_empty(self):
        for ending in ("off", "obj", "ply", "stl", "glb", "gltf", "mesh"):
            self.write(f"a.{ending}", "")
            self.assertEqual(self.assert_refused(3, f"a.{ending}")["message"], "the file is empty")

    def test_messages_name_the_line(self):
        lines = to_off(SPHERE).splitlines()
        for number, text in ((3, "0 zero 0"), (10, "1 2"), (25, "3 0 1"), (30, "3 0 1 -2"), (2, "18 x")):
            damaged = lines[:number - 1] + [text] + lines[number:]
            for end in ("\n", "\r\n", "\r"):
                with self.subTest(number=number, end=end):
                    report = self.assert_refused(3, self.write("a.off", end.join(damaged) + end))
                    self.assertIn(f"line {number}: ", report["message"])

    def test_marks_in_constraints(self):
        self.write("sphere.off", to_off(SPHERE))
        for option, text in (("--must-cut", "\n\n0 8\n"), ("--edge-weights", "0 8 3\n")):
            for content in ("\ufeff" + text, text.replace("\n", "\r")):
                exit_code, report = self.report("sphere.off", option, self.write("a.txt", content))
                self.assertIn(exit_code, (0, 4), report["message"])  # it need not be an edge

    def test_truncated(self):
        for name in TRUNCATED:
            content = READABLE[name]
            content = content if isinstance(content, bytes) else content.encode()
            for length in range(0, len(content) - 4, 37):
                with self.subTest(name=name, length=length):
                    self.assert_refused(3, self.write(name, content[:length]))

    def test_truncated_stl(self):
        for content in (to_text_stl(SPHERE).encode(), to_binary_stl(SPHERE)):
            for length in range(0, len(content) - 30, 97):
                with self.subTest(length=length):
                    self.assert_refused(3, self.write("cut.stl", content[:length]))

    def test_unsupported(self):
        for name, (content, kind) in UNSUPPORTED.items():
            with self.subTest(name=name):
                self.assert_unsupported(kind, self.write(name, content))

    def test_unsupported_if_strict(self):
        for name, (content, kind) in REFUSED_IF_STRICT.items():
            with self.subTest(name=name):
                self.assert_unsupported(kind, self.write(name, content), "--strict")
                self.assertEqual(self.report(name, "-o", "out.obj")[0], 0)
                (self.folder / "out.obj").unlink()

    def assert_unsupported(self, kind, *arguments):
        report = self.assert_refused(4, *arguments)
        witness = report["witness"]
        self.assertEqual(witness and witness["kind"], kind)
        if witness:
            self.assertIn(str(witness["indices"][0]), report["message"])

    def test_touching_vertex(self):
        faces = [tuple(0 if v == 7 else v for v in face) for face in TOUCHING[1]]
        report = self.assert_refused(4, self.write("a.off", to_off((TOUCHING[0], faces))), "--strict")
        self.assertEqual(report["witness"], {"kind": "vertices", "indices": [0]})

    def test_witnesses(self):
        report = self.assert_refused(4, self.write("a.off", REFUSED_IF_STRICT["twice.off"][0]), "--strict")
        self.assertEqual(report["witness"]["indices"], [5, 32])
        report = self.assert_refused(4, self.write("a.off", REFUSED_IF_STRICT["fin.off"][0]), "--strict")
        self.assertEqual(sorted(report["witness"]["indices"]), sorted(SPHERE[1][0][:2]))

    def test_any_topology(self):
        for name, (content, topology) in ANY_TOPOLOGY.items():
            with self.subTest(name=name):
                self.write(name, content)
                run = self.unwrap(name, "-o", "out.obj", "--json", "-")
                self.assertEqual(run.returncode, 0, run.stderr)
                report = json.loads(run.stdout)
                self.assertEqual(tuple(report[key] for key in ("genus", "borders", "components")), topology)
                self.assertEqual(report["flips"], 0)


main()
