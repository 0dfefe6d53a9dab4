"""glTF files made and read by what the format says, without any library."""

import base64
import json
import struct
import zlib

from support import sphere

CODES = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def png():
    """A white pixel."""
    chunks = (b"IHDR", struct.pack(">2I5B", 1, 1, 8, 0, 0, 0, 0)), (b"IDAT", zlib.compress(b"\0\xff")), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
                                         for kind, data in chunks)


IMAGE = png()


class Builder:
    """A description, and a buffer to which data are added."""

    def __init__(self, **description):
        self.buffer = b""
        self.description = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], **description}

    def view(self, data, **keys):
        self.buffer += b"\0" * (-len(self.buffer) % 4)
        self.description["bufferViews"].append({"buffer": 0, "byteOffset": len(self.buffer), "byteLength": len(data), **keys})
        self.buffer += data
        return len(self.description["bufferViews"]) - 1

    def accessor(self, values, kind, component_type=5126, **keys):
        """One element after the other; their strides are multiples of four, unless they are indices."""
        code, number = CODES[component_type], NUMBERS[kind]
        size = struct.calcsize(f"<{number}{code}")
        pad = b"" if kind == "SCALAR" and component_type != 5126 else b"\0" * (-size % 4)
        rows = [value if isinstance(value, (tuple, list)) else (value,) for value in values]
        view = self.view(b"".join(struct.pack(f"<{number}{code}", *row) + pad for row in rows),
                         **({"byteStride": size + len(pad)} if pad else {}))
        accessor = {"bufferView": view, "componentType": component_type, "count": len(rows), "type": kind, **keys}
        self.description["accessors"].append(accessor)
        return len(self.description["accessors"]) - 1

    def positions(self, points, component_type=5126, **keys):
        return self.accessor(points, "VEC3", component_type, min=[min(p[i] for p in points) for i in range(3)],
                             max=[max(p[i] for p in points) for i in range(3)], **keys)

    def glb(self):
        return glb(self.description | {"buffers": [{"byteLength": len(self.buffer)}]}, self.buffer)

    def gltf(self, uri=None):
        """As text, with the buffer inside or elsewhere."""
        uri = uri or "data:application/octet-stream;base64," + base64.b64encode(self.buffer).decode()
        return json.dumps(self.description | {"buffers": [{"byteLength": len(self.buffer), "uri": uri}]})


def full():
    """A character with all that the format knows."""
    points, triangles = sphere(1)
    count, corners = len(points), [v for triangle in triangles for v in triangle]
    file = Builder()
    attributes = {
        "POSITION": file.positions(points),
        "NORMAL": file.accessor([(0, 0, 1)] * count, "VEC3"),
        "TANGENT": file.accessor([(1, 0, 0, 1)] * count, "VEC4"),
        "TEXCOORD_0": file.accessor([p[:2] for p in points], "VEC2", name="old"),
        "TEXCOORD_1": file.accessor([p[1:] for p in points], "VEC2"),
        "COLOR_0": file.accessor([(i, 255 - i, 7, 100 + i) for i in range(count)], "VEC4", 5121, normalized=True),
        "JOINTS_0": file.accessor([(0, 1, 0, 0)] * count, "VEC4", 5121),
        "WEIGHTS_0": file.accessor([(i % 8 / 8, 1 - i % 8 / 8, 0, 0) for i in range(count)], "VEC4"),
        "_WEAR": file.accessor([i * i for i in range(count)], "SCALAR"),
        "_BYTES": file.accessor([(i, 1, 2) for i in range(count)], "VEC3", 5121)}
    targets = [{"POSITION": file.positions([(i / 100 + t, 0, 0) for i in range(count)]),
                "NORMAL": file.accessor([(0, i / 100, t) for i in range(count)], "VEC3")} for t in range(2)]
    indices = file.accessor(corners, "SCALAR", 5121)
    identity = [1.0 if i % 5 == 0 else 0.0 for i in range(16)]
    bind = file.accessor([identity, identity], "MAT4")
    times = file.accessor([0, 1], "SCALAR", min=[0], max=[1])
    turns = file.accessor([(0, 0, 0, 1), (0, 1, 0, 0)], "VEC4")
    line = file.positions([(0, 0, 0), (1, 1, 1)])
    image = file.view(IMAGE)
    file.description |= {
        "extensionsUsed": ["KHR_materials_unlit", "ACME_thing"],
        "scene": 0, "scenes": [{"name": "stage", "nodes": [0, 3, 4]}, {"nodes": [5]}],
        "nodes": [{"name": "Hips", "children": [1], "extras": {"a": [1, 2.5, None]}},
                  {"name": "Knee", "translation": [0, 1, 0]},
                  {"name": "unused"}, {"name": "Body", "mesh": 0, "skin": 0, "weights": [0.25, 0.5]},
                  {"name": "Eye", "camera": 0, "matrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1]}, {"mesh": 1}],
        "meshes": [{"name": "Body", "weights": [0, 0], "extras": {"targetNames": ["smile", "frown"]},
                    "primitives": [{"attributes": attributes, "indices": indices, "material": 0, "targets": targets,
                                    "extensions": {"ACME_thing": {"level": "high"}}}]},
                   {"name": "Wire", "primitives": [{"attributes": {"POSITION": line}, "mode": 1}]}],
        "skins": [{"joints": [0, 1], "inverseBindMatrices": bind}],
        "animations": [{"name": "wave", "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}],
                        "samplers": [{"input": times, "output": turns}]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01}}],
        "materials": [{"name": "Skin", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                       "extensions": {"KHR_materials_unlit": {}}}],
        "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071}],
        "images": [{"name": "skin", "mimeType": "image/png", "bufferView": image}],
        "extras": {"made by": "a test \u00e4"}}
    return file


def glb(description, buffer):
    text = (description if isinstance(description, bytes) else json.dumps(description).encode())
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON")
            + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


def without_data(description):
    """What is not about accessors, views and buffers, nor about the primitives that are unwrapped."""
    result = json.loads(json.dumps({key: value for key, value in description.items()
                                    if key not in ("accessors", "bufferViews", "buffers", "asset")}))
    for image in result.get("images", []):
        image.pop("bufferView", None)
    for mesh in result.get("meshes", []):
        for primitive in mesh["primitives"]:
            if primitive.pop("mode", 4) >= 4:
                for key in ("attributes", "indices", "targets"):
                    primitive.pop(key, None)
    return result


class File:
    """A glTF file as a program wrote it, text or binary, that holds its buffer itself."""

    def __init__(self, path):
        data = path.read_bytes()
        if data[:4] == b"glTF":
            size, = struct.unpack_from("<I", data, 12)
            assert len(data) == struct.unpack_from("<I", data, 8)[0]
            self.description, self.buffer = json.loads(data[20:20 + size]), data[28 + size:]
        else:
            self.description = json.loads(data)
            self.buffer = base64.b64decode(self.description["buffers"][0]["uri"].split(",")[1])
        assert len(self.description["buffers"]) == 1
        assert self.description["buffers"][0]["byteLength"] <= len(self.buffer)

    def view(self, index):
        view = self.description["bufferViews"][index]
        assert view["byteOffset"] % 4 == 0 and view["byteOffset"] + view["byteLength"] <= len(self.buffer)
        return self.buffer[view["byteOffset"]:][:view["byteLength"]]

    def bytes_of(self, index):
        """The elements of an accessor as bytes."""
        accessor = self.description["accessors"][index]
        size = struct.calcsize(f"<{NUMBERS[accessor['type']]}{CODES[accessor['componentType']]}")
        if "bufferView" in accessor:
            data = self.view(accessor["bufferView"])[accessor.get("byteOffset", 0):]
            stride = self.description["bufferViews"][accessor["bufferView"]].get("byteStride", size)
            assert (accessor["count"] - 1) * stride + size <= len(data)
            elements = [data[i * stride:][:size] for i in range(accessor["count"])]
        else:
            elements = [bytes(size)] * accessor["count"]
        if sparse := accessor.get("sparse"):
            code = CODES[sparse["indices"]["componentType"]]
            indices = struct.unpack_from(f"<{sparse['count']}{code}", self.view(sparse["indices"]["bufferView"]))
            values = self.view(sparse["values"]["bufferView"])
            for k, i in enumerate(indices):
                elements[i] = values[k * size:][:size]
        return elements

    def numbers_of(self, index):
        """The elements as tuples, as they are stored."""
        accessor = self.description["accessors"][index]
        form = f"<{NUMBERS[accessor['type']]}{CODES[accessor['componentType']]}"
        return [struct.unpack(form, element) for element in self.bytes_of(index)]

    def other_bytes(self):
        """Those of skins, animations and images, which no mesh refers to."""
        samplers = [sampler for animation in self.description["animations"] for sampler in animation["samplers"]]
        accessors = [skin["inverseBindMatrices"] for skin in self.description["skins"]]
        accessors += [sampler[key] for sampler in samplers for key in ("input", "output")]
        return [self.bytes_of(i) for i in accessors] + [self.view(image["bufferView"]) for image in self.description["images"]]

    def primitives(self):
        return [primitive for mesh in self.description["meshes"] for primitive in mesh["primitives"]]

    def corners(self, primitive):
        """The vertices of the corners of its triangles."""
        count = self.description["accessors"][primitive["attributes"]["POSITION"]]["count"]
        vertices = ([i for (i,) in self.numbers_of(primitive["indices"])] if "indices" in primitive else list(range(count)))
        mode = primitive.get("mode", 4)
        if mode == 5:
            return [v for i in range(len(vertices) - 2)
                    for v in (vertices[i], vertices[i + 1 + i % 2], vertices[i + 2 - i % 2])]
        if mode == 6:
            return [v for i in range(1, len(vertices) - 1) for v in (vertices[0], vertices[i], vertices[i + 1])]
        return vertices

    def corner_bytes(self, primitive, besides=("TEXCOORD_0",)):
        """Per triangle, from any corner on, or per corner of what has no triangles: the bytes of all attributes, also of morph
        targets."""
        objects = [("", primitive["attributes"])] + [(f"target {i} ", target)
                                                     for i, target in enumerate(primitive.get("targets", []))]
        attributes = sorted((prefix + name, self.bytes_of(accessor)) for prefix, attributes in objects
                            for name, accessor in attributes.items() if prefix or name not in besides)
        corners = [tuple((name, elements[v]) for name, elements in attributes) for v in self.corners(primitive)]
        if primitive.get("mode", 4) < 4:
            return corners
        triangles = [corners[i:i + 3] for i in range(0, len(corners), 3)]
        return [min(t, t[1:] + t[:1], t[2:] + t[:2]) for t in triangles]
