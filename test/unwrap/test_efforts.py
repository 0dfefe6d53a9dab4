"""More effort leads to no worse cut."""

import math

from support import Case, main, sphere, to_off, torus


def with_bumps(mesh):
    """Uneven enough for cuts from different starts to differ."""
    def factor(x, y, z):
        return 1 + 0.4 * math.sin(3 * x + 1) * math.cos(4 * y) + 0.3 * math.sin(5 * z)
    return [tuple(factor(*p) * c for c in p) for p in mesh[0]], mesh[1]


def cross(arms):
    """Cubes in a row along each of some half axes, and one in the middle."""
    cubes = {(0, 0, 0), *(tuple(sign * length * (axis == k) for k in range(3))
                          for axis, sign, size in arms for length in range(1, size + 1))}
    points, faces = {}, []
    for cube in sorted(cubes):
        for axis in range(3):
            for side in (0, 1):
                if tuple(c + (2 * side - 1) * (axis == k) for k, c in enumerate(cube)) in cubes:
                    continue
                first, second = (axis + 1) % 3, (axis + 2) % 3
                corners = [tuple(c + (side if k == axis else a if k == first else b) for k, c in enumerate(cube))
                           for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                a, b, c, d = [points.setdefault(p, len(points)) for p in (corners if side else corners[::-1])]
                faces += [(a, b, c), (a, c, d)]
    return list(points), faces


def cap(mesh, lowest):
    """What is above that height: a disk."""
    return mesh[0], [f for f in mesh[1] if min(mesh[0][v][2] for v in f) > lowest]


MESHES = {"bumps": with_bumps(sphere(3)), "torus": torus(12)}


class Efforts(Case):
    def length_and_energy(self, name, *options):
        _, report = self.report(f"{name}.off", "-o", "out.obj", "--quiet", "--allow-overlap", *options)
        return report["cut_length"], report["E_iso"]

    # The objective without a bound.
    @staticmethod
    def total(length, energy):
        return energy + 0.15 * length

    # The smaller efforts are among what the best one compares.
    def test_best_contains_the_others(self):
        for name, mesh in MESHES.items():
            self.write(f"{name}.off", to_off(mesh))
            for bound in ([], ["--max-distortion", "4.2"]):
                best, energy = self.length_and_energy(name, "--effort", "best", "--seed", 3, *bound)
                for effort in ("fast", "default"):
                    with self.subTest(mesh=name, bound=bound, effort=effort):
                        other, other_energy = self.length_and_energy(name, "--effort", effort, "--seed", 3, *bound)
                        if bound:
                            self.assertLessEqual(energy, 4.2)
                            self.assertLessEqual(best, other * (1 + 1e-9))
                        else:
                            self.assertLessEqual(self.total(best, energy), self.total(other, other_energy) + 1e-9)

    # Single starts miss the bound on at least one of these.
    def test_a_bound_that_is_missed_starts_a_search(self):
        options = "-o", "out.obj", "--quiet", "--max-distortion", "4.1", "--effort"
        for longest in range(3):
            self.write("cross.off", to_off(cross([(axis, sign, 1 + (axis + sign + longest) % 3)
                                                  for axis in range(3) for sign in (-1, 1)])))
            for effort in ("fast", "default"):
                with self.subTest(longest=longest, effort=effort):
                    _, report = self.report("cross.off", *options, effort)
                    self.assertEqual((report["status"], report["overlaps"]), ("done", 0))
                    self.assertLessEqual(report["E_iso"], 4.1)

    # Slits bring the cut of the published method there, too.
    def test_the_published_method_keeps_a_bound(self):
        self.write("bumps.off", to_off(with_bumps(sphere(3))))
        _, unbounded = self.report("bumps.off", "-o", "out.obj", "--quiet", "--faithful")
        bound = (unbounded["E_iso"] + 4) / 2
        _, report = self.report("bumps.off", "-o", "out.obj", "--quiet", "--faithful", "--max-distortion", bound)
        self.assertEqual(report["status"], "done")
        self.assertLessEqual(report["E_iso"], bound)
        self.assertGreater(report["cut_length"], unbounded["cut_length"])

    # Where the border is cut enough, there is nothing to save; another map or two do no harm.
    def test_nothing_is_searched_where_nothing_is_cut(self):
        self.write("cap.off", to_off(cap(sphere(4), 0.7)))
        for effort in ("fast", "default"):
            with self.subTest(effort=effort):
                _, report = self.report("cap.off", "-o", "out.obj", "--quiet", "--max-distortion", "4.1", "--effort", effort)
                self.assertEqual((report["status"], report["cut_length"]), ("done", 0))
                self.assertLessEqual(report["factorized_unknowns"]["refine"], 4 * report["faces"])


main()
