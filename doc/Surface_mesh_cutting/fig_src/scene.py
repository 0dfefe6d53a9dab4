"""Draws surfaces and layouts side by side with POV-Ray.

A panel draws into a cell of the picture; coordinates are in pixels.
"""

import math
import subprocess

from mesh_files import fan

# from no distortion to much (after magma of matplotlib)
DISTORTION_COLORS = [(252, 253, 191), (254, 196, 136), (252, 137, 97), (231, 82, 99), (183, 55, 121),
                     (131, 38, 129), (81, 18, 124), (29, 17, 71)]
LARGEST_STRETCH = 2
SHADES = 64
RED, BLUE, YELLOW, GREEN, BLACK = (205, 20, 30), (25, 70, 200), (250, 190, 30), (20, 130, 60), (0, 0, 0)

LIT = "finish { ambient 0.2 diffuse 0.68 specular 0.1 roughness 0.05 }"
UNLIT = "finish { ambient 1 diffuse 0 }"


class Cell:
    def __init__(self, left, bottom, width, height, margin=0.04):
        self.center = left + width / 2, bottom + height / 2
        self.size = width * (1 - margin), height * (1 - margin)

    def place(self, points):
        """the map that makes these points fill the cell"""
        low, high = ([f(c) for c in zip(*points)] for f in (min, max))
        scale = min(size / max(h - l, 1e-30) for size, l, h in zip(self.size, low, high))
        shift = [c - scale * (l + h) / 2 for c, l, h in zip(self.center, low, high)] + [0]
        return scale, lambda p: tuple(scale * x + s for x, s in zip(p, shift))


def draw_surface(surface, cell, axes, checker=False, cut=True, points=True, lines=(), marks=(),
                 line=1.6, dot=4.5):
    """`axes`: what points to the right and up in the picture; `lines` and `marks` are pairs of a
    color and what has it"""
    turn = _rotation(axes)
    scale, place = cell.place([turn(p) for p in surface.points])
    at = lambda p: _vector(_flip(place(turn(p))))
    yield "mesh2 {"
    yield _list("vertex_vectors", map(at, surface.points))
    yield _list("normal_vectors", (_vector(_flip(turn(n))) for n in surface.corner_normals()))
    if checker:
        yield _list("uv_vectors", (f"<{u * scale:.4f},{v * scale:.4f}>" for u, v in surface.uvs))
    yield _list("face_indices", map(_vector, surface.faces))
    yield _list("normal_indices", (f"<{i},{i + 1},{i + 2}>" for i in range(0, 3 * len(surface.faces), 3)))
    if checker:
        yield _list("uv_indices", map(_vector, surface.uv_faces))
        yield f"uv_mapping pigment {{ {_checker()} }} {LIT} }}"
    else:
        yield f"pigment {{ {_color((214, 214, 208))} }} {LIT} }}"
    if cut:
        lines = [(RED, surface.cut), *lines]
    if points:
        marks = [(BLUE, surface.features), (YELLOW, surface.branch_points()), *marks]
    for i, (color, segments) in enumerate(lines):
        for a, b in segments:
            yield _segment(at(a), at(b), line + 0.5 * i, color, LIT)
    for color, centers in marks:
        for center in centers:
            yield f"sphere {{ {at(center)}, {dot} pigment {{ {_color(color)} }} {LIT} }}"


def draw_faces(surface, cell, axes, faces, color):
    """some of its faces, thicker than the surface"""
    turn = _rotation(axes)
    _, place = cell.place([turn(p) for p in surface.points])
    for face in faces:
        yield from (f"triangle {{ {', '.join(_vector(_flip(place(turn(surface.points[v])))) for v in corners)} "
                    f"pigment {{ {_color(color)} }} {LIT} translate <0, 0, -0.5> }}"
                    for corners in fan(face))


def draw_layout(surface, cell, line=0.7):
    """colored by distortion"""
    angle = _best_angle(surface.uvs, cell)
    turn = lambda p: (p[0] * math.cos(angle) - p[1] * math.sin(angle),
                      p[0] * math.sin(angle) + p[1] * math.cos(angle), 0)
    _, place = cell.place([turn(p) for p in surface.uvs])
    yield from _draw_uvs(surface, lambda p: place(turn(p)), line)


def draw_pages(surface, cell, number, side, line=0.7):
    """a layout on so many squares in a row, colored by distortion; `side`: that of a square"""
    _, place = cell.place([(0, 0, 0), (number * side, side, 0)])
    yield from _draw_uvs(surface, lambda p: place((*p, 0)), line)
    for page in range(number):
        corners = [_vector(place(((page + x) * side, y * side, 0))) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            yield _segment(a, b, line, (130, 130, 130), UNLIT)


def _draw_uvs(surface, place, line):
    # What is on top where the layout overlaps itself, the same for neighbors.
    depths = surface.layout_distances()
    yield "mesh2 {"
    yield _list("vertex_vectors", (_vector((*place(p)[:2], 5. + d)) for p, d in zip(surface.uvs, depths)))
    yield _list("texture_list", (f"texture {{ pigment {{ {_color(_shade(i))} }} {UNLIT} }}" for i in range(SHADES)))
    indices = (min(SHADES - 1, int(SHADES * math.log(s) / math.log(LARGEST_STRETCH)))
               for s in surface.stretches())
    yield _list("face_indices", (f"{_vector(f)},{i}" for f, i in zip(surface.uv_faces, indices)))
    yield "}"
    for a, b in surface.layout_borders():
        yield _segment(_vector(place(a)), _vector(place(b)), line, BLACK, UNLIT)


def render(file, width, height, objects):
    """a picture that holds the objects"""
    scene = file.with_suffix(".pov")
    with open(scene, "w") as out:
        out.write(f"""#version 3.7;
global_settings {{ assumed_gamma 1 }}
background {{ srgb <1, 1, 1> }}
camera {{ orthographic location <{width / 2}, {height / 2}, -10000> look_at <{width / 2}, {height / 2}, 0>
         right <{width}, 0, 0> up <0, {height}, 0> }}
light_source {{ <-6000, 8000, -7000> srgb <1, 1, 1> parallel point_at 0 shadowless }}
light_source {{ <8000, 1000, -6000> srgb <0.3, 0.3, 0.3> parallel point_at 0 shadowless }}
""")
        for line in objects:
            out.write(line + "\n")
    command = ["povray", f"+I{scene}", f"+O{file}", f"+W{width}", f"+H{height}", "+FN", "Bits_Per_Color=6",
               "+A0.2", "+AM2", "+R3", "-D", "-GA", "+WT1", "File_Gamma=srgb"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    scene.unlink()


def _rotation(axes):
    """a rotation by the axes of the picture, and the direction to the viewer"""
    right, up = axes
    length = math.sqrt(sum(x * x for x in right))
    right = tuple(x / length for x in right)
    slope = sum(x * y for x, y in zip(right, up))
    up = tuple(y - slope * x for x, y in zip(right, up))
    length = math.sqrt(sum(x * x for x in up))
    up = tuple(x / length for x in up)
    front = tuple(right[(i + 1) % 3] * up[(i + 2) % 3] - right[(i + 2) % 3] * up[(i + 1) % 3] for i in range(3))
    return lambda p: tuple(sum(x * y for x, y in zip(axis, p)) for axis in (right, up, front))


def _best_angle(uvs, cell):
    """the rotation at which the layout is largest in the cell"""
    step = max(1, len(uvs) // 2000)
    sample = [complex(*p) for p in uvs[::step]]

    def size(angle):
        turned = [p * complex(math.cos(angle), math.sin(angle)) for p in sample]
        extent = [max(c) - min(c) for c in ([p.real for p in turned], [p.imag for p in turned])]
        return min(s / e for s, e in zip(cell.size, extent))
    return max((math.pi * i / 90 for i in range(90)), key=size)


def _shade(i):
    position = i / SHADES * (len(DISTORTION_COLORS) - 1)
    k = int(position)
    return tuple(a + (position - k) * (b - a) for a, b in zip(DISTORTION_COLORS[k], DISTORTION_COLORS[k + 1]))


def _checker():
    return f"checker {_color((245, 245, 240))}, {_color((90, 130, 175))} scale 12"


def _color(color):
    return "srgb <{:.3f},{:.3f},{:.3f}>".format(*(c / 255 for c in color))


def _segment(a, b, radius, color, finish):
    texture = f"pigment {{ {_color(color)} }} {finish}"
    ends = "".join(f"sphere {{ {p}, {radius} {texture} }}" for p in (a, b))
    return ends if a == b else f"cylinder {{ {a}, {b}, {radius} {texture} }}{ends}"


def _flip(p):
    return p[0], p[1], -p[2]  # the axes of POV-Ray are left-handed


def _vector(p):
    return "<" + ",".join(f"{x:.4f}" if isinstance(x, float) else str(x) for x in p) + ">"


def _list(name, items):
    items = list(items)
    return f"{name} {{ {len(items)},\n" + ",\n".join(items) + " }"
