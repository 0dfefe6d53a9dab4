"""Constraints from files: they are satisfied, and what is wrong with them is said."""

from support import Case, cut_edges, main, selection, sphere, to_obj, to_off, torus

SPHERE = sphere(3)
# Some edges around a vertex, and the loop around it.
CENTER = 70
STAR = [tuple(v for v in face if v != CENTER) for face in SPHERE[1] if CENTER in face]


def divided_box(n):
    """A cube, each side of which is n by n quads, side by side in the order of faces, and its edges as pairs of points."""
    index, faces, hard = {}, [], set()

    def point(p):
        return index.setdefault(p, len(index))
    for axis in range(3):
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    square = []
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, i + a, j + b
                        square.append(point(tuple(p)))
                    faces.append(square if side else square[::-1])
    for p in index:
        for axis in range(3):
            q = tuple(x + (k == axis) for k, x in enumerate(p))
            if q in index and all(p[k] in (0, n) for k in range(3) if k != axis):
                hard.add(frozenset((index[p], index[q])))
    return (list(index), faces), hard


SELECTIONS = ("--must-cut", "--never-cut", "--initial-cut", "--terminals")
FILES = (*SELECTIONS, "--edge-weights")


class Constraints(Case):
    def setUp(self):
        super().setUp()
        self.write("sphere.off", to_off(SPHERE))

    def cut(self, *arguments):
        exit_code, report = self.report("sphere.off", *arguments)
        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
        return report, cut_edges(self.folder / "sphere.uv.obj")

    def test_must_and_never(self):
        loop = self.write("loop.txt", selection(edges=STAR))
        report, cut = self.cut("--must-cut", loop)
        self.assertLessEqual(set(map(frozenset, STAR)), cut)
        self.assertEqual((report["components"], report["genus"], report["borders"]), (1, 0, 0))
        self.assertLessEqual(report["cut_lower_bound"], report["cut_length"] + 1e-12)

        cut_by_default = self.cut()[1]
        never = self.write("never.txt", selection(edges=map(tuple, cut_by_default)))
        self.assertFalse(self.cut("--never-cut", never)[1] & cut_by_default)

    def test_terminals(self):
        terminals = self.write("terminals.txt", selection(vertices=[CENTER, 100, 200]))
        report, cut = self.cut("--terminals", terminals)
        self.assertLessEqual({CENTER, 100, 200}, set().union(*cut))
        self.assertGreaterEqual(report["features"], 3)

    # Edges that the input tells: the hard ones of a box, whose sides are divided, and the borders of materials and groups.
    def test_known_edges(self):
        n = 4
        box, hard = divided_box(n)
        self.write("box.off", to_off(box))
        exit_code, report = self.report("box.off", "-o", "out.obj", "--must-cut", "angle:90")
        self.assertEqual((exit_code, report["charts"]), (0, 6), report["message"])
        self.assertEqual(cut_edges(self.folder / "out.obj"), hard)
        for angle, charts in (("90.1", 1), ("1", 6)):
            _, report = self.report("box.off", "-o", "out.obj", "--must-cut", f"angle:{angle}", "--max-distortion", 4.5)
            self.assertEqual((report["charts"], bool(report["warnings"])), (charts, charts == 1))

        sides = len(box[1]) // 6
        lines = to_obj(box).splitlines()
        first = next(i for i, line in enumerate(lines) if line.startswith("f "))
        words = {"materials": "usemtl", "groups": "g"}
        for word, statement in words.items():
            named = [*lines[:first], f"{statement} one", *lines[first:first + sides], f"{statement} two", *lines[first + sides:]]
            self.write("box.obj", "\n".join(named) + "\n")
            exit_code, report = self.report("box.obj", "-o", "out.obj", "--must-cut", word)
            self.assertEqual(exit_code, 0, report["message"])
            one, two = ({frozenset((f[i], f[i - 1])) for f in part for i in range(len(f))}
                        for part in (box[1][:sides], box[1][sides:]))
            self.assertLessEqual(one & two, cut_edges(self.folder / "out.obj"))
            other, = words.keys() - {word}
            self.assert_refused(4, "box.obj", "-o", "no.obj", "--must-cut", other)
        for word in ("angle:", "angle:181", "angle:x"):
            self.assert_refused(2, "box.off", "-o", "no.obj", "--must-cut", word)

    # Several words and files together.
    def test_must_cut_several(self):
        box, hard = divided_box(3)
        self.write("box.off", to_off(box))
        inner = next((a, b) for face in box[1] for a, b in zip(face, face[1:]) if frozenset((a, b)) not in hard)
        file = self.write("inner.txt", selection(edges=[inner]))
        _, report = self.report("box.off", "-o", "out.obj", "--must-cut", "angle:60", "--must-cut", file)
        self.assertLessEqual(hard | {frozenset(inner)}, cut_edges(self.folder / "out.obj"), report["message"])

    def test_hard_surface(self):
        box, hard = divided_box(4)
        self.write("box.off", to_off(box))
        preset, words = (self.report("box.off", "-o", "out.obj", *options)[1]
                         for options in (["--hard-surface"], ["--edge-weights", "hard", "--edge-weights", "straight"]))
        self.assertEqual((preset["cut_cost"], preset["cut_length"]), (words["cut_cost"], words["cut_length"]))
        self.assertLessEqual(cut_edges(self.folder / "out.obj"), hard)

    def test_initial_cut(self):
        # The result of a hasty run as the start of the next one: a tighter bound extends it, the same one and a looser one
        # shorten it.
        given, cut = self.cut("--max-distortion", "4.1", "--effort", "fast")
        start = self.write("start.txt", selection(edges=map(tuple, cut)))
        lengths = []
        for bound in (4.05, 4.1, 4.5):
            report, _ = self.cut("--initial-cut", start, "--max-distortion", bound)
            self.assertLessEqual(report["E_iso"], bound)
            lengths.append(report["cut_length"])
        self.assertGreater(lengths[0], given["cut_length"])
        self.assertLess(lengths[1], given["cut_length"])
        self.assertLess(lengths[2], lengths[1])
        # Without a bound, what it is shortened by does not cost much.
        for effort in ("fast", "default"):
            report, _ = self.cut("--initial-cut", start, "--effort", effort)
            self.assertLess(report["E_iso"], given["E_iso"] + 0.15)
            self.assertLess(report["cut_length"], 1.05 * given["cut_length"])

    def test_good_initial_cut_stays(self):
        # The result of a search that takes three starts, for one that takes one; a tree through its ends is longer.
        given, cut = self.cut("--max-distortion", "4.1")
        start = self.write("start.txt", selection(edges=map(tuple, cut)))
        for effort in ("fast", "default"):
            report, _ = self.cut("--initial-cut", start, "--max-distortion", "4.1", "--effort", effort)
            self.assertLessEqual(report["E_iso"], 4.1)
            self.assertLess(report["cut_length"], given["cut_length"] + 1e-9)

    def test_initial_cut_is_no_constraint(self):
        # A loop that separates the surface is opened, and what must not be cut is not.
        loop = self.write("loop.txt", selection(edges=STAR))
        report, cut = self.cut("--initial-cut", loop)
        self.assertFalse(set(map(frozenset, STAR)) <= cut)
        self.assertEqual(report["components"], 1)
        _, cut = self.cut("--initial-cut", loop, "--never-cut", loop)
        self.assertFalse(set(map(frozenset, STAR)) & cut)

    def test_weights(self):
        self.assertIsNone(self.cut("--edge-weights", "crease")[0]["cut_lower_bound"])
        default, cut = self.cut()
        # All of a convex surface can be seen.
        self.assertEqual(self.cut("--edge-weights", "visibility")[0]["cut_length"], default["cut_length"])
        dear = self.write("dear.txt", "".join(f"{a} {b} 100 # dear\n" for a, b in map(tuple, cut)))
        self.assertFalse(self.cut("--edge-weights", dear)[1] & cut)
        same, _ = self.cut("--edge-weights", self.write("none.txt", "\n"))
        self.assertEqual(same["cut_length"], default["cut_length"])
        never = self.write("never.txt", "".join(f"{a} {b} inf\n" for a, b in map(tuple, cut)))
        self.assertFalse(self.cut("--edge-weights", never)[1] & cut)

    def test_huge_weights(self):
        """They are refused, and no edge becomes one that is not cut."""
        self.write("small.off", to_off(([tuple(0.01 * x for x in point) for point in SPHERE[0]], SPHERE[1])))
        a, b = STAR[0]
        for name in ("sphere.off", "small.off"):
            weights = self.write("huge.txt", f"{a} {b} 1e308\n")
            self.assertIn("sum of the weights is infinite",
                          self.assert_refused(2, name, "--edge-weights", weights)["message"])

    def test_same_for_every_number_of_threads(self):
        loop = self.write("loop.txt", selection(edges=STAR))
        files = []
        for threads in (1, 2):
            self.cut("--must-cut", loop, "--edge-weights", "visibility", "--threads", threads)
            files.append((self.folder / "sphere.uv.obj").read_bytes())
        self.assertEqual(*files)

    def test_infeasible(self):
        loop = self.write("loop.txt", selection(edges=STAR))
        report = self.assert_refused(4, "sphere.off", "--must-cut", loop, "--never-cut", loop)
        self.assertEqual((report["witness"]["kind"], len(report["witness"]["indices"])), ("edges", 2 * len(STAR)))

        spokes = self.write("spokes.txt", selection(edges=[(CENTER, v) for v in set(sum(STAR, ()))]))
        terminal = self.write("terminal.txt", selection(vertices=[CENTER, 3]))
        report = self.assert_refused(4, "sphere.off", "--never-cut", spokes, "--terminals", terminal)
        self.assertEqual(report["witness"], {"kind": "vertices", "indices": [CENTER]})

        self.write("torus.off", to_off(torus()))
        edges = [(a, b) for face in torus()[1] for a, b in zip(face, face[1:])]
        all_edges = self.write("all.txt", selection(edges=edges + [(face[2], face[0]) for face in torus()[1]]))
        self.assert_refused(4, "torus.off", "--never-cut", all_edges)

    def test_files_that_cannot_be_read(self):
        bad = {"three": "1 2\n\n3 4 5\n", "word": "x\n", "negative": "\n\n-1 2\n", "range": "642\n\n0 642\n",
               "fraction": "1.5\n\n1.5 2\n", "more": "\n\n\n1\n"}
        for name, text in bad.items():
            self.write(name, text)
            for option in SELECTIONS:
                with self.subTest(name=name, option=option):
                    report = self.assert_refused(3, "sphere.off", option, name)
                    self.assertIn(name, report["message"])
        for text in ("1", "1 2", "1 2 x", "1 2 1e309", "1 2 -3", "1 2 nan", "1 2 3 4", "0 642 1", "x", "-1 2 3", "1 2 -inf"):
            with self.subTest(weights=text):
                self.assert_refused(3, "sphere.off", "--edge-weights", self.write("weights", text + "\n"))
        for option in FILES:
            self.assert_refused(3, "sphere.off", option, "missing.txt")
            self.assert_refused(2, "sphere.off", option)

    def test_pairs_that_are_no_edges(self):
        name = self.write("pair.txt", selection(edges=[(0, 1)]))
        for option, file in (("--must-cut", name), ("--never-cut", name), ("--initial-cut", name),
                             ("--edge-weights", self.write("weights", "0 1 1\n"))):
            report = self.assert_refused(4, "sphere.off", option, file)
            self.assertIn("0 and 1", report["message"])
            self.assertEqual(report["witness"], {"kind": "edges", "indices": [0, 1]})
        self.assert_refused(4, "sphere.off", "--must-cut", self.write("same.txt", selection(edges=[(5, 5)])))

    def test_nothing_selected(self):
        nothing = self.write("nothing.txt", "")
        for option in SELECTIONS:
            report, _ = self.cut(option, nothing)
            self.assertEqual(len(report["warnings"]), 1)

    def test_files_are_not_replaced(self):
        loop = self.write("loop.txt", selection(edges=STAR))
        self.assert_refused(2, "sphere.off", "--must-cut", loop, "--svg", loop)


main()
