"""More effort leads to no worse cut."""

import math

from support import Case, main, sphere, to_off, torus


def with_bumps(mesh):
    """Uneven enough for cuts from different starts to differ."""
    def factor(x, y, z):
        return 1 + 0.4 * math.sin(3 * x + 1) * math.cos(4 * y) + 0.3 * math.sin(5 * z)
    return [tuple(factor(*p) * c for c in p) for p in mesh[0]], mesh[1]


MESHES = {"bumps": with_bumps(sphere(3)), "torus": torus(12)}


class Efforts(Case):
    def length_and_energy(self, name, *options):
        _, report = self.report(f"{name}.off", "-o", "out.obj", "--quiet", "--allow-overlap", *options)
        return report["cut_length"], report["E_iso"]

    # The smaller efforts are among what the best one compares, also from the seeds 0 to 2.
    def test_best_contains_the_others(self):
        for name, mesh in MESHES.items():
            self.write(f"{name}.off", to_off(mesh))
            for bound in ([], ["--max-distortion", "4.2"]):
                best, energy = self.length_and_energy(name, "--effort", "best", "--seed", 3, *bound)
                for effort in ("fast", "default"):
                    for seed in (0, 1, 3):
                        with self.subTest(mesh=name, bound=bound, effort=effort, seed=seed):
                            other, other_energy = self.length_and_energy(name, "--effort", effort, "--seed", seed, *bound)
                            if bound:
                                self.assertLessEqual(energy, 4.2)
                                self.assertLessEqual(best, other * (1 + 1e-9))
                            else:
                                self.assertFalse(other < best * (1 - 1e-9) and other_energy < energy - 1e-9)


main()
