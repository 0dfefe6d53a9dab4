"""All that OBJ says besides its geometry: kept in its place, or named in a warning."""

import random
import re

from support import Case, main, sphere, to_obj, to_off

SPHERE = sphere(1)
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def statements(text):
    """The statements of an OBJ file, as a reader takes them that joins lines: lists of words, and comments as one word."""
    result = []
    for line in re.sub(r"\\\r?\n", " ", text).splitlines():
        words = line.split()
        if words:
            result.append([line.strip()] if line.startswith("#") else words)
    return result


def other_statements(text):
    """All but points, texture points and normals; faces are lists of points alone."""
    return [[words[0], *(word.split("/")[0] for word in words[1:])] if words[0] == "f" else words
            for words in statements(text) if words[0] not in ("v", "vt", "vn")]


class Statements(Case):
    def kept(self, text, *arguments):
        """The OBJ that is written for another one, and the warnings."""
        self.write("in.obj", text)
        code, report = self.report("in.obj", "-o", "out.obj", *arguments)
        self.assertEqual(code, 0, report["message"])
        return (self.folder / "out.obj").read_bytes().decode(errors="surrogateescape"), report["warnings"]

    def test_unknown_statements(self):
        text = "group one two\n" + TRIANGLE + "vw 0 0 1.0\nvw 1 0 0.5 1 0.5\nf 1 2 3\nshade flat\n"
        out, warnings = self.kept(text)
        self.assertEqual(other_statements(out), other_statements(text))
        self.assertEqual(len(warnings), 1)
        for part in ("4 statements", "vw (2, first in line 5)", "group (1, first in line 1)", "shade (1, first in line 8)"):
            self.assertIn(part, warnings[0])
        _, warnings = self.kept(TRIANGLE + "".join(f"word{i}\n" for i in range(9)) + "f 1 2 3")
        self.assertIn("4 other words", warnings[0])

    def test_damaged_statements(self):
        for line in ("1 2 3", "-1.5 2", ".5", "1/2/3", "v\0 1 2 3", "f 1 2 3 x", "v 1 2"):
            with self.subTest(line=line):
                self.write("in.obj", TRIANGLE + line + "\nf 1 2 3\n")
                self.assertIn("line 4", self.assert_refused(3, "in.obj")["message"])

    def test_elements_and_comments_stay_in_place(self):
        text = ("# made by hand\n#\n" + TRIANGLE + "# points end\nl 1 2 3\np 1 3\no thing\nf 1 2 3\n# between\n"
                "l 2 3\nf 3 2 1\n$ old comment\nbevel on\n# end")
        out, warnings = self.kept(text)
        self.assertEqual(other_statements(out), other_statements(text))
        self.assertEqual(warnings, [])
        self.assertTrue(out.startswith("# made by hand\n#\nv "))
        again, _ = self.kept(out)
        self.assertEqual(again, out)

    def test_comments_behind_statements(self):
        out, _ = self.kept("v 0 0 0 # first\n" + TRIANGLE[8:] + "f 1 2 3 # front\n")
        self.assertEqual(other_statements(out), [["# first"], ["f", "1", "2", "3"], ["# front"]])

    def test_indices_are_those_of_points(self):
        """Points come first in what is written, texture points are others, and normals may be."""
        text = ("v 0 0 0\nv 1 0 0\nl -2/7 -1/8\np -1\nv 0 1 0\ncstype bezier\ndeg 2\nsurf 0 1 0 1 -1/2/3 2/1/1 1\n"
                "curv 0 1 -3 -2 3\nvp 0.5\nparm u 0 1\ncurv2 -1\nend\nf 1 2 3\n")
        out, warnings = self.kept(text)
        self.assertEqual(other_statements(out), [line.split() for line in (
            "l 1 2", "p 2", "cstype bezier", "deg 2", "surf 0 1 0 1 3 2 1", "curv 0 1 1 2 3", "vp 0.5", "parm u 0 1",
            "curv2 -1", "end", "f 1 2 3")])
        self.assertEqual(warnings, [])

    def test_continued_statements(self):
        """Each statement may go on in the next line, at any of its blanks."""
        lines = ["v 0 0 0 0.5 0.25 1", "v 1 0 0 1 1 0", "v 0 1 0 0 0 0", "vt 0 0", "vn 0 0 1", "g one two", "s 1", "l 1 2 3",
                 "p 1 2", "parm u 0 0.5 1", "curv 0 1 1 2", "vw 0 0 1", "f 1/1/1 2/1/1 3/1/1", "o x"]
        whole, warnings = self.kept("\n".join(lines))
        seed = random.randrange(1000)
        print("seed", seed)
        generator = random.Random(seed)
        for end in ("\n", "\r\n"):
            broken = end.join("".join(f" \\{end}" if c == " " and generator.random() < 0.5 else c for c in line)
                              for line in lines)
            out, others = self.kept(broken)
            self.assertEqual(statements(out), statements(whole))
            self.assertEqual(len(others), len(warnings))

    def test_names_that_end_in_a_backslash(self):
        """A folder's name does not take the next statement with it, in no reader."""
        text = "mtllib C:\\\n" + TRIANGLE + "g C:\\\nusemtl D:\\\nf 1 2 3\no E:\\\n\nf 3 2 1\n"
        out, warnings = self.kept(text)
        self.assertEqual(warnings, [])
        for line in ("mtllib C:\\", "g C:\\", "usemtl D:\\", "o E:\\"):
            self.assertIn(line, out.splitlines())
        joined = [words[0] for words in statements(out)]  # by readers that join lines
        self.assertEqual([word for word in joined if word[0] != "v"], ["mtllib", "g", "usemtl", "f", "o", "f"])
        out, _ = self.kept("g a \\\nb\n" + TRIANGLE + "f 1 2 3\n")
        self.assertIn(["g", "a", "b"], statements(out))

    def test_names_as_they_are(self):
        names = ["a#1", "a  b", "#12", "x # y", "caf\udce9", "a\tb"]
        points, *faces = to_obj(SPHERE).split("f ")
        text = points + "".join(f"usemtl {name} \nf {face}" for name, face in zip(names + names[:1] * 99, faces))
        self.write("in.obj", text.encode(errors="surrogateescape"))
        self.assertEqual(self.report("in.obj", "-o", "out.obj")[0], 0)
        out = (self.folder / "out.obj").read_bytes().decode(errors="surrogateescape")
        self.assertEqual([line[7:] for line in out.split("\n") if line.startswith("usemtl")][:len(names)], names)
        self.assertEqual(self.report("out.obj", "-o", "out.glb")[0], 0)
        glb = (self.folder / "out.glb").read_bytes()
        for name in (b'"a#1"', b'"a  b"', b'"#12"'):
            self.assertIn(b'"name":' + name, glb)

    def test_material_file_has_a_name_that_obj_can_say(self):
        for name in ("a b#c", "a\nb", "tail\\"):
            with self.subTest(name=name):
                before = set(self.files())
                self.write("in.off", to_off(SPHERE))
                run = self.unwrap("in.off", "-o", f"{name}.obj", "--texture", "check.png")
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertIn(b"warning", run.stderr)
                self.assertEqual(run.stderr.count(b"\n"), 3)  # with the summary
                text = (self.folder / f"{name}.obj").read_text()
                library, = [words[1:] for words in statements(text) if words[0] == "mtllib"]
                self.assertEqual(len(library), 1)
                self.assertIn("newmtl checkerboard", (self.folder / library[0]).read_text())
                self.assertIn(["usemtl", "checkerboard"], statements(text))
                self.assertTrue(set(self.files()) - before >= {f"{name}.obj", library[0]})
        self.assert_refused(2, "in.off", "-o", "a.obj", "--texture", "a\nb.png")

    def test_painted_colors(self):
        """Hidden in comments: they stay there in OBJ, and become colors elsewhere."""
        colors = [(i * 15 % 256, 255 - i, 7 * i % 256) for i in range(len(SPHERE[0]))]
        digits = "".join("ff%02x%02x%02x" % color for color in colors)
        blocks = "".join(f"#MRGB {digits[i:i + 64]}\n" for i in range(0, len(digits), 64))
        points, faces = to_obj(SPHERE).split("f ", 1)
        out, warnings = self.kept(points + blocks + "f " + faces)
        self.assertIn(blocks, out)
        self.assertEqual(warnings, [])
        self.assertTrue(all(len(words) == 4 for words in statements(out) if words[0] == "v"))
        self.assertEqual(self.report("in.obj", "-o", "out.ply")[1]["warnings"], [])
        header, body = (self.folder / "out.ply").read_text().split("end_header\n")
        self.assertIn("property uchar red", header)
        self.assertEqual([tuple(map(int, line.split()[3:])) for line in body.splitlines()[:len(colors)]], colors)
        self.assertEqual(self.report("in.obj", "--edge-weights", "colors")[0], 0)

    def test_what_is_lost_is_told_once(self):
        text = ("# comment\nmtllib x.mtl\ng a\ns 1\nusemtl m\n" + TRIANGLE + "vn 0 0 1\nvn 0 1 0\nl 1 2\np 1\nvw 0 0 1\n"
                "bevel on\nf 1//1 2//1 3//1\nf 1//2 3//2 2//2\n")
        self.write("in.obj", text)
        kinds = {"out.obj": [],
                 "out.ply": ["normals", "materials", "names of material files", "groups and objects", "smoothing groups",
                             "lines", "points", "display settings", "unknown statements"],
                 "out.glb": ["names of material files", "smoothing groups", "lines", "points", "display settings",
                             "unknown statements", "comments"]}
        for name, lost in kinds.items():
            with self.subTest(name=name):
                code, report = self.report("in.obj", "-o", name)
                self.assertEqual(code, 0, report["message"])
                told = [warning for warning in report["warnings"] if name in warning]
                self.assertEqual([told[0].split(": ")[1].split(", ")] if told else [], [lost] if lost else [])
                self.assertEqual(len(report["warnings"]), 1 + len(told))
        self.write("plain.obj", "s off\n" + to_obj(SPHERE).replace("\nv ", " 1\nv "))
        for name in kinds:
            self.assertEqual(self.report("plain.obj", "-o", name)[1]["warnings"], [])
        warnings = self.report("in.obj", "-o", "out.obj", "--texture", "a.png")[1]["warnings"]
        self.assertIn("materials", warnings[-1])


main()
