"""A small picture of a layout: the outlines of its charts, from an OBJ file with texture coordinates."""

import math


def read_layout(file):
    """The texture coordinates, and the corners of each face as indices into them."""
    uvs, faces = [], []
    with open(file, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["vt"]:
                uvs.append((float(words[1]), float(words[2])))
            elif words[:1] == ["f"]:
                faces.append([int(word.split("/")[1]) - 1 for word in words[1:]])
    return uvs, faces


def outlines(faces):
    """The border loops of the charts."""
    sides = {(face[i - 1], face[i]) for face in faces for i in range(len(face))}
    after = {s: t for s, t in sorted(sides) if (t, s) not in sides}
    while after:
        start, v = after.popitem()
        loop = [start]
        while v != start and v in after:
            loop.append(v)
            v = after.pop(v)
        yield loop


def thumbnail(file, size=120):
    """An SVG picture of `size` by `size` points."""
    uvs, faces = read_layout(file)
    loops = list(outlines(faces))
    used = [uvs[v] for loop in loops for v in loop] or [(0., 0.)]
    low = [min(uv[axis] for uv in used) for axis in (0, 1)]
    extent = max(max(uv[axis] for uv in used) - low[axis] for axis in (0, 1)) or 1.
    if not math.isfinite(extent):
        loops = []

    def place(v):
        return f"{(uvs[v][0] - low[0]) / extent * size:.1f} {size - (uvs[v][1] - low[1]) / extent * size:.1f}"

    path = " ".join("M" + "L".join(map(place, loop)) + "Z" for loop in loops)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-2 -2 {size + 4} {size + 4}" '
            f'width="{size}" height="{size}"><path d="{path}" fill="#cfe3f7" fill-rule="evenodd" '
            'stroke="#1f4e79" stroke-width="0.7"/></svg>\n')
