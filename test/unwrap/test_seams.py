"""The seams of the texture coordinates that the input brings, as a cut to keep or to start from."""

import struct

from support import (Case, cut_edges, main, ply_header, read_obj, selection, sphere, to_glb, to_obj, to_off, to_ply,
                     to_text_stl)

SPHERE = sphere(3)
POINTS, FACES = SPHERE
UNTEXTURED = 4


def is_low(face):
    return sum(POINTS[v][2] for v in face) < 0


# Two sheets: the seam is the loop between them.
UVS = [[(POINTS[v][0] + 10 * is_low(face), POINTS[v][1]) for v in face] for face in FACES]


def seam():
    sides = {}
    for face in FACES:
        for a, b in zip(face, face[1:] + face[:1]):
            sides.setdefault(frozenset((a, b)), []).append(is_low(face))
    return {edge for edge, (one, other) in sides.items() if one != other}


def textured_obj(uvs=None, is_relative=False):
    """Each corner has a texture point of its own."""
    lines = to_obj(SPHERE).splitlines()[:len(POINTS)]
    count = 0
    for face, face_uvs in zip(FACES, uvs or UVS):
        lines += [f"vt {u!r} {v!r}" for u, v in face_uvs]
        numbers = [count + k + 1 if not is_relative else k - 3 for k in range(3)]
        lines.append("f " + " ".join(f"{v + 1}/{number}" for v, number in zip(face, numbers)))
        count += 3
    return "\n".join(lines) + "\n"


def textured_ply(form):
    is_text = form == "ascii"
    header = ply_header(form, len(POINTS), len(FACES)).replace(
        "property list uchar int", "property list uchar double texcoord\nproperty list uchar int").encode()
    rows = [([*point], "<3f") for point in POINTS]
    rows += [([6, *sum(uvs, ()), 3, *face], "<B6dB3i") for face, uvs in zip(FACES, UVS)]
    if is_text:
        return header + "".join(" ".join(map(repr, row)) + "\n" for row, _ in rows).encode()
    return header + b"".join(struct.pack(pattern, *row) for row, pattern in rows)


def repeated():
    """Points, their texture coordinates, and faces, where a point has as many indices as texture coordinates."""
    indices = {}
    faces = [tuple(indices.setdefault((POINTS[v], uv), len(indices)) for v, uv in zip(face, uvs))
             for face, uvs in zip(FACES, UVS)]
    return [point for point, _ in indices], [uv for _, uv in indices], faces


def textured_points():
    """Files that give texture coordinates per point."""
    points, uvs, faces = repeated()
    rest = {"STOFF": (), "STCOFF": (0.5, 0.25, 1), "STNOFF": (0, 0, 1), "STCNOFF": (0, 0, 1, 0.5, 0.25, 1, 1)}
    files = {f"{word}.off": to_off(([(*point, *between, *uv) for point, uv in zip(points, uvs)], faces)).replace(
        "OFF", word, 1) for word, between in rest.items()}
    for u, v in ("s", "t"), ("u", "v"), ("texture_u", "texture_v"):
        files[f"{u}.ply"] = to_ply(([(*uv, *point) for point, uv in zip(points, uvs)], faces), "ascii").replace(
            b"property float x", f"property float {u}\nproperty float {v}\nproperty float x".encode())
    return files | {"scene.glb": to_glb(points, faces, uvs=uvs)}


TEXTURED = {
    "absolute.obj": textured_obj(), "relative.obj": textured_obj(is_relative=True),
    "text.ply": textured_ply("ascii"), "binary.ply": textured_ply("binary_little_endian"),
}


class Seams(Case):
    def cut(self, *arguments):
        exit_code, report = self.report(*arguments, "-o", "out.obj")
        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
        return report, cut_edges(self.folder / "out.obj")

    def test_formats(self):
        """All of the seam is cut, and each of its sides gets a chart."""
        self.write("plain.obj", to_obj(SPHERE))
        self.write("seam.txt", selection(edges=map(tuple, seam())))
        _, expected = self.cut("plain.obj", "--must-cut", "seam.txt")
        self.assertLessEqual(seam(), expected)
        for name, content in TEXTURED.items():
            self.write(name, content)
            with self.subTest(name=name):
                self.assertEqual(self.cut(name, "--must-cut", "uv")[1], expected)

    def test_coordinates_of_points(self):
        """Where points are repeated, they have to be merged to have a seam between them."""
        self.write("plain.obj", to_obj(SPHERE))
        self.write("seam.txt", selection(edges=map(tuple, seam())))
        _, expected = self.cut("plain.obj", "--must-cut", "seam.txt")
        for name, content in textured_points().items():
            self.write(name, content)
            with self.subTest(name=name):
                exit_code, report = self.report(name, "--must-cut", "uv", "--weld", "on", "-o", "out.obj")
                self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
                cut = cut_edges(self.folder / "out.obj", POINTS)
                self.assertLessEqual(seam(), cut)
                self.assertEqual(len(cut), len(expected))

    def test_round_trip(self):
        """What the program has unwrapped is the start of the next run, and is kept where that is asked for."""
        self.write("sphere.off", to_off(SPHERE))
        first = self.unwrap("sphere.off", "-o", "first.obj", "--effort", "fast")
        self.assertEqual(first.returncode, 0, first.stderr)
        given = cut_edges(self.folder / "first.obj")
        report, cut = self.cut("first.obj", "--initial-cut", "uv", "--must-cut", "uv")
        self.assertLessEqual(given, cut)
        self.assertEqual(report["warnings"], [])
        improved, _ = self.cut("first.obj", "--initial-cut", "uv")
        self.assertLessEqual(improved["cut_length"], report["cut_length"])

    def test_start(self):
        """The loop alone would separate the surface: it is opened, as one from a file is."""
        self.write("loop.obj", textured_obj())
        self.write("seam.txt", selection(edges=map(tuple, seam())))
        for effort in ("fast", "default"):
            _, cut = self.cut("loop.obj", "--initial-cut", "uv", "--effort", effort)
            self.assertFalse(seam() <= cut)
            self.assertEqual(cut, self.cut("loop.obj", "--initial-cut", "seam.txt", "--effort", effort)[1])
            self.assertNotEqual(cut, self.cut("loop.obj", "--effort", effort)[1])

    def test_same_coordinates_are_no_seam(self):
        """Whatever their indices are."""
        self.write("sheet.obj", textured_obj([[POINTS[v][:2] for v in face] for face in FACES]))
        for option in ("--initial-cut", "--must-cut"):
            report, _ = self.cut("sheet.obj", option, "uv")
            self.assertEqual(len(report["warnings"]), 1)
            self.assertIn("no seam", report["warnings"][0])

    def test_faces_without_coordinates(self):
        """There is a seam around them, and none between them."""
        lines = to_obj(SPHERE).splitlines()
        first = len(POINTS)
        for i in range(first, len(lines) - UNTEXTURED):
            lines[i] = "f " + " ".join(f"{word}/1" for word in lines[i].split()[1:])
        self.write("some.obj", "vt 0 0\n" + "\n".join(lines) + "\n")
        sides = {}
        for i, face in enumerate(FACES):
            for a, b in zip(face, face[1:] + face[:1]):
                sides.setdefault(frozenset((a, b)), []).append(i >= len(FACES) - UNTEXTURED)
        around = {edge for edge, (one, other) in sides.items() if one != other}
        between = {edge for edge, sides_of_edge in sides.items() if all(sides_of_edge)}
        _, cut = self.cut("some.obj", "--must-cut", "uv")
        self.assertLessEqual(around, cut)
        self.assertFalse(between & cut)

    def test_several_elements(self):
        """Those of a PLY file need not have the same properties."""
        text = textured_ply("ascii").decode().splitlines()
        end = text.index("end_header")
        text[text.index(f"element face {len(FACES)}")] = f"element face {len(FACES) - UNTEXTURED}"
        text[end:end] = [f"element faces {UNTEXTURED}", "property list uchar int vertex_indices"]
        text[-UNTEXTURED:] = [" ".join(line.split()[7:]) for line in text[-UNTEXTURED:]]
        self.write("two.ply", "\n".join(text) + "\n")
        _, cut = self.cut("two.ply", "--must-cut", "uv")
        self.assertLessEqual({edge for edge in seam() if not edge & set(sum(FACES[-UNTEXTURED:], ()))}, cut)

    def test_without_coordinates(self):
        plain = {"plain.obj": to_obj(SPHERE), "unused.obj": "vt 0 0\n" + to_obj(SPHERE), "plain.off": to_off(SPHERE),
                 "plain.stl": to_text_stl(SPHERE)}
        for name, content in plain.items():
            self.write(name, content)
            for option in ("--initial-cut", "--must-cut"):
                with self.subTest(name=name, option=option):
                    message = self.assert_refused(4, name, option, "uv")["message"]
                    self.assertIn(f"{option} uv: the input has no texture coordinates", message)

    def test_coordinates_that_cannot_be_read(self):
        """They are an error only where somebody asks for them."""
        text, ply = textured_obj(), textured_ply("ascii").decode()
        bad = {"range.obj": text.replace("/1 ", f"/{3 * len(FACES) + 1} ", 1),
               "zero.obj": text.replace("/1 ", "/0 ", 1), "word.obj": text.replace("/1 ", "/one ", 1),
               "before.obj": text.replace("/1 ", "/-4 ", 1),
               "infinite.obj": text.replace("vt ", "vt inf 0 #", 1), "none.obj": text.replace("vt ", "vt # ", 1),
               "letters.obj": text.replace("vt ", "vt u ", 1),
               "few.off": "STOFF 3 1 0\n0 0 0 0\n1 0 0 0 1\n0 1 0 1 1\n3 0 1 2\n",
               "few.ply": ply.replace("\n6 ", "\n5 ", 1), "infinite.ply": ply.replace("\n6 ", "\n6 inf ", 1)}
        for name, content in bad.items():
            self.write(name, content)
            with self.subTest(name=name):
                self.assert_refused(3, name, "--must-cut", "uv")
                if name.endswith(".obj"):
                    self.assertEqual(self.unwrap(name, "-o", "out.obj").returncode, 0)
                    (self.folder / "out.obj").unlink()

    def test_file_of_that_name(self):
        self.write("sphere.off", to_off(SPHERE))
        self.write("uv", selection(edges=map(tuple, seam())))
        self.assertLessEqual(seam(), self.cut("sphere.off", "--must-cut", "./uv")[1])
        self.assert_refused(2, "sphere.off", "--must-cut", "./uv", "--svg", "uv")
        self.assertFalse(seam() & self.cut("sphere.off", "--never-cut", "uv")[1])  # there, it is always a file

    def test_output_named_like_the_seams(self):
        """The word names no input that an output could replace."""
        self.write("loop.obj", textured_obj())
        self.cut("loop.obj", "--must-cut", "uv", "--svg", "uv")
        self.assertIn("uv", self.files())
        self.assertEqual(read_obj(self.folder / "out.obj")[0], POINTS)


main()
