"""What the program says on the terminal when it is done."""

import json
import re

from support import Case, main, sphere, to_off


class Summary(Case):
    def setUp(self):
        super().setUp()
        self.write("sphere.off", to_off(sphere(3)))

    def test_summary(self):
        run = self.unwrap("sphere.off", "--json", "a.json", "--html", "a.html", "--svg", "a.svg",
                          "--texture", "a.png", "--obj-cut", "cut.obj")
        report = json.loads((self.folder / "a.json").read_text())
        summary, written = run.stderr.decode().splitlines()
        found = re.fullmatch(r"sphere\.off: 512 triangles in 1 chart, stretched by (\S+) % on average \(energy (\S+)\), "
                             r"cut of (\S+) bounding box diagonals, (\S+) % of the square filled, \d+\.\d\d? s", summary)
        self.assertIsNotNone(found, summary)
        stretch, mean, length, fill = map(float, found.groups())
        # The energy of a map that stretches by s and 1/s.
        s = 1 + stretch / 100
        self.assertLess(abs(2 * (s ** 2 + s ** -2) - report["E_iso"]), 0.02)
        for shown, value in ((mean, report["E_iso"]), (length, report["cut_length"]), (fill / 100, report["fill"])):
            self.assertLess(abs(shown - value), 0.001 * value)
        files = set(self.files()) - {"sphere.off"}
        self.assertEqual(set(re.fullmatch("written: (.*)", written).group(1).split(", ")), files)

    def test_many_charts(self):
        triangles = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(120)]
        points = [(i % 12 + x, i // 12 + y, 0) for i in range(120) for x, y in ((0, 0), (0.9, 0), (0, 0.9))]
        self.write("many.off", to_off((points, triangles)))
        run = self.unwrap("many.off", "--weld", "off", "--effort", "fast")
        self.assertEqual(run.returncode, 0)
        self.assertIn(b"warning: the layout has 120 charts for 120 faces", run.stderr)
        self.assertIn(b"--weld on", run.stderr)
        self.assertNotIn(b"charts for", self.unwrap("sphere.off").stderr)


main()
