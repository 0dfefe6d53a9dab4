"""All measures of a map from a surface to the plane, from the points, the triangles, and the UVs of their corners. Nothing is used
of the library that is measured."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from uv_overlaps import orientations, overlapping_pairs

QUANTILE = 0.99
LARGEST_RATIO = 10.0  # of areas, at which PartUV's measure clips
SMALLEST_SHARE = 1e-4  # of the mean area, below which it omits a face


class Invalid(Exception):
    """A result that is no map of the whole surface."""


def numbered(*columns):
    """Equal numbers for equal rows of columns of numbers from 0."""
    result = np.zeros(len(columns[0]), np.int64)
    for column in columns:
        result = np.unique(result * (int(column.max()) + 1) + column, return_inverse=True)[1]
    return result


class Sides:
    """The half-edges of all faces, three of each. Those on one edge whose UVs agree at both ends are one side of it: faces that
    share a side are connected, and an edge with n sides is cut n - 1 times."""

    def __init__(self, points, faces, uv):
        start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
        self.face = np.repeat(np.arange(len(faces)), 3)
        self.is_forward = start < end
        self.length = np.linalg.norm(points[start] - points[end], axis=1)
        self.uv_length = np.linalg.norm(uv - np.roll(uv, -1, axis=1), axis=2).ravel()
        place = numbered(*(np.unique(uv[:, :, axis] + 0.0, return_inverse=True)[1].ravel() for axis in (0, 1)))
        next_place = np.roll(place.reshape(-1, 3), -1, axis=1).ravel()
        self.edge = numbered(np.minimum(start, end), np.maximum(start, end))
        self.side = numbered(self.edge, np.where(self.is_forward, place, next_place), np.where(self.is_forward, next_place, place))

    def cut_length(self):
        _, first = np.unique(self.side, return_index=True)
        sides = np.bincount(self.edge[first])
        length = np.zeros(len(sides))
        length[self.edge] = self.length
        return float(np.sum((sides - 1) * length))

    def chart_border(self):
        """In the plane: both sides of the cut, and the borders of the surface."""
        return float(self.uv_length[np.bincount(self.side)[self.side] == 1].sum())

    def charts(self):
        """The number of charts, that of each face, and whether the face is read from its back in order to agree with others
        of the chart."""
        count = self.face[-1] + 1
        order = np.argsort(self.side, kind="stable")
        i, j = order[:-1], order[1:]
        is_pair = self.side[i] == self.side[j]
        i, j = i[is_pair], j[is_pair]
        f, g, is_turned = self.face[i], self.face[j], self.is_forward[i] == self.is_forward[j]
        # Each face twice, by the side from which it is read.
        rows, columns = np.concatenate([f, f + count]), np.concatenate([g + count * is_turned, g + count * ~is_turned])
        graph = coo_matrix((np.ones(len(rows)), (rows, columns)), (2 * count, 2 * count))
        number, chart = connected_components(coo_matrix((np.ones(len(f)), (f, g)), (count, count)), directed=False)
        half = connected_components(graph, directed=False)[1].reshape(2, count)
        return number, chart, half[0] > half[1]


def double_areas(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def angles(p):
    """At the corners of triangles; all of them too large to be true where two corners coincide, as in the benchmark."""
    result = np.empty(p.shape[:2])
    for k in range(3):
        a, b = p[:, (k + 1) % 3] - p[:, k], p[:, (k + 2) % 3] - p[:, k]
        cross = np.abs(double_areas(a, b)) if p.shape[2] == 2 else np.linalg.norm(np.cross(a, b), axis=1)
        result[:, k] = np.arctan2(cross, np.sum(a * b, axis=1))
    sides = np.linalg.norm(p - np.roll(p, -1, axis=1), axis=2)
    result[(sides == 0).any(axis=1)] = np.nan
    return result


class Stretch:
    """The Jacobian of each face, by its squared norm and its determinant, in the orthonormal frame of its first edge."""

    def __init__(self, corners, uv):
        a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        self.area = np.linalg.norm(np.cross(a, b), axis=1) / 2
        self.uv_area = double_areas(uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]) / 2
        with np.errstate(divide="ignore", invalid="ignore"):
            base = np.linalg.norm(a, axis=1)
            along, height = np.sum(a * b, axis=1) / base, 2 * self.area / base
            first = (uv[:, 1] - uv[:, 0]) / base[:, None]
            second = (uv[:, 2] - uv[:, 0] - along[:, None] * first) / height[:, None]
            self.first, self.second = first, second
            self.norm = np.sum(first ** 2 + second ** 2, axis=1)
            self.determinant = double_areas(first, second)

    def energies(self, kept):
        """Symmetric Dirichlet energies of the faces at the scale of all that has the least mean; 4 is no distortion."""
        area, norm, squared = self.area[kept], self.norm[kept], self.determinant[kept] ** 2
        scale = (np.sum(area * norm / squared) / np.sum(area * norm)) ** 0.25
        return norm * (scale ** 2 + 1 / (squared * scale ** 2))

    def cosines(self, kept):
        """Between the directions on the surface of the two axes of the plane."""
        first, second = self.first[kept], self.second[kept]
        along_u, along_v = np.stack([second[:, 1], -first[:, 1]], axis=1), np.stack([-second[:, 0], first[:, 0]], axis=1)
        return np.abs(np.sum(along_u * along_v, axis=1)) / np.linalg.norm(along_u, axis=1) / np.linalg.norm(along_v, axis=1)


def quantile(values, weights, share):
    order = np.argsort(values)
    sums = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(sums, share * sums[-1])])


def worst_mean(values, weights, group):
    """The largest of the weighted means of groups."""
    with np.errstate(invalid="ignore"):
        return float(np.nanmax(np.bincount(group, values * weights) / np.bincount(group, weights)))


def area_ratio(area, uv_area, group):
    """PartUV's measure: for each group of faces, and how many faces it counts, the mean ratio of areas, whichever way larger."""
    number = group.max() + 1
    sums, uv_sums, faces = (np.bincount(group, weights, number) for weights in (area, uv_area, None))
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = uv_area / area / (uv_sums / sums)[group]
        counts = (area >= SMALLEST_SHARE * (sums / faces)[group]) & (ratio > 0) & (area > 0)
        ratio = np.minimum(np.maximum(ratio, 1 / ratio), LARGEST_RATIO)
        return np.bincount(group[counts], ratio[counts], number) / np.bincount(group[counts], minlength=number)


def measure(points, faces, uv):
    if not np.isfinite(uv).all():
        raise Invalid(f"{int((~np.isfinite(uv)).any(axis=(1, 2)).sum())} faces without UVs")
    extent = float(np.ptp(uv.reshape(-1, 2), axis=0).max())
    used = points[np.unique(faces)]
    sides, stretch = Sides(points, faces, uv), Stretch(points[faces], uv)
    number, chart, is_turned = sides.charts()
    has_area = stretch.area > 0
    signs = np.where(is_turned, -1, 1) * orientations(uv[:, 0], uv[:, 1], uv[:, 2])
    votes = np.bincount(chart, signs * has_area)
    kept = has_area & (signs * np.where(votes < 0, -1, 1)[chart] > 0)
    if extent == 0 or not kept.any():
        raise Invalid("UVs without area")
    energies = stretch.energies(kept)
    share, uv_share = stretch.area / stretch.area.sum(), np.abs(stretch.uv_area) / np.abs(stretch.uv_area).sum()
    angle_errors = np.abs(angles(points[faces]) - angles(uv))
    angle_errors[np.isnan(angle_errors)] = 2 * np.pi
    pairs = overlapping_pairs(uv)
    ratios = area_ratio(stretch.area, np.abs(stretch.uv_area), chart)
    return {
        "faces": len(faces), "charts": int(number),
        "seam": sides.cut_length() / float(np.linalg.norm(np.ptp(used, axis=0))), "uv_seam": sides.chart_border() / extent,
        "E_mean": float(np.average(energies, weights=stretch.area[kept])), "E_99": quantile(energies, stretch.area[kept], QUANTILE),
        "E_chart": worst_mean(energies, stretch.area[kept], chart[kept]),
        "E_max": float(energies.max()), "flipped": int(has_area.sum() - kept.sum()), "overlaps": len(pairs),
        "fill": float(np.abs(stretch.uv_area).sum()) / extent ** 2,
        "area_discrepancy": float(np.abs(uv_share - share).sum()),
        "angle_discrepancy": float(np.sum(share * angle_errors.sum(axis=1))),
        "partuv_angle": float(1 - stretch.cosines(kept).mean()),
        "partuv_area": float(area_ratio(stretch.area, np.abs(stretch.uv_area), np.zeros(len(faces), int))[0]),
        "partuv_worst_chart": float(np.nanmax(ratios))}
