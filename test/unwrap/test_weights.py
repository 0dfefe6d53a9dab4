"""Weights of edges: ready-made, painted and from files; their factors multiply."""

import struct

from support import Case, cut_edges, main, ply_header, read_obj, sphere, to_obj, to_off, to_text_stl

SPHERE = sphere(3)
POINTS, FACES = SPHERE
EDGES = sorted({(min(a, b), max(a, b)) for face in FACES for a, b in zip(face, face[1:] + face[:1])})
NAMES = ["crease", "concave", "straight", "visibility", "occlusion", "sky", "sky:z", "sky:-x"]
IS_RED = [x + 0.3 * y > 0.2 for x, y, _ in POINTS]
RED = [255 if is_red else 0 for is_red in IS_RED]


def length(a, b):
    return sum((s - t) ** 2 for s, t in zip(POINTS[a], POINTS[b])) ** 0.5


def weights(factor, edges=EDGES):
    return "".join(f"{a} {b} {factor * length(a, b)!r}\n" for a, b in edges)


def colored_off(keyword, color):
    """`color` is what stands behind the coordinates of a point."""
    lines = to_off(SPHERE).replace("OFF", keyword, 1).splitlines()
    lines[2:2 + len(POINTS)] = [f"{line} {color(red)}" for line, red in zip(lines[2:], RED)]
    return "\n".join(lines) + "\n"


def colored_obj(color):
    lines = to_obj(SPHERE).splitlines()
    lines[:len(POINTS)] = [f"{line} {color(red)}" for line, red in zip(lines, RED)]
    return "\n".join(lines) + "\n"


def colored_ply(color_type, form, largest):
    header = ply_header("binary_little_endian", len(POINTS), len(FACES)).replace(
        "property float z\n", f"property float z\nproperty {color_type} green\nproperty {color_type} red\n")
    body = b"".join(struct.pack("<3f2" + form, *point, 0, red // 255 * largest)
                    for point, red in zip(POINTS, RED))
    return header.encode() + body + b"".join(struct.pack("<B3i", 3, *face) for face in FACES)


COLORED = {
    "integers.off": colored_off("COFF", lambda red: f"{red} 0 7 255"),
    "fractions.off": colored_off("COFF", lambda red: f"{red / 255} 0.5 0"),
    "normals.off": colored_off("CNOFF", lambda red: f"0.5 0.6 0.7 {red} 0 0"),
    "fractions.obj": colored_obj(lambda red: f"{red / 255} 0.25 1.0 # red"),
    "integers.obj": colored_obj(lambda red: f"{red} 0 0"),
    "bytes.ply": colored_ply("uchar", "B", 255),
    "shorts.ply": colored_ply("ushort", "H", 65535),
    "fractions.ply": colored_ply("float", "f", 1),
}


class Weights(Case):
    def setUp(self):
        super().setUp()
        self.write("sphere.off", to_off(SPHERE))

    def cut(self, name, *words):
        """The report and the cut for these words of --edge-weights."""
        options = [option for word in words for option in ("--edge-weights", word)]
        exit_code, report = self.report(name, *options, "-o", "out.obj")
        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
        return report, cut_edges(self.folder / "out.obj")

    def assert_cost(self, factor, *words):
        report, _ = self.cut("sphere.off", *words)
        self.assertAlmostEqual(report["cut_cost"] / report["cut_length"], factor, 9)
        self.assertIsNone(report["cut_lower_bound"])

    def test_names(self):
        for name in NAMES:
            report, _ = self.cut("sphere.off", name)
            with self.subTest(name=name):
                self.assertLessEqual(report["cut_cost"], report["cut_length"] * (1 + 1e-12))
                self.assertGreater(report["cut_cost"], 0.19 * report["cut_length"])
        # Above a convex surface is nothing but sky: the darker cut is below.
        height = lambda word: sum(POINTS[v][1] for edge in self.cut("sphere.off", word)[1] for v in edge)
        self.assertLess(height("sky"), height("sky:-y"))
        self.assertEqual(height("sky"), height("sky:y"))

    def test_products(self):
        self.write("2.txt", "2\n" * len(POINTS))
        self.write("3.txt", "".join(f"{v} 3\n" for v in range(len(POINTS))))
        self.write("5.txt", weights(5))
        self.write("7.txt", weights(7))
        self.assert_cost(2, "paint:2.txt")
        self.assert_cost(5, "5.txt")
        self.assert_cost(6, "paint:2.txt", "paint:3.txt")
        self.assert_cost(10, "paint:2.txt", "5.txt")
        self.assert_cost(10, "5.txt", "paint:2.txt")
        self.assert_cost(35, "5.txt", "7.txt")
        self.assert_cost(70, "5.txt", "paint:2.txt", "7.txt")
        self.assert_cost(2, "visibility", "paint:2.txt")  # all of a convex surface can be seen

    def test_one_word_for_each_option(self):
        exit_code, report = self.report("--edge-weights", "crease", "sphere.off")
        self.assertEqual(exit_code, 0, report["message"])

    def test_edges_never_cut(self):
        """They stay so, whatever they are multiplied by."""
        _, default = self.cut("sphere.off")
        self.write("never.txt", "".join(f"{a} {b} inf\n" for a, b in map(tuple, default)))
        self.write("free.txt", "0\n" * len(POINTS))
        self.write("zero.txt", weights(0))
        for words in (("never.txt", "paint:free.txt"), ("paint:free.txt", "never.txt"), ("zero.txt", "never.txt"),
                      ("never.txt", "zero.txt"), ("never.txt", "crease")):
            with self.subTest(words=words):
                self.assertFalse(self.cut("sphere.off", *words)[1] & default)

    def test_paint_keeps_the_cut_away(self):
        is_dear = [x > 0 for x, _, _ in POINTS]
        dear_length = lambda cut: sum(length(*edge) for edge in map(tuple, cut) if all(is_dear[v] for v in edge))
        _, default = self.cut("sphere.off")
        self.write("all.txt", "".join("50 # dear\n" if dear else "1\n" for dear in is_dear))
        self.write("some.txt", "\n".join(f"{v} 50" for v, dear in enumerate(is_dear) if dear))
        _, cut = self.cut("sphere.off", "paint:all.txt")
        self.assertLess(dear_length(cut), 0.2 * dear_length(default))
        self.assertEqual(self.cut("sphere.off", "paint:some.txt")[1], cut)

    def test_colors(self):
        """The red channel, at the scale of each format, is the same as paint from 0.2 to 1."""
        self.write("paint.txt", "".join("1\n" if is_red else "0.2\n" for is_red in IS_RED))
        report, cut = self.cut("sphere.off", "paint:paint.txt")
        for name, content in COLORED.items():
            self.write(name, content)
            with self.subTest(name=name):
                colored, colored_cut = self.cut(name, "colors")
                self.assertEqual(read_obj(self.folder / "out.obj")[0], POINTS)
                self.assertEqual(colored_cut, cut)
                self.assertAlmostEqual(colored["cut_cost"], report["cut_cost"], 9)

    def test_without_colors(self):
        some = COLORED["integers.obj"].splitlines()
        some[5] = "v " + " ".join(map(repr, POINTS[5]))
        plain = {"plain.obj": to_obj(SPHERE), "plain.stl": to_text_stl(SPHERE), "some.obj": "\n".join(some) + "\n",
                 "no_color.off": colored_off("NOFF", lambda red: f"{red} 0 0")}
        for name, content in {**plain, "sphere.off": to_off(SPHERE)}.items():
            self.write(name, content)
            with self.subTest(name=name):
                self.assertIn("no colors", self.assert_refused(4, name, "--edge-weights", "colors")["message"])

    def test_colors_that_cannot_be_read(self):
        bad = {"above.off": colored_off("COFF", lambda red: f"{red + 1} 0 0"),
               "below.obj": colored_obj(lambda red: f"{red - 0.5} 0 0"),
               "word.obj": colored_obj(lambda red: "red 0 0"), "nan.obj": colored_obj(lambda red: "nan 0 0"),
               "above.ply": colored_ply("float", "f", 2)}
        for name, content in bad.items():
            self.write(name, content)
            with self.subTest(name=name):
                self.assert_refused(3, name, "--edge-weights", "colors")
                self.assertEqual(self.unwrap(name, "-o", "out.obj").returncode, 0)  # nobody asks for colors
                (self.folder / "out.obj").unlink()

    def test_paint_that_cannot_be_read(self):
        count = len(POINTS)
        bad = {"x": 1, "1\nx": 2, "-1": 1, "1\n\n-0.5": 3, "inf": 1, "nan": 1, "1e309": 1, "0 inf": 1, "1 2 3": 1,
               "1\n2 3": 2, "1 2\n3": 2, "-1 2": 1, "0.5 2": 1, "0 1\n1 x": 2}
        for text, line in bad.items():
            with self.subTest(text=text):
                message = self.assert_refused(3, "sphere.off", "--edge-weights",
                                              "paint:" + self.write("paint.txt", text))["message"]
                self.assertIn(f"paint.txt: line {line}: ", message)
        for text, part in (("1\n" * (count - 1), f"{count - 1} numbers for {count}"), ("1\n" * (count + 1), "numbers"),
                           (f"{count} 1\n", f"vertex {count}")):
            message = self.assert_refused(3, "sphere.off", "--edge-weights", "paint:" + self.write("p", text))["message"]
            self.assertIn(part, message)
        self.assert_refused(3, "sphere.off", "--edge-weights", "paint:missing.txt")
        self.assertEqual(self.cut("sphere.off", "paint:" + self.write("none.txt", "# none\n"))[1],
                         self.cut("sphere.off")[1])

    def test_trade_offs(self):
        """No cut is listed that another one is better than, but for the result, which has the least cost."""
        for name in ("crease", "straight", "visibility"):
            exit_code, report = self.report("sphere.off", "--edge-weights", name)
            self.assertEqual(exit_code, 0)
            cuts = report["tradeoff"]
            own = min(cuts, key=lambda cut: abs(cut[0] - report["cut_length"]) + abs(cut[1] - report["E_iso"]))
            for cut in cuts:
                if cut != own:
                    self.assertFalse([other for other in cuts if other != cut and other[0] <= cut[0] and other[1] <= cut[1]])

    def test_words(self):
        for word in ("sky:", "sky:q", "sky:Y", "sky:+y", "paint:"):
            self.assertIn(word, self.assert_refused(2, "sphere.off", "--edge-weights", word)["message"])
        for word in ("Crease", "creases", "sky=y"):  # no names, and no files
            self.assert_refused(3, "sphere.off", "--edge-weights", word)
        self.write("crease", weights(5))
        self.assert_cost(5, "./crease")
        self.write("paint:crease", weights(3))
        self.assert_cost(3, "./paint:crease")

    def test_files_are_not_replaced(self):
        self.write("paint.txt", "2\n" * len(POINTS))
        self.write("weights.txt", weights(1))
        for output in ("paint.txt", "weights.txt"):
            self.assert_refused(2, "sphere.off", "--edge-weights", "weights.txt", "--edge-weights", "paint:paint.txt",
                                "--svg", output)

    def test_same_for_every_number_of_threads(self):
        for word in ("occlusion", "sky"):
            files = []
            for threads in (1, 2):
                run = self.unwrap("sphere.off", "--edge-weights", word, "--threads", threads, "-o", "out.obj")
                self.assertEqual(run.returncode, 0, run.stderr)
                files.append((self.folder / "out.obj").read_bytes())
            self.assertEqual(*files)


main()
