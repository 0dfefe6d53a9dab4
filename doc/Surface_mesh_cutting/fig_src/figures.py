"""Makes the figures of the user manual; run by scripts/figures.sh.

usage: figures.py PROGRAMS MESHES WORK_FOLDER OUTPUT_FOLDER [FIGURE...]
"""

import json
import subprocess
import sys
from pathlib import Path

import soups
from mesh_files import Surface, read_off, write_selection
from scene import BLUE, GREEN, RED, YELLOW, Cell, draw_faces, draw_layout, draw_pages, draw_surface, render

CAMEL = (0.45, 0, 1), (-0.1, 1, 0.045)
BONES = (1, 0.3, 0), (0, 0, 1)
COUPLING = (0, 1, 0), (-1, 0, 0.8)
COW = (1, 0, -0.45), (0.1, 1, 0.25)
DINO = (-0.3, 1, 0), (0.1, 0, 1)
ELEPHANT = (-0.5, 0, -0.87), (0, 1, 0)
HOMER = (1, 0, 0.35), (0, 1, -0.1)
HOMER_BACK = (-1, 0, -0.35), (0, 1, 0.1)
LION = (1, 0, -0.4), (0, 1, -0.1)


class Figures:
    def __init__(self, programs, meshes, work, output):
        self.programs, self.meshes, self.work, self.output = map(Path, (programs, meshes, work, output))

    def run(self, program, *arguments):
        subprocess.run([self.programs / program, *map(str, arguments)], check=True)

    def mesh(self, name):
        return self.meshes / f"{name}.off"

    def unwrap(self, name, *options, scale="surface"):
        """a surface, unwrapped with these options of the program; the layout has its size, as its colors need"""
        out, cut = self.work / "out.obj", self.work / "cut.obj"
        self.run("unwrap", self.mesh(name), "-o", out, "--obj-cut", cut, "--uv-scale", scale, "--quiet", *options)
        return Surface(out, cut)

    def introduction(self):
        surface = self.unwrap("camel")
        return 1200, 430, [
            *draw_surface(surface, Cell(0, 0, 380, 430), CAMEL),
            *draw_layout(surface, Cell(390, 0, 420, 430)),
            *draw_surface(surface, Cell(820, 0, 380, 430), CAMEL, checker=True)]

    def overview(self):
        """the small picture of the overview of all packages"""
        return 220, 220, draw_surface(self.unwrap("camel"), Cell(0, 0, 220, 220), CAMEL, line=1.1, dot=2.6)

    def method(self):
        self.run("candidates", self.mesh("cow"), self.work / "cow")
        surface = self.unwrap("cow")
        objects = []
        for i, name in enumerate(("first", "second")):
            found = Surface(self.work / "out.obj", self.work / f"cow.{name}.obj")
            objects += draw_surface(found, Cell(600 * i, 350, 600, 350), COW, points=False,
                                    marks=[(BLUE, found.features)])
        objects += draw_surface(surface, Cell(0, 0, 600, 350), COW, cut=False, points=False,
                                marks=[(BLUE, surface.features)])
        objects += draw_surface(surface, Cell(600, 0, 600, 350), COW)
        return 1200, 700, objects

    def distortion_bound(self):
        objects = []
        for i, bound in enumerate(("4.4", "4.15", "4.05")):
            surface = self.unwrap("cow", "--max-distortion", bound)
            objects += draw_surface(surface, Cell(360 * i, 260, 360, 225), COW, line=1.4, dot=3.2)
            objects += draw_layout(surface, Cell(360 * i, 0, 360, 260))
        return 1080, 485, objects

    def face_bound(self):
        """the same number as a bound on the mean and on each face, and sharp edges that are cut"""
        objects = []
        for i, (name, axes, options) in enumerate((("cow", COW, ["--max-distortion", "6"]),
                                                   ("cow", COW, ["--max-face-distortion", "6"]),
                                                   ("couplingdown", COUPLING, ["--must-cut", "angle:60"]))):
            surface = self.unwrap(name, "--effort", "fast", *options)
            objects += draw_surface(surface, Cell(360 * i, 260, 360, 225), axes, line=1.4, points=False)
            objects += draw_layout(surface, Cell(360 * i, 0, 360, 260))
        return 1080, 485, objects

    def atlas(self):
        density, texels = 79, 512  # per unit of length, along a page
        surface = self.unwrap("bones", "--effort", "fast", "--texels-per-unit", density, "--texture-size", texels, "--udim",
                              scale="unit")
        surface.uvs = [(u * texels / density, v * texels / density) for u, v in surface.uvs]
        pages = 1 + max(int(u * density / texels) for u, _ in surface.uvs)
        return 1200, 250, [*draw_surface(surface, Cell(0, 0, 200, 250), BONES, line=1, points=False),
                           *draw_pages(surface, Cell(200, 0, 1000, 250), pages, texels / density)]

    def symmetry(self):
        objects = []
        for i, symmetry in enumerate(("off", "auto")):
            surface = self.unwrap("couplingdown", "--symmetry", symmetry)
            objects += draw_surface(surface, Cell(600 * i, 0, 300, 300), COUPLING, points=False)
            objects += draw_layout(surface, Cell(600 * i + 300, 0, 300, 300))
        return 1200, 300, objects

    def symmetric_layout(self):
        """a chart that is symmetric, as it comes and upright"""
        objects = []
        for i, turn in enumerate(("any", "upright")):
            report = self.work / "symmetry.json"
            surface = self.unwrap("couplingdown", "--symmetry", "auto", "--rotate", turn, "--json", report, scale="unit")
            side = 1 / json.loads(report.read_text())["uv_scale"]
            surface.uvs = [(u * side, v * side) for u, v in surface.uvs]
            if i == 0:
                objects += draw_surface(surface, Cell(0, 0, 300, 300), COUPLING, points=False)
            objects += draw_pages(surface, Cell(300 * (i + 1), 0, 300, 300), 1, side)
        return 900, 300, objects

    def straight_seams(self):
        objects = []
        for i, smoothness in enumerate(("0", "1")):
            surface = self.unwrap("camel", "--seam-smoothness", smoothness)
            objects += draw_surface(surface, Cell(500 * i, 0, 500, 480), CAMEL, points=False)
        return 1000, 480, objects

    def connection(self):
        objects = []
        for i, method in enumerate(("mst", "greedy", "best")):
            surface = self.unwrap("dino", "--effort", "fast", "--connect", method)
            objects += draw_surface(surface, Cell(400 * i, 0, 400, 420), DINO)
        return 1200, 420, objects

    def constraints(self):
        points, faces = read_off(self.mesh("homer"))
        low, high = (f(p[1] for p in points) for f in (min, max))
        height = lambda v: (points[v][1] - low) / (high - low)
        edges = {(min(a, b), max(a, b)) for f in faces for a, b in zip(f, f[1:] + f[:1])}
        is_above = lambda f: sum(map(height, f)) > 3 * 0.46
        sides = {}
        for f in faces:
            for a, b in zip(f, f[1:] + f[:1]):
                sides.setdefault((min(a, b), max(a, b)), set()).add(is_above(f))
        belt, face = self.work / "belt.selection.txt", self.work / "face.selection.txt"
        write_selection(belt, sorted(e for e in edges if len(sides[e]) == 2))
        write_selection(face, sorted(e for e in edges if all(height(v) > 0.55 and points[v][2] > 0 for v in e)))
        objects = []
        for i, options in enumerate(([], ["--never-cut", face, "--edge-weights", "visibility"],
                                     ["--must-cut", belt])):
            surface = self.unwrap("homer", *options)
            objects += draw_surface(surface, Cell(400 * i, 0, 200, 420), HOMER)
            objects += draw_surface(surface, Cell(400 * i + 200, 0, 200, 420), HOMER_BACK)
        return 1200, 420, objects

    def weights(self):
        """front and back, without weights and with those that hide the cut from the front"""
        objects = []
        for i, options in enumerate(([], ["--edge-weights", "sky:z"])):
            surface = self.unwrap("homer", *options)
            objects += draw_surface(surface, Cell(560 * i, 0, 270, 440), HOMER)
            objects += draw_surface(surface, Cell(560 * i + 270, 0, 270, 440), HOMER_BACK)
        return 1100, 440, objects

    def topology(self):
        self.run("handle_loops", self.mesh("elephant"), self.work / "loops.obj")
        elephant, objects = self.unwrap("elephant"), []
        loops = Surface(self.work / "out.obj", self.work / "loops.obj").cut
        objects += draw_surface(elephant, Cell(0, 0, 300, 400), ELEPHANT, lines=[(GREEN, loops)])
        objects += draw_layout(elephant, Cell(310, 0, 290, 400))
        lion = self.unwrap("lion")
        objects += draw_surface(lion, Cell(620, 0, 280, 400), LION)
        objects += draw_layout(lion, Cell(910, 0, 290, 400))
        return 1200, 400, objects

    def bijective(self):
        objects = []
        for i, options in enumerate((["--allow-overlap"], [])):
            objects += draw_layout(self.unwrap("homer", "--effort", "fast", *options), Cell(390 * i, 0, 370, 370))
        return 760, 370, objects

    def interpretation(self):
        """above what is read, with what needs an interpretation, below the layout"""
        objects = []
        for i, (soup, axes) in enumerate((
                (soups.saddle(), ((1, 0.5, 0), (0, 0.4, 1))), (soups.sheets(), ((1, -0.6, 0), (0.2, 0.3, 1))),
                (soups.cones(), ((1, 0, 0), (0, 0.3, 1))), (soups.turned(), ((1, 0, 0), (0, 0.3, 1))),
                (soups.strip(), ((1, 0.3, 0), (0, 0.7, 1))), (soups.pieces(), ((-1, -0.7, 0), (0.2, -0.2, 1))))):
            file, out, cut = (self.work / f"soup{end}" for end in (".off", ".obj", ".cut.obj"))
            soups.write_off(file, soup)
            report = subprocess.run([self.programs / "unwrap", file, "-o", out, "--obj-cut", cut, "--uv-scale", "surface",
                                     "--quiet", "--json", "-"], check=True, stdout=subprocess.PIPE).stdout
            read = {entry["what"]: entry["elements"] for entry in json.loads(report)["interpreted"]}
            points, faces = soup
            ends = lambda name: [(points[a], points[b]) for a, b in read.get(name, [])]
            sides = [(points[a], points[b]) for f in faces for a, b in zip(f, (*f[1:], f[0]))]
            surface, cell = Surface(out, cut), Cell(200 * i, 170, 200, 190)
            objects += draw_surface(surface, cell, axes, cut=False, points=False, line=0.7, lines=[
                ((120, 120, 120), sides), (RED, surface.cut),
                (GREEN, ends("non_manifold_edges") + ends("non_orientable_edges"))], marks=[
                (YELLOW, [points[v] for v in read.get("non_manifold_vertices", [])])])
            objects += draw_faces(surface, cell, axes, [faces[f] for f in read.get("reoriented_faces", [])], BLUE)
            objects += draw_layout(surface, Cell(200 * i, 0, 200, 160))
        return 1200, 360, objects

    def make(self, name):
        render(self.output / f"{name}.png", *getattr(self, name)())
        print("made", self.output / f"{name}.png")


ALL = ["introduction", "overview", "method", "distortion_bound", "face_bound", "connection", "constraints", "weights",
       "topology", "bijective", "interpretation", "atlas", "symmetry", "symmetric_layout", "straight_seams"]


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    figures = Figures(*sys.argv[1:5])
    for name in sys.argv[5:] or ALL:
        figures.make(name)


if __name__ == "__main__":
    main()
