"""glTF files made and read by what the format says, without any library."""

import base64
import json
import struct

CODES = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


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


def glb(description, buffer):
    text = (description if isinstance(description, bytes) else json.dumps(description).encode())
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(buffer)) + struct.pack("<I4s", len(text), b"JSON")
            + text + struct.pack("<I4s", len(buffer), b"BIN\0") + buffer)


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
