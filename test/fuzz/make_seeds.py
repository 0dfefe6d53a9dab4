"""Writes the inputs that a fuzzer begins with: make_seeds.py mesh|formats|steiner|arguments MESH_FOLDER FOLDER"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "unwrap"))
from support import (colored_off, decorated_obj, decorated_ply, joined, octahedron, sphere, to_binary_stl, to_glb, to_obj,
                     to_off, to_ply, to_text_stl, torus, without_face)

MESHES = [octahedron(), sphere(1), torus(4), without_face(sphere(1)), joined(octahedron(), torus(3))]
SMALL_FILES = ["cross", "patch-23", "star", "tripod", "u"]
FORMATS = [(0, to_off), (1, to_obj), (2, lambda mesh: to_ply(mesh, "ascii")),
           (2, lambda mesh: to_ply(mesh, "binary_little_endian")), (3, to_text_stl), (3, to_binary_stl)]
COMMAND_LINES = ["mesh.off -o a.obj --json - --svg a.svg --texture a.png --obj-cut c.obj --quiet",
                 "mesh.off --effort fast --connect exact --bijective --max-distortion 4.1 --seed 7 --threads 2",
                 "mesh.off --eps-iso 0.1 --eps-len 1e-2 --alpha .5 --beta 20 --solver eigen --time-limit 3",
                 "mesh.off --faithful --must-cut a.txt --never-cut b.txt --terminals c.txt --edge-weights crease",
                 "mesh.off --initial-cut uv --edge-weights sky:-x --edge-weights paint:p.txt --edge-weights straight"]
ALL_ATTRIBUTES = 32 + 64
NUMBER_OF_FORMATS = 5  # as fuzz_mesh.cpp counts them


def as_bytes(content):
    return content if isinstance(content, bytes) else content.encode()


def polygon_seeds():
    quads = [tuple(one) + (two[2],) for one, two in zip(torus(4)[1][::2], torus(4)[1][1::2])]
    for reading in range(3):  # how vertices are welded
        for number, to_format in FORMATS[:4]:
            yield bytes([number + NUMBER_OF_FORMATS * reading, 1]) + as_bytes(to_format((torus(4)[0], quads)))
    points, faces = sphere(1)
    soup = [points[v] for face in faces for v in face], [(i, i + 1, i + 2) for i in range(0, 3 * len(faces), 3)]
    yield bytes([0, 1]) + to_off(soup).encode()
    yield bytes([4, 1]) + to_glb(*octahedron())


def mesh_seeds(mesh_folder):
    yield from polygon_seeds()
    for i, mesh in enumerate(MESHES):
        for j, (number, to_format) in enumerate(FORMATS):
            yield bytes([number, (0, 1, 6, 8, 17)[(i + j) % 5]]) + as_bytes(to_format(mesh))
    for number, mesh in ((0, colored_off(sphere(1))), (1, decorated_obj(sphere(1))), (2, decorated_ply(sphere(1)))):
        yield bytes([number, ALL_ATTRIBUTES if number > 0 else 64]) + mesh.encode()
    for i, name in enumerate(SMALL_FILES):
        file = mesh_folder / f"{name}.off"
        if file.exists():
            yield bytes([0, i]) + file.read_bytes()


def format_seeds(mesh_folder):
    for seed in mesh_seeds(mesh_folder):
        yield bytes([seed[0] % NUMBER_OF_FORMATS]) + seed[2:]


def grid_graph(n, terminals):
    name = lambda i, j: n * i + j + 1
    edges = [(name(i, j), name(i + 1, j), 1 + (i * j) % 5) for i in range(n - 1) for j in range(n)]
    edges += [(name(i, j), name(i, j + 1), 1 + (i + j) % 3) for i in range(n) for j in range(n - 1)]
    lines = ["SECTION Graph", f"Nodes {n * n}", f"Edges {len(edges)}", *(f"E {a} {b} {w}" for a, b, w in edges), "END",
             "SECTION Terminals", f"Terminals {len(terminals)}", *(f"T {t}" for t in terminals), "END", "EOF"]
    return "\n".join(lines).encode() + b"\n"


def steiner_seeds(_):
    for n in (2, 4, 7):
        yield grid_graph(n, [1, n, n * n])
        yield grid_graph(n, range(1, n * n + 1, 3))


def argument_seeds(_):
    for line in COMMAND_LINES:
        yield b"\0" + line.replace(" ", "\n").encode()
    yield b"\x01" + b"1 2 3\n\n4 5 6 7\n"
    yield b"\x02" + b"1 2 0.5\n3 4 inf\n"
    yield b"\x03" + b"1 0.5\n3 2\n"
    yield b"\x03" + b"0.5\n2\n0\n"


def main():
    target, mesh_folder, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    seeds = {"mesh": mesh_seeds, "formats": format_seeds, "steiner": steiner_seeds, "arguments": argument_seeds}[target]
    for i, seed in enumerate(seeds(mesh_folder)):
        (folder / f"seed_{i:02}").write_bytes(seed)


main()
