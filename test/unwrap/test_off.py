"""OFF with all of its prefixes, as text and binary, to formats that can hold what it says."""

import itertools
import struct

from support import Case, main, read_obj, sphere, to_off

POINTS, FACES = sphere(1)
NORMALS = [(x, -y, 0.5) for x, y, _ in POINTS]
COLORS = [(i / 17, 1 - i / 17, 0.25) for i in range(len(POINTS))]
UVS = [(x, y + 5) for x, y, _ in POINTS]
FACE_COLORS = [(i % 5 / 4, 0.5, 1) for i in range(len(FACES))]


def rows(prefix, alpha=1):
    """The numbers of each point."""
    result = []
    for i, point in enumerate(POINTS):
        weight = 1 + i % 3
        row = [x * weight for x in point] + [weight] if "4" in prefix else list(point)
        row += NORMALS[i] if "N" in prefix else ()
        row += (*COLORS[i], alpha) if "C" in prefix else ()
        result.append(row + list(UVS[i] if "ST" in prefix else ()))
    return result


def text(prefix, alpha=1):
    lines = [prefix + "OFF # comment of the word", "3"] if "n" in prefix else [prefix + "OFF # comment of the word"]
    lines += ["# comment of the counts", f"{len(POINTS)} {len(FACES)} 0"]
    lines += [" ".join(map(repr, row)) for row in rows(prefix, alpha)]
    lines += [" ".join(map(str, (3, *face, *color))) for face, color in zip(FACES, FACE_COLORS)]
    return "\n".join(lines) + "\n"


def binary(prefix, alpha=1, colors=FACE_COLORS, order=">"):
    data = prefix.encode() + b"OFF BINARY\n" + (struct.pack(order + "i", 3) if "n" in prefix else b"")
    data += struct.pack(order + "3i", len(POINTS), len(FACES), 0)
    data += b"".join(struct.pack(f"{order}{len(row)}f", *row) for row in rows(prefix, alpha))
    for face, color in zip(FACES, colors):
        data += struct.pack(f"{order}5i{len(color)}f", 3, *face, len(color), *color)
    return data


def read_ply(path):
    """Names of properties and rows of numbers, per element."""
    header, body = path.read_text().split("end_header\n")
    elements, lines = {}, iter(body.splitlines())
    for line in header.splitlines():
        words = line.split()
        if words[0] == "element":
            elements[words[1]] = ([], int(words[2]))
        elif words[0] == "property":
            list(elements.values())[-1][0].append(words[-1])
    return {name: (names, [list(map(float, next(lines).split())) for _ in range(number)])
            for name, (names, number) in elements.items()}


class Off(Case):
    def assert_close(self, found, expected):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertEqual(len(a), len(b))
            for s, t in zip(a, b):
                self.assertAlmostEqual(s, t, places=5)

    def test_all_prefixes(self):
        for st, c, n, four, dimension in itertools.product(("", "ST"), ("", "C"), ("", "N"), ("", "4"), ("", "n")):
            prefix = st + c + n + four + dimension
            for content in (text(prefix), binary(prefix), binary(prefix, order="<")):
                with self.subTest(prefix=prefix, is_text=isinstance(content, str)):
                    self.write("in.off", content)
                    code, report = self.report("in.off", "-o", "out.obj", "--effort", "fast")
                    self.assertEqual(code, 0, report["message"])
                    points, _, faces = read_obj(self.folder / "out.obj")
                    self.assert_close(points, POINTS)
                    self.assertEqual([tuple(v for v, _ in face) for face in faces], FACES)
                    lines = [line.split() for line in (self.folder / "out.obj").read_text().splitlines()]
                    normals = [tuple(map(float, words[1:])) for words in lines if words[0] == "vn"]
                    self.assert_close(normals, NORMALS if n else [])
                    colors = [tuple(map(float, words[4:])) for words in lines if words[0] == "v" and len(words) > 4]
                    self.assert_close(colors, COLORS if c else [])
                    if n:
                        self.assertEqual([int(word.split("/")[2]) - 1 for words in lines if words[0] == "f"
                                          for word in words[1:]], [v for face in FACES for v in face])

    def test_prefixes_in_another_order(self):
        self.write("in.off", text("STCN").replace("STCNOFF", "NCSTOFF", 1))
        self.assertEqual(self.report("in.off", "-o", "out.obj")[0], 0)
        self.assert_close(read_obj(self.folder / "out.obj")[0], POINTS)

    def test_texture_coordinates(self):
        """One chart without a cut, from both kinds."""
        for content in (text("STCN"), binary("STCN")):
            self.write("in.off", content)
            code, report = self.report("in.off", "--initial-cut", "uv")
            self.assertEqual(code, 0)
            self.assertIn("no seam", " ".join(report["warnings"]))

    def test_comments_and_face_colors(self):
        self.write("in.off", text("N"))
        warnings = self.report("in.off", "-o", "out.obj")[1]["warnings"]
        self.assertEqual([warning.split(": ")[1] for warning in warnings], ["colors of faces"])
        lines = (self.folder / "out.obj").read_text().splitlines()
        self.assertEqual(lines[:2], ["# comment of the word", "# comment of the counts"])
        self.assertEqual(self.report("in.off", "-o", "out.ply")[1]["warnings"], [])
        self.assertIn("comment # comment of the counts\n", (self.folder / "out.ply").read_text())
        ply = read_ply(self.folder / "out.ply")
        names, rows_of_points = ply["vertex"]
        self.assertEqual(names, ["x", "y", "z", "nx", "ny", "nz"])
        self.assert_close(rows_of_points, [[*p, *normal] for p, normal in zip(POINTS, NORMALS)])
        names, rows_of_faces = ply["face"]
        self.assertEqual(names[2:], ["red", "green", "blue"])
        self.assertEqual([row[-3:] for row in rows_of_faces], [[int(255 * x + 0.5) for x in c] for c in FACE_COLORS])

    def test_colors_from_0_to_255_and_missing_ones(self):
        whole = to_off((POINTS, FACES)).splitlines()
        lines = [line + " 255 51 0" if i == len(whole) - 2 else line for i, line in enumerate(whole)]
        self.write("in.off", "\n".join(lines))
        self.report("in.off", "-o", "out.ply")
        colors = [row[-3:] for row in read_ply(self.folder / "out.ply")["face"][1]]
        self.assertEqual(colors, [[170] * 3] * (len(FACES) - 2) + [[255, 51, 0], [170] * 3])

    def test_transparency(self):
        for content, is_lost in ((text("C", 0.5), True), (text("C"), False), (binary("C", 0.5), True)):
            self.write("in.off", content)
            warnings = self.report("in.off", "-o", "out.ply")[1]["warnings"]
            self.assertEqual("transparency" in " ".join(warnings), is_lost)

    def test_numbers_that_are_not_announced(self):
        self.write("in.off", text("C").replace("COFF", "OFF", 1))
        self.assertIn("other properties", " ".join(self.report("in.off", "-o", "out.ply")[1]["warnings"]))

    def test_refused(self):
        more = text("").replace("OFF # comment of the word\n", "nOFF\n4\n", 1)
        for content, part in ((more, "4 dimensions"), (binary("n").replace(b"\n\0\0\0\3", b"\n\0\0\0\2", 1), "2 dimensions"),
                              ("ST4COFFEE\n3 1 0\n", "OFF"), (b"OFF BINARY\n" + bytes(100), "neither points nor faces"),
                              (b"OFF BINARY\n" + struct.pack(">3i", 2 ** 31 - 1, 1, 0), "ends before"),
                              (b"OFF BINARY\n" + struct.pack(">3i", 1, -1, 0), "negative"),
                              (binary("").replace(struct.pack(">4i", 3, *FACES[0]), struct.pack(">4i", 3, 0, 1, 99), 1),
                               "vertex 99")):
            with self.subTest(part=part):
                report = self.assert_refused(3, self.write("in.off", content))
                self.assertIn(part, report["message"])
                self.assertLess(report["peak_memory_mb"], 200)
        for length in range(11, len(binary("N")), 97):
            self.assert_refused(3, self.write("in.off", binary("N")[:length]))
        zero = text("4").replace("\n" + " ".join(map(repr, rows("4")[0])), "\n1 2 3 0", 1)
        self.assertEqual(self.assert_refused(4, self.write("in.off", zero))["witness"], {"kind": "vertices", "indices": [0]})


main()
