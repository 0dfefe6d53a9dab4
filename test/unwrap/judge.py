"""What the documentation of unwrap promises about the files that a run leaves, as checks that raise a `Fault`."""

import base64
import json
import os
import stat
import struct
from fractions import Fraction
from pathlib import Path

from support import KEYS, STATUS


class Fault(Exception):
    """A promise that was not kept."""


def require(condition, message):
    if not condition:
        raise Fault(message)


def snapshot(folder):
    """Type with permissions, and content, of all below the folder."""
    entries = {}
    for parent, folders, files in os.walk(folder):
        for name in folders + files:
            path = Path(parent, name)
            status = path.lstat()
            content = (os.readlink(path) if stat.S_ISLNK(status.st_mode) else
                       path.read_bytes() if stat.S_ISREG(status.st_mode) else None)
            entries[str(path)] = (status.st_mode, content)
    return entries


def changes(before, after):
    return {path for path in before.keys() | after.keys() if before.get(path) != after.get(path)}


def check_no_temporary_file(entries):
    left = [path for path in entries if ".unwrap_" in path]
    require(not left, f"left behind: {left}")


def is_counterclockwise(a, b, c):
    """Exact."""
    left, right = (b[0] - a[0]) * (c[1] - a[1]), (b[1] - a[1]) * (c[0] - a[0])
    if abs(left - right) > 1e-14 * (abs(left) + abs(right)):
        return left > right
    a, b, c = ([Fraction(x) for x in p] for p in (a, b, c))
    return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])


def check_obj(data, number_of_vertices=None, number_of_faces=None):
    """A complete mesh with a map without flips."""
    require(data.endswith(b"\n"), "the OBJ file is cut off")
    points, uvs, faces = 0, [], 0
    for line in data.decode().splitlines():
        words = line.split()
        if words[0] == "v":
            points += 1
        elif words[0] == "vt":
            uvs.append((float(words[1]), float(words[2])))
        elif words[0] == "f":
            corners = [tuple(int(i) - 1 for i in word.split("/")[:2]) for word in words[1:]]
            require(len(corners) >= 3 and all(v < points for v, _ in corners), f"bad face: {line}")
            corner_uvs = [uvs[uv] for _, uv in corners]
            is_triangle = len({v for v, _ in corners}) == len(corners) == 3  # others are checked by the program alone
            require(not is_triangle or is_counterclockwise(*corner_uvs), f"flipped: {line}")
            faces += 1
    require(faces > 0, "the OBJ file has no faces")
    require(number_of_vertices in (None, points), f"{points} vertices instead of {number_of_vertices}")
    require(number_of_faces in (None, faces), f"{faces} faces instead of {number_of_faces}")


def check_ply(data):
    """All lines that the header announces, where the file is text."""
    header, _, body = data.partition(b"end_header\n")
    require(header.startswith(b"ply\n") and body, "the PLY file has no values")
    require(b"texcoord" in header, "the PLY file has no texture coordinates")
    if b"format ascii" in header:
        count = sum(int(line.split()[2]) for line in header.splitlines() if line.startswith(b"element"))
        require(data.endswith(b"\n") and body.count(b"\n") == count, "the PLY file is cut off")


def check_glb(data):
    require(len(data) == struct.unpack_from("<I", data, 8)[0], "the glTF file is cut off")
    size = struct.unpack_from("<I", data, 12)[0]
    description = json.loads(data[20:20 + size])
    require(description["buffers"][0]["byteLength"] <= len(data) - 28 - size, "the buffer is cut off")


def check_gltf(data):
    buffer, = json.loads(data)["buffers"]
    content = base64.b64decode(buffer["uri"].partition(",")[2])
    require(len(content) == buffer["byteLength"], "the buffer is cut off")


def check_mesh(data):
    (check_glb if data.startswith(b"glTF") else check_ply if data.startswith(b"ply") else
     check_gltf if data.startswith(b"{") else check_obj)(data)


def check_report(data, exit_code):
    report = json.loads(data)
    require(list(report) == KEYS, "the report has other keys")
    require(report["status"] == STATUS[exit_code], f"status {report['status']} with exit code {exit_code}")
    require(exit_code not in (0, 7) or report["flips"] == 0, "the report tells of flips")
    return report


def check_cut(data):
    last_line = data.rpartition(b"\n")[0].rpartition(b"\n")[2]
    is_whole = data.endswith(b"\n") and last_line.startswith((b"l ", b"p "))
    require(is_whole or not data, "the cut is cut off")  # a disk needs none


# By option, what its file has to be like.
CHECKS = {
    "--output": check_mesh,
    "--svg": lambda data: require(data.startswith(b"<svg") and data.endswith(b"</svg>\n"), "no whole picture"),
    "--html": lambda data: require(data.startswith(b"<!doctype html>") and data.endswith(b"</html>\n"), "no whole page"),
    "--texture": lambda data: require(data.startswith(b"\x89PNG") and b"IEND" in data[-12:], "no whole texture"),
    "--obj-cut": check_cut,
    "material": lambda data: require(b"map_Kd" in data and data.endswith(b"\n"), "no whole material"),
}
