"""What the tests of the program unwrap share: running it, and meshes in all formats.

Every test file is called with the program and a folder of meshes as arguments; the latter may be empty."""

import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

PROGRAM = os.path.abspath(sys.argv[1])
MESH_DIR = Path(os.environ.get("SURFACE_MESH_CUTTING_MESH_DIR", sys.argv[2]))
TIME_LIMIT = 60  # seconds, of any run
EFFORTS = (["--effort", "fast"], [], ["--bijective"], ["--faithful"])

PHASES = ["candidates", "filter", "connect", "refine", "parameterize", "packing", "total"]
KEYS = ["status", "message", "warnings", "witness", "vertices", "faces", "polygons", "interpreted",
        "components", "genus", "borders", "candidates", "features", "auxiliary", "cut_length", "cut_cost", "cut_lower_bound",
        "optimal", "E_iso", "E_max", "E_quantiles", "charts_distortion", "flips", "overlaps", "charts", "uv_scale", "fill", "pages",
        "texels_per_unit", "stacked", "distortion", "seams", "symmetry", "tradeoff",
        "seconds",
        "cpu_seconds", "factorized_unknowns", "threads", "seed", "effort", "solver", "peak_memory_mb"]
STATUS = {0: "done", 2: "usage", 3: "unreadable", 4: "unsupported", 5: "failed", 6: "stopped",
          7: "bound_not_reached"}


def main():
    del sys.argv[1:3]
    unittest.main(verbosity=2)


def as_nobody():
    """Keywords of `subprocess.run` by which root runs a program as a user with no rights."""
    user = 65534
    probe = subprocess.run([PROGRAM, "--version"], user=user, group=user, extra_groups=[], capture_output=True,
                           check=False)
    if probe.returncode != 0:
        raise unittest.SkipTest("the program cannot be run by others")
    return {"user": user, "group": user, "extra_groups": []}


class Case(unittest.TestCase):
    """A test in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, content):
        data = content if isinstance(content, bytes) else content.encode()
        (self.folder / name).write_bytes(data)
        return name

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def unwrap(self, *arguments, **keywords):
        """Runs the program and returns what `subprocess.run` does."""
        keywords = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **keywords}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, timeout=TIME_LIMIT, check=False,
                              **keywords)

    def report(self, *arguments):
        """Runs the program with a report on its standard output, which is checked."""
        run = self.unwrap(*arguments, "--json", "-")
        self.assertIn(run.returncode, STATUS, run.stderr)
        report = json.loads(run.stdout, parse_constant=self.fail)  # no NaN, no Infinity
        self.assertEqual(list(report), KEYS)
        self.assertEqual(list(report["seconds"]), PHASES)
        self.assertEqual(list(report["cpu_seconds"]), PHASES)
        self.assertEqual(list(report["factorized_unknowns"]), [phase for phase in PHASES if phase != "packing"])
        self.assertEqual(report["status"], STATUS[run.returncode])
        self.assertIsInstance(report["message"], str)
        self.assertIsInstance(report["warnings"], list)
        if run.returncode not in (0, 7):
            self.assertIn(report["message"], run.stderr.decode())
        elif report["tradeoff"]:  # the result is one of them
            distance = min(max(abs(length - report["cut_length"]), abs(energy / report["E_iso"] - 1))
                           for length, energy in report["tradeoff"])
            self.assertLess(distance, 1e-6)
        return run.returncode, report

    def assert_refused(self, code, *arguments):
        """The program fails with `code`, says why in a line, and writes nothing."""
        before = self.files()
        exit_code, report = self.report(*arguments)
        self.assertEqual(exit_code, code, report["message"])
        self.assertNotEqual(report["message"], "")
        self.assertNotIn("\n", report["message"])
        self.assertEqual(self.files(), before)
        return report

    def assert_unwrapped(self, mesh, *options):
        """Returns the report."""
        self.write("a.off", to_off(mesh))
        exit_code, report = self.report("a.off", "-o", "out.obj", *options)
        self.assertEqual((exit_code, report["flips"]), (0, 0), report["message"])
        self.assert_no_flips("out.obj")
        return report

    def assert_no_flips(self, name):
        """Exact and independent of the program: every triangle is counterclockwise."""
        _, uvs, faces = read_obj(self.folder / name)
        exact = [tuple(map(Fraction, uv)) for uv in uvs]
        for face in faces:
            a, b, c = (exact[corner[1]] for corner in face)
            self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)


# ------------------------------------------------------------------------------------------ meshes

def octahedron():
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    return points, faces


def sphere(levels):
    """An octahedron whose faces are split `levels` times and whose points are moved outward."""
    points, faces = octahedron()
    for _ in range(levels):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                point = [(s + t) / 2 for s, t in zip(points[a], points[b])]
                length = sum(x * x for x in point) ** 0.5
                points.append(tuple(x / length for x in point))
                middles[key] = len(points) - 1
            return middles[key]

        split = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = split
    # Single precision, so that binary formats hold the same points; no two axes alike.
    single = struct.Struct("<3f")
    return [single.unpack(single.pack(x, 1.25 * y, 1.5 * z)) for x, y, z in points], faces


def torus(n=6):
    """The points of an n x n grid; nothing is done to make it look like a torus."""
    points = [(i, j, (i * j) % 3) for i in range(n) for j in range(n)]
    faces = []
    for i in range(n):
        for j in range(n):
            a, b = n * i + j, n * ((i + 1) % n) + j
            c, d = n * ((i + 1) % n) + (j + 1) % n, n * i + (j + 1) % n
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def without_face(mesh):
    return mesh[0], mesh[1][1:]


def scaled(mesh, factor):
    return [tuple(factor * x for x in p) for p in mesh[0]], mesh[1]


def joined(mesh, other):
    shift = len(mesh[0])
    moved = [(x + 10, y, z) for x, y, z in other[0]]
    return mesh[0] + moved, mesh[1] + [tuple(v + shift for v in face) for face in other[1]]


# ----------------------------------------------------------------------------------------- formats

def to_off(mesh):
    points, faces = mesh
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, point)) for point in points]
    lines += [" ".join(map(str, (len(face), *face))) for face in faces]
    return "\n".join(lines) + "\n"


def to_obj(mesh):
    points, faces = mesh
    lines = ["v " + " ".join(map(repr, point)) for point in points]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    return "\n".join(lines) + "\n"


def ply_header(form, points, faces):
    return (f"ply\nformat {form} 1.0\ncomment made by a test\nelement vertex {points}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n")


def to_ply(mesh, form):
    points, faces = mesh
    header = ply_header(form, len(points), len(faces)).encode()
    if form == "ascii":
        lines = [" ".join(map(repr, point)) for point in points]
        lines += [" ".join(map(str, (len(face), *face))) for face in faces]
        return header + ("\n".join(lines) + "\n").encode()
    order = "<" if form == "binary_little_endian" else ">"
    body = b"".join(struct.pack(order + "3f", *point) for point in points)
    body += b"".join(struct.pack(f"{order}B{len(face)}i", len(face), *face) for face in faces)
    return header + body


def strips_ply(mesh, form, strips):
    """The faces of the mesh are left out."""
    data = to_ply((mesh[0], []), form)
    begin, end = data.index(b"element face"), data.index(b"end_header")
    header = b"element tristrips %d\nproperty list int int vertex_indices\n" % len(strips)
    lists = [[len(strip), *strip] for strip in strips]
    if form == "ascii":
        body = "".join(" ".join(map(str, numbers)) + "\n" for numbers in lists).encode()
    else:
        order = "<" if form == "binary_little_endian" else ">"
        body = b"".join(struct.pack(f"{order}{len(numbers)}i", *numbers) for numbers in lists)
    return data[:begin] + header + data[end:] + body


def colored_off(mesh):
    """One half of the points is white."""
    lines = to_off(mesh).replace("OFF", "COFF", 1).splitlines()
    lines[2:2 + len(mesh[0])] = [f"{line} " + ("255 255 255" if point[0] > 0 else "0 0 0")
                                 for line, point in zip(lines[2:], mesh[0])]
    return "\n".join(lines) + "\n"


def decorated_obj(mesh):
    """With the same colors, and texture points that two halves do not share."""
    points, faces = mesh
    lines = ["v " + " ".join(map(repr, point)) + (" 1 1 1" if point[0] > 0 else " 0 0 0") for point in points]
    lines += [f"vt {x + shift!r} {y!r}" for shift in (0, 10) for x, y, _ in points]
    for i, face in enumerate(faces):
        lines.append("f " + " ".join(f"{v + 1}/{v + 1 + i % 2 * len(points)}" for v in face))
    return "\n".join(lines) + "\n"


def decorated_ply(mesh):
    """The same as text."""
    points, faces = mesh
    header = ply_header("ascii", len(points), len(faces)).replace("float z\n", "float z\nproperty uchar red\n")
    lines = [" ".join(map(repr, point)) + (" 255" if point[0] > 0 else " 0") for point in points]
    for i, face in enumerate(faces):
        uvs = [x for v in face for x in (points[v][0] + i % 2 * 10, points[v][1])]
        lines.append(" ".join(map(str, (len(face), *face, 2 * len(face), *uvs))))
    return (header.replace("vertex_indices\n", "vertex_indices\nproperty list uchar float texcoord\n")
            + "\n".join(lines) + "\n")


def to_text_stl(mesh):
    points, faces = mesh
    lines = ["solid made by a test"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(map(repr, points[v])) for v in face]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid made by a test"]) + "\n"


def to_binary_stl(mesh):
    points, faces = mesh
    data = b"solid, but binary".ljust(80) + struct.pack("<I", len(faces))
    for face in faces:
        data += struct.pack("<12fH", 0, 0, 0, *(x for v in face for x in points[v]), 0)
    return data


def to_glb(points, triangles, nodes=({"mesh": 0},), uvs=None):
    """One mesh at several nodes."""
    buffer = b"".join(struct.pack("<3f", *p) for p in points) + b"".join(struct.pack("<3I", *t) for t in triangles)
    first, second = 12 * len(points), len(buffer)
    description = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": [min(p[i] for p in points) for i in range(3)],
                       "max": [max(p[i] for p in points) for i in range(3)]},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": first},
                        {"buffer": 0, "byteOffset": first, "byteLength": second - first}]}
    if uvs:
        buffer += b"".join(struct.pack("<2f", *uv) for uv in uvs)
        description["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2
        description["accessors"].append({"bufferView": 2, "componentType": 5126, "count": len(uvs), "type": "VEC2"})
        description["bufferViews"].append({"buffer": 0, "byteOffset": second, "byteLength": len(buffer) - second})
    text = json.dumps(description | {"buffers": [{"byteLength": len(buffer)}]}).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON")
            + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


def read_obj(path):
    """Points, texture points, and faces as lists of (point, texture point), counted from 0."""
    points, texture_points, faces = [], [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[0] == "v":
            points.append(tuple(map(float, words[1:4])))
        elif words[0] == "vt":
            texture_points.append(tuple(map(float, words[1:])))
        elif words[0] == "f":
            faces.append([tuple(int(i) - 1 for i in word.split("/")[:2]) for word in words[1:]])
    return points, texture_points, faces


def cut_edges(path, points=None):
    """The edges whose two sides have different texture points, by indices in the file or in the points given."""
    read_points, _, faces = read_obj(path)
    names = range(len(read_points)) if points is None else [points.index(point) for point in read_points]
    sides = {}
    for face in faces:
        named = [(names[v], uv) for v, uv in face]
        for (a, uv_a), (b, uv_b) in zip(named, named[1:] + named[:1]):
            sides.setdefault(frozenset((a, b)), []).append({a: uv_a, b: uv_b})
    return {edge for edge, (one, *other) in sides.items() if other and one != other[0]}


# -------------------------------------------------------------------------------------- constraints

def selection(vertices=(), edges=()):
    """A CGAL .selection.txt file."""
    return "\n".join([" ".join(map(str, vertices)), "", " ".join(f"{a} {b}" for a, b in edges)]) + "\n"
