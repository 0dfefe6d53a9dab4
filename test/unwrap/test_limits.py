"""Numbers at the limits of what a double holds, and surfaces of no extent or area: unwrapped, or refused with a reason."""

from support import EFFORTS, Case, joined, main, scaled, sphere, to_off

SPHERE = sphere(2)


def squashed(mesh, factor):
    return [(x, y, factor * z) for x, y, z in mesh[0]], mesh[1]


class Limits(Case):
    def test_without_extent(self):
        """There is no map to be found, but the search for one ends."""
        for mesh in (scaled(SPHERE, 0), joined(SPHERE, scaled(SPHERE, 0))):
            for options in EFFORTS:
                with self.subTest(options=options):
                    self.write("a.off", to_off(mesh))
                    self.assertIn(self.unwrap("a.off", "-o", "out.obj", *options).returncode, (0, 5))

    def test_without_area(self):
        """Next to the size of the whole, all edges but those at one vertex vanish."""
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1e304)]
        for options in EFFORTS:
            with self.subTest(options=options):
                self.write("a.off", to_off((points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])))
                report = self.assert_refused(5, "a.off", "-o", "out.obj", *options)
                self.assertIsNone(report["E_iso"])

    def test_parts_of_different_size(self):
        """Next to the large one's, the UVs of the small one are held as long as they differ in their digits."""
        for factor, expected in ((1e-3, 0), (1e-9, 0), (1e-20, 4), (1e-150, 4)):
            for options in EFFORTS:
                with self.subTest(factor=factor, options=options):
                    self.write("a.off", to_off(joined(scaled(SPHERE, factor), SPHERE)))
                    if expected == 0:
                        exit_code, report = self.report("a.off", "-o", "out.obj", *options)
                        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
                    else:
                        report = self.assert_refused(4, "a.off", "-o", "out.obj", *options)
                        self.assertEqual(report["witness"], {"kind": "vertices", "indices": list(range(len(SPHERE[0])))})
                        self.assertEqual(report["seconds"]["filter"], 0)

    def test_scale_does_not_matter(self):
        expected = self.assert_unwrapped(SPHERE)
        for exponent in (-1000, -664, 664, 1000):
            with self.subTest(exponent=exponent):
                report = self.assert_unwrapped(scaled(SPHERE, 2.0 ** exponent))
                for key in ("E_iso", "E_max", "cut_length", "features"):
                    self.assertEqual(report[key], expected[key])

    def test_squashed(self):
        for factor in (1e-3, 1e-6, 1e-12, 1e-30, 0):
            for options in EFFORTS:
                with self.subTest(factor=factor, options=options):
                    self.assert_unwrapped(squashed(SPHERE, factor), *options)

    def test_subnormal_numbers(self):
        for factor in (1e-309, 1e-315):
            with self.subTest(factor=factor):
                self.assert_unwrapped(scaled(SPHERE, factor))

    def test_failed_certificate(self):
        """The texture coordinates overflow: the certificate says so, and nothing is written."""
        self.write("a.off", to_off(scaled(SPHERE, 1e308)))
        report = self.assert_refused(5, "a.off", "-o", "out.obj", "--svg", "a.svg")
        self.assertIn("infinite", report["message"])
        self.assertEqual(report["witness"]["kind"], "faces")


main()
