"""PLY written from PLY: the file of the input, with nothing changed but the texture coordinates."""

import random
import struct

from support import Case, main, sphere, to_obj

SEED = 20261123
SPHERE = sphere(1)
POINTS, FACES = SPHERE[0], [list(face) for face in SPHERE[1]]
FORMS = ["ascii", "binary_little_endian", "binary_big_endian"]
TYPES = {"char": "b", "uchar": "B", "int16": "h", "ushort": "H", "int": "i", "uint": "I", "uint32": "I", "float": "f",
         "double": "d"}
LIMITS = {"b": (-128, 127), "B": (0, 255), "h": (-32768, 32767), "H": (0, 65535), "i": (-2**31, 2**31 - 1),
          "I": (0, 2**32 - 1)}


class Ply:
    """Elements are pairs of a list of properties, (name, type, type of the size or None), and a list of rows."""

    def __init__(self, form, comments, elements):
        self.form, self.comments, self.elements = form, comments, elements

    def to_bytes(self, line_end="\n"):
        lines = ["ply", f"format {self.form} 1.0", *self.comments]
        for name, (properties, rows) in self.elements.items():
            lines.append(f"element {name} {len(rows)}")
            lines += [f"property {f'list {size} ' if size else ''}{kind} {title}" for title, kind, size in properties]
        data = (line_end.join(lines + ["end_header"]) + line_end).encode()
        for properties, rows in self.elements.values():
            for row in rows:
                data += self.row_to_bytes(properties, row, line_end)
        return data

    def row_to_bytes(self, properties, row, line_end):
        if self.form == "ascii":
            words = [word for (_, _, size), value in zip(properties, row)
                     for word in ([len(value), *value] if size else [value])]
            return (" ".join(map(repr, words)) + line_end).encode()
        order = "<" if self.form == "binary_little_endian" else ">"
        return b"".join(struct.pack(f"{order}{TYPES[size]}{len(value)}{TYPES[kind]}", len(value), *value) if size
                        else struct.pack(order + TYPES[kind], value) for (_, kind, size), value in zip(properties, row))

    @staticmethod
    def from_bytes(data):
        header, body = data[:data.index(b"end_header")].decode().split("\n"), data[data.index(b"end_header") + 10:]
        body = body[body.index(b"\n") + 1:]
        form, comments, elements, counts = None, [], {}, []
        for words in (line.split() for line in header if line):
            if words[0] == "format":
                form = words[1]
            elif words[0] in ("comment", "obj_info"):
                comments.append(" ".join(words))
            elif words[0] == "element":
                elements[words[1]] = ([], [])
                counts.append(int(words[2]))
            elif words[0] == "property":
                size = words[2] if words[1] == "list" else None
                elements[list(elements)[-1]][0].append((words[-1], words[-2], size))
        words, order, place = iter(body.split()), "<" if form == "binary_little_endian" else ">", 0

        def numbers(kind, number):
            nonlocal place
            code = TYPES[kind]
            if form == "ascii":
                return [(float if code in "fd" else int)(next(words)) for _ in range(number)]
            values = struct.unpack_from(f"{order}{number}{code}", body, place)
            place += struct.calcsize(f"{order}{number}{code}")
            return list(values)

        for (properties, rows), count in zip(elements.values(), counts):
            for _ in range(count):
                rows.append([numbers(kind, numbers(size, 1)[0]) if size else numbers(kind, 1)[0]
                             for _, kind, size in properties])
        assert form == "ascii" or place == len(body)
        return Ply(form, comments, elements)


def random_value(kind, generator):
    code = TYPES[kind]
    if code in "fd":
        return generator.randrange(-1000, 1000) / 8
    return generator.randint(*LIMITS[code])


def random_properties(prefix, generator):
    return [(f"{prefix}_{i}", generator.choice(list(TYPES)), generator.choice((None, None, "uchar", "ushort")))
            for i in range(generator.randrange(4))]


def random_row(properties, generator):
    return [[random_value(kind, generator) for _ in range(generator.randrange(4))] if size else
            random_value(kind, generator) for _, kind, size in properties]


def random_file(form, generator):
    """With properties of all kinds before, between and behind those of the geometry, and elements besides."""
    elements = {}
    for element in generator.sample(["before", "vertex", "between", "face", "behind"], 5):
        if element == "vertex":
            own = [(name, "float", None) for name in "xyz"]
            values = POINTS
            if generator.randrange(2):
                own = [("t", "float", None), own[0], ("s", "double", None), *own[1:]]
                values = [(0.25, x, 0.5, y, z) for x, y, z in POINTS]
        elif element == "face":
            own = [("vertex_indices", "int", "uchar")]
            values = [[face] for face in FACES]
            if generator.randrange(2):
                own.insert(generator.randrange(2), ("texcoord", "float", "uchar"))
                index = 0 if own[0][0] == "texcoord" else 1
                values = [row[:index] + [[0.0, 0.5] * 3] + row[index:] for row in values]
        else:
            own, values = [], [[]] * generator.randrange(4)
        first, last = random_properties(element + "_a", generator), random_properties(element + "_b", generator)
        if not own and not first and not last:
            last = [("only", "int", None)]
        rows = [random_row(first, generator) + list(value) + random_row(last, generator) for value in values]
        elements[element] = (first + own + last, rows)
    return Ply(form, ["comment made by a test", "obj_info any", "comment texturefile is not TextureFile"], elements)


def without_texture(ply):
    """Elements by name as lists of columns, by name of the property. That points have texture coordinates, too, would
    be a contradiction."""
    return {element: {(name, kind, size): [row[i] for row in rows] for i, (name, kind, size) in enumerate(properties)
                      if name not in ("texcoord", "s", "t")} for element, (properties, rows) in ply.elements.items()}


class Kept(Case):
    def unwrap_ply(self, *options):
        exit_code, report = self.report("in.ply", "-o", "out.ply", *options)
        self.assertEqual(exit_code, 0, report["message"])
        return Ply.from_bytes((self.folder / "out.ply").read_bytes())

    def check_texture(self, ply, uvs):
        """`uvs` are those that OBJ has for the same faces."""
        properties, rows = ply.elements["face"]
        places = [i for i, (name, _, _) in enumerate(properties) if name == "texcoord"]
        self.assertEqual(len(places), 1)
        self.assertEqual(properties[places[0]], ("texcoord", "double", "uint"))
        self.assertEqual([row[places[0]] for row in rows], uvs)

    def uvs_of_obj(self):
        self.report("in.ply", "-o", "out.obj")
        lines = [line.split() for line in (self.folder / "out.obj").read_text().splitlines()]
        points = [list(map(float, words[1:])) for words in lines if words[0] == "vt"]
        return [[x for word in words[1:] for x in points[int(word.split("/")[1]) - 1]]
                for words in lines if words[0] == "f"]

    def test_all_kinds_of_properties(self):
        print(f"seed {SEED}")
        generator = random.Random(SEED)
        for number in range(24):
            ply = random_file(FORMS[number % 3], generator)
            self.write("in.ply", ply.to_bytes())
            with self.subTest(number=number):
                out = self.unwrap_ply()
                self.assertEqual((out.form, out.comments), (ply.form, ply.comments))
                self.assertEqual(list(out.elements), list(ply.elements))
                self.assertEqual(without_texture(out), without_texture(ply))
                self.assertFalse({"s", "t"} & {name for name, _, _ in out.elements["vertex"][0]})
                self.check_texture(out, self.uvs_of_obj())

    def test_again(self):
        """A file that the program wrote changes in nothing but its texture coordinates, back and forth."""
        for form in FORMS:
            self.write("in.ply", random_file(form, random.Random(SEED)).to_bytes())
            self.unwrap_ply("--margin", "20")
            first = (self.folder / "out.ply").read_bytes()
            self.write("in.ply", first)
            self.unwrap_ply()
            self.assertNotEqual((self.folder / "out.ply").read_bytes(), first)
            self.write("in.ply", (self.folder / "out.ply").read_bytes())
            self.unwrap_ply("--margin", "20")
            self.assertEqual((self.folder / "out.ply").read_bytes(), first)

    def test_lines(self):
        """Text keeps its line ends, also where a row goes over several lines."""
        vertices, faces = [(name, "float", None) for name in "xyz"], [("vertex_indices", "int", "uchar")]
        ply = Ply("ascii", [], {"vertex": (vertices, POINTS), "face": (faces, [[face] for face in FACES])})
        data = ply.to_bytes("\r\n")
        self.write("in.ply", data)
        self.unwrap_ply()
        out = (self.folder / "out.ply").read_bytes()
        self.assertEqual(out.count(b"\n"), out.count(b"\r\n"))
        self.assertEqual(out.count(b"\n"), data.count(b"\n") + 1)  # the property
        self.write("in.ply", ply.to_bytes().replace(b"3 0 ", b"3 0\n"))
        broken = self.unwrap_ply()
        self.write("in.ply", ply.to_bytes())
        self.assertEqual(broken.elements, self.unwrap_ply().elements)

    def test_texture_comment(self):
        ply = random_file("binary_little_endian", random.Random(SEED))
        ply.comments.insert(1, "comment TextureFile old.png")
        self.write("in.ply", ply.to_bytes())
        self.assertEqual(self.unwrap_ply().comments, ply.comments)
        out = self.unwrap_ply("--texture", "new.png")
        named = [comment for comment in out.comments if "TextureFile " in comment and "is not" not in comment]
        self.assertEqual(named, ["comment TextureFile new.png"])
        self.assertEqual(len(out.comments), len(ply.comments))
        self.assertEqual(without_texture(out), without_texture(ply))

    def test_looks_in_other_formats(self):
        """Normals and colors of vertices from PLY to OBJ and back."""
        names = ["x", "y", "z", "nx", "ny", "nz"]
        properties = [(name, "float", None) for name in names] + [(c, "uchar", None) for c in ("red", "green", "blue")]
        rows = [[*point, *point, 51 * (i % 6), 0, 255] for i, point in enumerate(POINTS)]
        self.write("in.ply", Ply("binary_big_endian", [], {
            "vertex": (properties, rows),
            "face": ([("vertex_index", "int", "uchar")], [[face] for face in FACES])}).to_bytes())
        self.report("in.ply", "-o", "out.obj")
        lines = [line.split() for line in (self.folder / "out.obj").read_text().splitlines()]
        self.assertEqual([[float(x) for x in words[1:]] for words in lines if words[0] == "v"],
                         [[*point, i % 6 / 5, 0, 1] for i, point in enumerate(POINTS)])
        self.assertEqual([tuple(map(float, words[1:])) for words in lines if words[0] == "vn"], POINTS)
        normals = [[int(word.split("/")[2]) - 1 for word in words[1:]] for words in lines if words[0] == "f"]
        self.assertEqual(normals, FACES)
        self.report("out.obj", "-o", "out.ply")
        rows = Ply.from_bytes((self.folder / "out.ply").read_bytes()).elements["vertex"][1]
        self.assertEqual([row[3:] for row in rows], [[*point, 51 * (i % 6), 0, 255] for i, point in enumerate(POINTS)])

    def test_from_obj(self):
        self.write("in.obj", to_obj(SPHERE))
        self.report("in.obj", "-o", "in.ply")
        ply = Ply.from_bytes((self.folder / "in.ply").read_bytes())
        self.assertEqual([tuple(row) for row in ply.elements["vertex"][1]], [tuple(map(float, p)) for p in POINTS])
        self.assertEqual([row[0] for row in ply.elements["face"][1]], FACES)
        self.check_texture(ply, self.uvs_of_obj())


main()
