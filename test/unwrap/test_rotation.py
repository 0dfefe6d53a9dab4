"""How charts lie: aligned with the axes unless that costs much, and as --rotate says."""

from support import Case, joined, main, read_obj, scaled, sphere, to_off


class Rotation(Case):
    def borders_of_layout(self, *options):
        """The edges of a cube's cross in the layout that belong to one side only, as differences, and its middle."""
        points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        self.write("cube.off", f"OFF\n8 6 0\n" + "".join("%g %g %g\n" % p for p in points)
                   + "".join("4 %d %d %d %d\n" % f for f in faces))
        self.assertEqual(self.unwrap("cube.off", "-o", "cube.obj", "--max-distortion", "4.001", *options).returncode, 0)
        _, uvs, faces = read_obj(self.folder / "cube.obj")
        sides = [(face[k - 1][1], face[k][1]) for face in faces for k in range(len(face))]
        return [[uvs[b][i] - uvs[a][i] for i in (0, 1)] for a, b in sides if (b, a) not in sides]

    def test_cross_of_a_cube_is_straight(self):
        for options in ([], ["--rotate", "quarter"], ["--rotate", "none"], ["--uv-scale", "surface"]):
            with self.subTest(options=options):
                borders = self.borders_of_layout(*options)
                self.assertEqual(len(borders), 14)
                for side in borders:
                    self.assertLess(min(map(abs, side)), 1e-6 * max(map(abs, side)))
        self.assertTrue(any(min(map(abs, side)) > 0.1 * max(map(abs, side)) for side in self.borders_of_layout("--rotate", "any")))

    def test_rotation_costs_little(self):
        self.write("parts.off", to_off(joined(sphere(2), ([(x + 9, y, z) for x, y, z in sphere(1)[0]], sphere(1)[1]))))
        fill = {words: self.report("parts.off", *words)[1]["fill"]
                for words in ((), ("--rotate", "any"), ("--rotate", "quarter"), ("--rotate", "none"))}
        self.assertGreaterEqual(fill[()], 0.9699 * fill["--rotate", "any"])
        self.assertGreaterEqual(fill["--rotate", "any"] * 1.03, fill["--rotate", "quarter"])

    def test_long_search(self):
        """Two charts of one shape, one twice as large, change places so often that weights of contacts could overflow."""
        self.assert_unwrapped(joined(sphere(1), scaled(sphere(1), 2)), "--rotate", "any")


main()
