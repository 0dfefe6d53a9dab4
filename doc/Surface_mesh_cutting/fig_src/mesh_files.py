"""Reads the files that the program `unwrap` writes."""

import math


class Surface:
    """A triangle mesh with texture coordinates, the marked edges and the feature points. Convex polygons become
    triangles."""

    def __init__(self, mesh_file, cut_file=None):
        self.points, self.uvs, self.faces, self.uv_faces = [], [], [], []
        for word, *rest in _lines(mesh_file):
            if word == "v":
                self.points.append(tuple(map(float, rest[:3])))
            elif word == "vt":
                self.uvs.append(tuple(map(float, rest[:2])))
            elif word == "f":
                corners = [[int(i) - 1 for i in corner.split("/")] for corner in rest]
                for triangle in fan(corners):
                    self.faces.append([corner[0] for corner in triangle])
                    self.uv_faces.append([corner[1] for corner in triangle])
        self.cut, self.features = [], []  # of points
        if cut_file:
            self._read_cut(cut_file)

    def _read_cut(self, file):
        points = []
        for word, *rest in _lines(file):
            if word == "v":
                points.append(tuple(map(float, rest)))
            elif word == "l":
                self.cut.append([points[int(i) - 1] for i in rest])
            elif word == "p":
                self.features += [points[int(i) - 1] for i in rest]

    def branch_points(self):
        """where at least three edges of the cut meet, feature points left out"""
        degrees = {}
        for edge in self.cut:
            for point in edge:
                degrees[point] = degrees.get(point, 0) + 1
        return [p for p, degree in degrees.items() if degree > 2 and p not in self.features]

    def layout_borders(self):
        """the edges of the layout that belong to one triangle only"""
        borders = {}
        for face in self.uv_faces:
            for k in range(3):
                a, b = sorted((face[k], face[(k + 1) % 3]))
                if borders.pop((a, b), None) is None:
                    borders[a, b] = (self.uvs[a], self.uvs[b])
        return list(borders.values())

    def layout_distances(self):
        """for each point of the layout the number of edges from the first point of its chart"""
        neighbors = [[] for _ in self.uvs]
        for face in self.uv_faces:
            for k in range(3):
                neighbors[face[k]] += face[k - 1], face[k - 2]
        distances = [None] * len(self.uvs)
        for start in range(len(self.uvs)):
            if distances[start] is not None:
                continue
            distances[start], queue = 0, [start]
            for v in queue:
                for w in neighbors[v]:
                    if distances[w] is None:
                        distances[w] = distances[v] + 1
                        queue.append(w)
        return distances

    def stretches(self):
        """for each face the factor s for which a map that stretches by s and 1/s is as distorted"""
        result = []
        for face, uv_face in zip(self.faces, self.uv_faces):
            p, q, r = (self.points[v] for v in face)
            a, b = _minus(q, p), _minus(r, p)
            (u0, v0), (u1, v1), (u2, v2) = (self.uvs[v] for v in uv_face)
            c, d = (u1 - u0, v1 - v0), (u2 - u0, v2 - v0)
            area = math.sqrt(_dot(a, a) * _dot(b, b) - _dot(a, b) ** 2)
            uv_area = c[0] * d[1] - c[1] * d[0]
            norm = (_dot(c, c) * _dot(b, b) - 2 * _dot(c, d) * _dot(a, b)
                    + _dot(d, d) * _dot(a, a)) / area ** 2
            energy = norm * (1 + (area / uv_area) ** 2)
            result.append(math.exp(math.acosh(max(1, energy / 4)) / 2))
        return result

    def corner_normals(self, sharp=0.6):
        """for each corner the mean normal of the faces around it that are not beyond a sharp edge"""
        normals, around = [], [[] for _ in self.points]
        for f, face in enumerate(self.faces):
            p, q, r = (self.points[v] for v in face)
            (a, b, c), (d, e, g) = _minus(q, p), _minus(r, p)
            normals.append((b * g - c * e, c * d - a * g, a * e - b * d))
            for v in face:
                around[v].append(f)
        units = [_scaled(n, 1 / (math.sqrt(_dot(n, n)) or 1)) for n in normals]
        for f, face in enumerate(self.faces):
            for v in face:
                near = [normals[g] for g in around[v] if _dot(units[f], units[g]) > sharp]
                mean = tuple(map(sum, zip(*near))) if near else (0, 0, 1)
                yield _scaled(mean, 1 / (math.sqrt(_dot(mean, mean)) or 1))


def fan(polygon):
    """the triangles of a convex polygon"""
    return [[polygon[0], *polygon[k:k + 2]] for k in range(1, len(polygon) - 1)]


def read_off(file):
    """the points and faces of a file in the OFF format without comments between the lines"""
    words = iter(" ".join(line.split("#")[0] for line in open(file)).split())
    next(words)
    vertices, faces, _ = (int(next(words)) for _ in range(3))
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(vertices)]
    return points, [[int(next(words)) for _ in range(int(next(words)))] for _ in range(faces)]


def write_selection(file, edges):
    """a selection file of CGAL with these edges, as pairs of vertices"""
    with open(file, "w") as out:
        out.write("\n\n" + " ".join(f"{a} {b}" for a, b in edges) + "\n")


def _lines(file):
    with open(file) as text:
        return [line.split() for line in text if line.split()]


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def _minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def _scaled(a, s):
    return tuple(x * s for x in a)
