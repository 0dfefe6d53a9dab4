"""What the program writes, read by assimp (Debian's assimp-utils) and by the validator of Khronos (gltf-validator of npm).

Tests whose tool is missing are skipped."""

import json
import shutil
import subprocess
import unittest

from gltf_files import full
from support import Case, main, sphere, to_off, torus

QUADS = [tuple(one) + (two[2],) for one, two in zip(torus(8)[1][::2], torus(8)[1][1::2])]
POINTS = [(x + 0.125 * y, y - 0.25 * x * x, z + 0.0625 * x * y) for x, y, z in torus(8)[0]]
TRIANGLES = sphere(1)[1]
MIXED = (POINTS + [(x + 20, y, z) for x, y, z in sphere(1)[0]],
         QUADS + [tuple(v + len(POINTS) for v in face) for face in TRIANGLES])
# Where groups and materials begin, all different, as not every reader knows of faces without any.
STATEMENTS = {0: ["g one", "usemtl red"], 20: ["usemtl blue"], len(QUADS): ["g two parts"],
              len(QUADS) + 9: ["usemtl red"]}
PARTS = {("one", "red"): range(20), ("one", "blue"): range(20, len(QUADS)),
         ("two parts", "blue"): range(len(QUADS), len(QUADS) + 9),
         ("two parts", "red"): range(len(QUADS) + 9, len(MIXED[1]))}
MATERIALS = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n"

VALIDATE = """
const validator = require('gltf-validator'), fs = require('fs');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))
  .then(report => console.log(JSON.stringify(report.issues)), error => { console.error(error); process.exit(1); });
"""


def has_validator():
    return shutil.which("node") is not None and subprocess.run(
        ["node", "-e", "require('gltf-validator')"], capture_output=True, check=False).returncode == 0


def decorated_obj(mesh):
    """With groups, materials, colors, and normals of some faces."""
    lines = ["mtllib in.mtl"] + [f"v {x!r} {y!r} {z!r} 1.0 {i % 2 * 0.5} 0.25" for i, (x, y, z) in enumerate(mesh[0])]
    lines += ["vn 0 0 3", "vn 0 nan 0"]
    for i, face in enumerate(mesh[1]):
        lines += STATEMENTS.get(i, [])
        normal = "" if i % 3 else f"//{1 + i % 2}"
        lines.append("f " + " ".join(f"{v + 1}{normal}" for v in face))
    return "\n".join(lines) + "\n"


def rounded(point):
    return tuple(round(x, 3) + 0.0 for x in point)  # assimp writes six digits


def rotated(polygon):
    start = polygon.index(min(polygon))
    return tuple(polygon[start:] + polygon[:start])


class By_others(Case):
    def write_all(self, mesh, *options):
        self.write("in.obj", decorated_obj(mesh))
        self.write("in.mtl", MATERIALS)
        for name in ("out.obj", "out.ply", "out.glb"):
            exit_code, report = self.report("in.obj", "-o", name, *options)
            self.assertEqual(exit_code, 0, report["message"])

    def read(self, name):
        """The parts that assimp finds: group, material, polygons of points, and UVs of their corners."""
        run = subprocess.run(["assimp", "export", name, "read.json", "-fassjson"], cwd=self.folder, capture_output=True,
                             text=True, check=False)
        self.assertTrue((self.folder / "read.json").exists(), run.stdout)
        scene = json.loads((self.folder / "read.json").read_text())
        (self.folder / "read.json").unlink()
        names = {}

        def visit(node):
            names.update((mesh, node["name"]) for mesh in node.get("meshes", []))
            for child in node.get("children", []):
                visit(child)

        visit(scene["rootnode"])
        materials = [{entry["key"]: entry["value"] for entry in material["properties"]}.get("?mat.name", "")
                     for material in scene["materials"]]
        parts = []
        for i, mesh in enumerate(scene["meshes"]):
            points = list(map(rounded, zip(*[iter(mesh["vertices"])] * 3)))
            uvs = list(zip(*[iter(mesh["texturecoords"][0])] * 2))
            parts.append((names[i], materials[mesh["materialindex"]],
                          [[points[v] for v in face] for face in mesh["faces"]],
                          [[uvs[v] for v in face] for face in mesh["faces"]]))
        return parts

    @unittest.skipUnless(shutil.which("assimp"), "assimp is missing (Debian's assimp-utils)")
    def test_assimp(self):
        self.write_all(MIXED)
        expected = {part: sorted(rotated([rounded(MIXED[0][v]) for v in MIXED[1][f]]) for f in faces)
                    for part, faces in PARTS.items()}
        obj = self.read("out.obj")
        self.assertEqual({(group, material): sorted(map(rotated, polygons)) for group, material, polygons, _ in obj},
                         expected)
        ply = self.read("out.ply")
        self.assertEqual(sorted(rotated(polygon) for _, _, polygons, _ in ply for polygon in polygons),
                         sorted(polygon for polygons in expected.values() for polygon in polygons))

        # Triangles of each polygon, with the same texture coordinates.
        glb = self.read("out.glb")
        self.assertEqual(sorted(part[:2] for part in glb), sorted(PARTS))
        for (_, _, polygons, uvs), (_, _, triangles, other_uvs) in zip(sorted(obj), sorted(glb)):
            corners = {}
            for polygon, polygon_uvs in zip(polygons, uvs):
                for point, uv in zip(polygon, polygon_uvs):
                    corners.setdefault(point, []).append(uv)
            self.assertEqual(len(triangles), sum(len(polygon) - 2 for polygon in polygons))
            for triangle, triangle_uvs in zip(triangles, other_uvs):
                self.assertTrue(any(set(triangle) <= set(polygon) for polygon in polygons))
                for point, uv in zip(triangle, triangle_uvs):
                    self.assertLess(min(abs(uv[0] - x) + abs(uv[1] - y) for x, y in corners[point]), 1e-4)

    @unittest.skipUnless(has_validator(), "gltf-validator is missing (scripts/install_dependencies.sh validator)")
    def test_validator(self):
        for options in ((), ("--texture", "check.png"), ("--uv-scale", "surface"), ("--lightmap", "256"),
                        ("--lightmap", "256", "--texture", "check.png")):
            self.write_all(MIXED, *options)
            self.validate("out.glb")
        self.report("in.obj", "-o", "out.glb", "--tangents")
        self.validate("out.glb")
        self.write("plain.off", to_off(sphere(1)))
        self.report("plain.off", "-o", "out.glb")
        self.validate("out.glb")
        self.report("out.glb", "-o", "again.glb")
        self.validate("again.glb")

    @unittest.skipUnless(has_validator() or shutil.which("assimp"), "the other readers are missing")
    def test_edited(self):
        """What was valid stays so, and is read by assimp, whose attributes have to be in order."""
        for name, content in (("full.glb", full().glb()), ("full.gltf", full().gltf())):
            self.write(name, content)
            for out, *options in (("edited.glb",), ("edited.gltf",), ("edited.glb", "--tangents"), ("edited.glb", "--uv-set", "1"),
                                  ("edited.gltf", "--uv-set", "4"), ("edited.glb", "--lightmap", "256", "--texture", "check.png")):
                self.report(name, "-o", out, *options)
                if has_validator():
                    self.validate(name)
                    self.validate(out)
                if shutil.which("assimp"):
                    run = subprocess.run(["assimp", "info", out], cwd=self.folder, capture_output=True, text=True, check=False)
                    self.assertIn("Animations:         1", run.stdout)

    def validate(self, name):
        run = subprocess.run(["node", "-e", VALIDATE, name], cwd=self.folder, capture_output=True, check=True)
        issues = json.loads(run.stdout)
        self.assertEqual((issues["numErrors"], issues["numWarnings"]), (0, 0), issues["messages"])


main()
