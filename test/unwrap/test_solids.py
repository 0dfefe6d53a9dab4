"""Simple solids come out as their nets where these are best."""

import math

from solids import SOLIDS, extruded, polygon
from support import Case, main, to_off


class Solids(Case):
    def measures(self, name, *options):
        return self.measures_of(SOLIDS[name], *options)

    def measures_of(self, solid, *options):
        self.write("solid.off", to_off(solid))
        _, report = self.report("solid.off", "-o", "out.obj", "--quiet", *options)
        self.assertEqual((report["status"], report["overlaps"], report["flips"]), ("done", 0, 0))
        return report["cut_length"], report["E_iso"]

    def total(self, name, *options):
        length, energy = self.measures(name, *options)
        return energy + 0.15 * length

    # A net is isometric, and its cut a tree of edges through all vertices, all of which are equally long here.
    def test_nets_of_regular_solids(self):
        edges_of_tree_over_diagonal = {"cube": 7 / math.sqrt(3), "tetrahedron": 3 * math.sqrt(2 / 3),
                                       "octahedron": 5 / math.sqrt(6)}
        for name, length in edges_of_tree_over_diagonal.items():
            for effort in ("fast", "default", "best"):
                with self.subTest(solid=name, effort=effort):
                    found, energy = self.measures(name, "--effort", effort)
                    self.assertAlmostEqual(energy, 4, delta=1e-6)
                    self.assertAlmostEqual(found, length, delta=1e-6)

    # Without a bound, the sum of energy and length is minimized: no bound leads to a smaller one.
    def test_no_bound_is_better_than_none(self):
        for name in SOLIDS:
            total = self.total(name)
            for bound in (4.02, 4.1, 4.3):
                with self.subTest(solid=name, bound=bound):
                    self.assertLessEqual(total, self.total(name, "--max-distortion", bound) + 0.01)

    # The largest part of a box that is a thin plate is its two sides, which stay whole.
    def test_plate(self):
        length, energy = self.measures("box 100 60 0.5")
        self.assertAlmostEqual(energy, 4, delta=1e-3)
        self.assertLess(length, 2)

    # Caps that are fans of needles around a corner: a disk of so many triangles has to be made coarser all the same.
    def test_needles(self):
        n = 500
        points, (bottom, top, *sides) = extruded(polygon(n), 3)
        fans = [(cap[0], cap[i], cap[i + 1]) for cap in (bottom, top) for i in range(1, n - 1)]
        _, energy = self.measures_of((points, [*fans, *sides]), "--effort", "fast")
        self.assertLess(energy, 4.1)


main()
