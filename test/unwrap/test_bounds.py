"""Bounds on the energy of triangles and of charts: decided by what is written, measured here anew."""

import math

from support import Case, cut_edges, decorated_obj, joined, main, read_obj, scaled, selection, sphere, to_off, torus


def triangle_energy(points, uvs):
    """Area and symmetric Dirichlet energy |J|^2 + |J^-1|^2 of the map of a triangle: by the Gram matrices of two of its edges."""
    (a, b), (c, d) = ([[p[i] - q[0][i] for i in range(len(p))] for p in q[1:]] for q in (points, uvs))
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    det = dot(a, a) * dot(b, b) - dot(a, b) ** 2
    trace = dot(b, b) * dot(c, c) - 2 * dot(a, b) * dot(c, d) + dot(a, a) * dot(d, d)
    return math.sqrt(det) / 2, trace / det + trace / (dot(c, c) * dot(d, d) - dot(c, d) ** 2)


def charts_of(faces):
    """Per face, a number that faces joined by texture coordinates share."""
    parent = {}

    def root(v):
        while parent.setdefault(v, v) != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v
    for face in faces:
        for _, uv in face[1:]:
            parent[root(uv)] = root(face[0][1])
    return [root(face[0][1]) for face in faces]


class Layout:
    """What is written, measured at the scale of the report."""

    def __init__(self, path, report):
        points, uvs, faces = read_obj(path)
        self.faces, self.charts = [], {}
        for face, chart in zip(faces, charts_of(faces)):
            for i in range(1, len(face) - 1):  # of polygons, as fans: only of triangles exact
                corners = face[0], face[i], face[i + 1]
                area, energy = triangle_energy([points[v] for v, _ in corners],
                                               [[x / report["uv_scale"] for x in uvs[t]] for _, t in corners])
                self.faces.append((energy, area))
                self.charts.setdefault(chart, []).append((energy, area))

    @staticmethod
    def mean(faces):
        return sum(e * a for e, a in faces) / sum(a for _, a in faces)

    def share_above(self, bound):
        return sum(a for e, a in self.faces if e > bound) / sum(a for _, a in self.faces)


def plate_with_needle(n, column, row):
    """n by n squares, of which one corner is lifted."""
    points = [(x, y, 3 if (x, y) == (column, row) else 0) for y in range(n + 1) for x in range(n + 1)]
    faces = []
    for y in range(n):
        for x in range(n):
            a = (n + 1) * y + x
            faces += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
    return points, faces


class Bounds(Case):
    def layout(self, mesh, *options, to_text=to_off, name="mesh.off", code=0):
        self.write(name, to_text(mesh))
        exit_code, report = self.report(name, "-o", "out.obj", *options)
        self.assertEqual((exit_code, report["flips"], report["overlaps"]), (code, 0, 0), report["message"])
        return report, Layout(self.folder / "out.obj", report)

    MESHES = {"sphere": sphere(3), "torus": torus(12), "parts": joined(sphere(3), scaled(torus(8), 0.3)),
              "ellipsoid": ([(4 * x, y, z) for x, y, z in sphere(3)[0]], sphere(3)[1]), "plate": plate_with_needle(12, 4, 3)}

    def test_faces(self):
        for name, mesh in self.MESHES.items():
            for bound in (8, 5):
                for effort in ("fast", "default"):
                    with self.subTest(mesh=name, bound=bound, effort=effort):
                        report, layout = self.layout(mesh, "--max-face-distortion", bound, "--effort", effort)
                        largest = max(e for e, _ in layout.faces)
                        self.assertLessEqual(largest, bound)
                        self.assertAlmostEqual(report["E_max"], largest, delta=1e-6 * largest)

    def test_quantile(self):
        for name, mesh in self.MESHES.items():
            with self.subTest(mesh=name):
                report, layout = self.layout(mesh, "--max-face-distortion", 4.6, "--face-quantile", 0.97)
                self.assertLessEqual(layout.share_above(4.6), 0.03)

    def test_charts(self):
        for name, mesh in self.MESHES.items():
            with self.subTest(mesh=name):
                report, layout = self.layout(mesh, "--max-chart-distortion", 4.05)
                means = [layout.mean(faces) for faces in layout.charts.values()]
                self.assertLessEqual(max(means), 4.05)
                self.assertEqual(len(means), report["charts"])

    def test_all_together(self):
        for name, mesh in self.MESHES.items():
            with self.subTest(mesh=name):
                report, layout = self.layout(mesh, "--max-face-distortion", 6, "--max-chart-distortion", 4.1,
                                             "--max-distortion", 4.05)
                self.assertLessEqual(max(e for e, _ in layout.faces), 6)
                self.assertLessEqual(layout.mean(layout.faces), 4.05)
                self.assertLessEqual(max(map(layout.mean, layout.charts.values())), 4.1)

    # The report says what is measured here.
    def test_report(self):
        report, layout = self.layout(self.MESHES["parts"])
        self.assertEqual(list(report["E_quantiles"]), ["0.5", "0.9", "0.99", "0.999", "1"])
        area = sum(a for _, a in layout.faces)
        for share, energy in report["E_quantiles"].items():
            below = lambda limit: sum(a for e, a in layout.faces if e <= limit)
            self.assertGreaterEqual(below(energy * (1 + 1e-6)), float(share) * area * (1 - 1e-9))
            self.assertLessEqual(below(energy * (1 - 1e-6)), float(share) * area)
        self.assertEqual(len(report["charts_distortion"]), report["charts"])
        self.assertEqual(sum(chart["faces"] for chart in report["charts_distortion"]), report["faces"])
        found = sorted((layout.mean(faces), max(e for e, _ in faces)) for faces in layout.charts.values())
        for chart, (mean, largest) in zip(sorted(report["charts_distortion"], key=lambda chart: chart["mean"]), found):
            self.assertAlmostEqual(chart["mean"], mean, delta=1e-6)
            self.assertAlmostEqual(chart["max"], largest, delta=1e-6 * largest)

    def test_polygons(self):
        report, _ = self.layout(None, "--max-face-distortion", 6, to_text=lambda _: decorated_obj(sphere(2)), name="mesh.obj")
        self.assertLessEqual(report["E_max"], 6)
        self.assertEqual(sum(chart["faces"] for chart in report["charts_distortion"]), report["faces"])

    # Where one star alone is above the bound, a slit to it is all that changes.
    def test_change_is_local(self):
        n, column, row = 40, 15, 9
        mesh = plate_with_needle(n, column, row)
        report, layout = self.layout(mesh)
        self.assertEqual(cut_edges(self.folder / "out.obj"), set())
        self.assertGreater(report["E_max"], 6)
        self.layout(mesh, "--max-face-distortion", 5)
        slit = cut_edges(self.folder / "out.obj")
        self.assertIn((n + 1) * row + column, set().union(*slit))
        for x, y in (divmod(v, n + 1)[::-1] for edge in slit for v in edge):
            self.assertLessEqual(math.hypot(x - column, y - row), row)

    # With edges that must not be cut everywhere but along one cut, it cannot grow.
    def test_missed(self):
        mesh = sphere(2)
        self.layout(mesh)
        allowed = cut_edges(self.folder / "out.obj")
        edges = {tuple(sorted((face[i], face[i - 1]))) for face in mesh[1] for i in range(3)}
        never = self.write("never.txt", selection(edges=sorted(e for e in edges if frozenset(e) not in allowed)))
        for option in ("--max-face-distortion", "--max-chart-distortion"):
            with self.subTest(option=option):
                report, layout = self.layout(mesh, "--never-cut", never, option, 4.01, code=7)
                self.assertEqual(report["witness"]["kind"], "faces")
                above = [i for i, (energy, _) in enumerate(layout.faces) if energy > 4.01 or "chart" in option]
                self.assertEqual(report["witness"]["indices"], above)

    def test_usage(self):
        self.write("mesh.off", to_off(sphere(1)))
        for options in (["--max-face-distortion", 4], ["--max-chart-distortion", "nan"], ["--face-quantile", 0.5],
                        ["--max-face-distortion", 5, "--face-quantile", 0], ["--max-face-distortion", 5, "--face-quantile", 1.1]):
            with self.subTest(options=options):
                self.assert_refused(2, "mesh.off", *options)


main()
