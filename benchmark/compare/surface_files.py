"""Meshes as arrays: the surfaces that all programs get, and the texture coordinates that they return."""

import pathlib

import numpy as np

PLY_TYPES = {name: kind for names, kind in (
    ("char int8", "i1"), ("uchar uint8", "u1"), ("short int16", "<i2"), ("ushort uint16", "<u2"), ("int int32", "<i4"),
    ("uint uint32", "<u4"), ("float float32", "<f4"), ("double float64", "<f8")) for name in names.split()}


class Unreadable(Exception):
    """A file that this reader does not understand."""


def index(word, count):
    """From that of OBJ, which counts from 1, or backward."""
    number = int(word)
    return number - 1 if number > 0 else count + number


def read_obj(path):
    """Points, faces, UVs, and the numbers of the UVs at the corners of the faces, -1 where there is none."""
    points, uvs, faces, uv_faces = [], [], [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for words in map(str.split, file):
            if words and words[0] == "v":
                points.append(tuple(map(float, words[1:4])))
            elif words and words[0] == "vt":
                uvs.append(tuple(map(float, words[1:3])))
            elif words and words[0] == "f":
                corners = [(word + "/").split("/")[:2] for word in words[1:]]
                faces.append([index(v, len(points)) for v, _ in corners])
                uv_faces.append([index(t, len(uvs)) if t else -1 for _, t in corners])
    return points, faces, uvs, uv_faces


def read_off(path):
    lines = [words for line in path.read_text(errors="replace").splitlines() if (words := line.split("#")[0].split())]
    lines[0] = lines[0][1:]
    lines = lines if lines[0] else lines[1:]
    vertices, faces = map(int, lines[0][:2])
    rows = lines[1:1 + vertices + faces]
    return ([tuple(map(float, words[:3])) for words in rows[:vertices]],
            [list(map(int, words[1:1 + int(words[0])])) for words in rows[vertices:]])


def read_ply(path):
    """Binary, little endian, of triangles."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    columns, counts = {}, {}
    for words in map(str.split, header.decode("ascii", "replace").splitlines()):
        if words[0] == "element":
            element, counts[words[1]], columns[words[1]] = words[1], int(words[2]), []
        elif words[0] == "property" and words[1] == "list":
            columns[element] += [("count", PLY_TYPES[words[2]]), ("corners", PLY_TYPES[words[3]], 3)]
        elif words[0] == "property":
            columns[element].append((words[2], PLY_TYPES[words[1]]))
    if b"binary_little_endian" not in header or list(counts) != ["vertex", "face"]:
        raise Unreadable("a PLY that is not binary, or has more than vertices and faces")
    vertices = np.frombuffer(body, columns["vertex"], counts["vertex"])
    faces = np.frombuffer(body, columns["face"], counts["face"], vertices.nbytes)
    if (faces["count"] != 3).any():
        raise Unreadable("a PLY with polygons")
    return np.stack([vertices[axis] for axis in "xyz"], axis=1), faces["corners"]


def triangulated(faces):
    """Polygons as fans; an array stays what it is."""
    if isinstance(faces, np.ndarray):
        return faces.astype(np.int64)
    return np.array([(face[0], face[k], face[k + 1]) for face in faces for k in range(1, len(face) - 1)], np.int64).reshape(-1, 3)


def welded(points, faces):
    """Equal points as one, and none that no face uses, in the order of their first places."""
    used = np.unique(faces)
    _, first, place = np.unique(points[used], axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.zeros(len(points), np.int64)
    number[used] = np.argsort(order)[place.ravel()]
    return points[used[first[order]]], number[faces]


def read_surface(path):
    """Points and triangles. Equal points are one; faces that repeat a vertex or another face are left out: programs differ in what
    they make of these, and are to be compared by all else."""
    path = pathlib.Path(path)
    readers = {".obj": lambda name: read_obj(name)[:2], ".off": read_off, ".ply": read_ply}
    try:
        points, faces = readers[path.suffix.lower()](path)
        points, faces = np.array(points, float).reshape(-1, 3), triangulated(faces)
    except (KeyError, ValueError, IndexError) as error:
        raise Unreadable(f"{path.name}: {error}") from error
    if len(faces) == 0 or faces.min() < 0 or faces.max() >= len(points) or not np.isfinite(points[faces]).all():
        raise Unreadable(f"{path.name}: no faces, or numbers out of range")
    points, faces = welded(points, faces)
    ordered = np.sort(faces, axis=1)
    is_kept = np.zeros(len(faces), bool)
    is_kept[np.unique(ordered, axis=0, return_index=True)[1]] = True
    return welded(points, faces[is_kept & (np.diff(ordered, axis=1) > 0).all(axis=1)])


def write_surface(path, points, faces):
    with open(path, "w", encoding="ascii") as file:
        file.writelines("v %r %r %r\n" % tuple(point) for point in points.tolist())
        file.writelines("f %d %d %d\n" % tuple(face) for face in (faces + 1).tolist())


def read_result(path, faces):
    """The UVs of the corners, m x 3 x 2, of an OBJ that must have the same faces in the same order; NaN where there are none."""
    _, found, uvs, uv_faces = read_obj(path)
    if not np.array_equal(triangulated(found), faces):
        raise Unreadable("other faces than those given")
    return np.array([*uvs, (np.nan, np.nan)])[triangulated(uv_faces)]
