"""Layouts checked from their definition, in exact arithmetic: what charts and distances there are."""

from fractions import Fraction


def charts_of(faces):
    """The chart of each face: connected through edges with the same texture points on both sides."""
    chart = list(range(len(faces)))

    def root(f):
        while chart[f] != f:
            chart[f] = chart[chart[f]]
            f = chart[f]
        return f

    sides = {}
    for f, face in enumerate(faces):
        for k, corner in enumerate(face):
            edge = frozenset((tuple(corner), tuple(face[k - 1])))
            chart[root(f)] = root(sides.setdefault(edge, f))
    return [root(f) for f in range(len(faces))]


def borders_of(faces, chart):
    """The edges with one face, as pairs of texture points, of each chart."""
    sides = {}
    for f, face in enumerate(faces):
        for k in range(len(face)):
            sides.setdefault(frozenset((face[k - 1][1], face[k][1])), []).append((f, face[k - 1][1], face[k][1]))
    borders = {}
    for edges in sides.values():
        if len(edges) == 1:
            f, a, b = edges[0]
            borders.setdefault(chart[f], []).append((a, b))
    return borders


def squared_distance(p, a, b):
    """From a point to a segment."""
    d, v = [b[i] - a[i] for i in (0, 1)], [p[i] - a[i] for i in (0, 1)]
    length = d[0] * d[0] + d[1] * d[1]
    t = max(0, min(1, (d[0] * v[0] + d[1] * v[1]) / length)) if length else 0
    return sum((v[i] - t * d[i]) ** 2 for i in (0, 1))


def do_cross(a, b, c, d):
    side = lambda p, q, r: (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def contains(border, uvs, p):
    """By the number of border edges to the right; `p` is not on the border."""
    inside = False
    for a, b in ((uvs[a], uvs[b]) for a, b in border):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]):
            inside = not inside
    return inside


def check_atlas(case, uvs, faces, pages, margin, texture_size):
    """`pages`: for each face. Charts lie in the unit square of their page, apart, by the margin."""
    uvs = [tuple(map(Fraction, uv)) for uv in uvs]
    gap = Fraction(margin) / texture_size
    chart = charts_of(faces)
    borders = borders_of(faces, chart)
    page_of = dict(zip(chart, pages))
    for f, face in enumerate(faces):
        case.assertEqual(page_of[chart[f]], pages[f], "a chart on two pages")
        for _, uv in face:
            for x in uvs[uv]:
                case.assertTrue(gap <= x <= 1 - gap, (float(x), float(gap)))
    names = sorted(borders)
    boxes = {name: [(min(uvs[v][i] for edge in borders[name] for v in edge), max(uvs[v][i] for edge in borders[name] for v in edge))
                    for i in (0, 1)] for name in names}
    for i, first in enumerate(names):
        for second in names[:i]:
            if page_of[first] != page_of[second] or any(boxes[first][k][0] > boxes[second][k][1] + gap
                                                        or boxes[second][k][0] > boxes[first][k][1] + gap for k in (0, 1)):
                continue
            for a, b in borders[first]:
                for c, d in borders[second]:
                    a1, b1, c1, d1 = uvs[a], uvs[b], uvs[c], uvs[d]
                    case.assertFalse(do_cross(a1, b1, c1, d1), "charts overlap")
                    case.assertGreaterEqual(min(squared_distance(a1, c1, d1), squared_distance(b1, c1, d1),
                                                squared_distance(c1, a1, b1), squared_distance(d1, a1, b1)), gap * gap)
            case.assertFalse(contains(borders[first], uvs, uvs[borders[second][0][0]]))
            case.assertFalse(contains(borders[second], uvs, uvs[borders[first][0][0]]))
    return len(names)
