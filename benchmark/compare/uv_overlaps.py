"""Which triangles of a layout overlap, decided exactly."""

from fractions import Fraction

import numpy as np

PAIRS_AT_ONCE = 4_000_000
# A little more than the rounding errors of the determinant below (Shewchuk, Adaptive precision floating-point arithmetic, 1997)
RELATIVE_ERROR = 4e-16
SMALLEST = 1e-290  # of products, below which digits are lost


def exact_sign(a, b, c):
    (ax, ay), (bx, by), (cx, cy) = (map(Fraction, point) for point in (a, b, c))
    determinant = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return (determinant > 0) - (determinant < 0)


def orientations(a, b, c):
    """1 where c is to the left of the line from a to b, -1 to the right, 0 on it, for arrays of points."""
    left, right = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]), (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    signs = np.sign(left - right).astype(int)
    is_same = (a == b).all(axis=1) | (b == c).all(axis=1) | (c == a).all(axis=1)
    signs[is_same] = 0
    for i in np.flatnonzero(~is_same & (np.abs(left - right) <= RELATIVE_ERROR * (np.abs(left) + np.abs(right)) + SMALLEST)):
        signs[i] = exact_sign(a[i].tolist(), b[i].tolist(), c[i].tolist())
    return signs


def box_pairs(low, high):
    """Yields pairs (i, j), arrays each, of boxes whose interiors meet: a sweep along x in strips across y."""
    number = max(1, int(len(low) ** 0.5))
    bottom, height = low[:, 1].min(), max(np.ptp([low[:, 1].min(), high[:, 1].max()]), 1e-300)

    def strip_of(y):
        return np.clip((y - bottom) / height * number, 0, number - 1).astype(int)

    first_strip, spans = strip_of(low[:, 1]), strip_of(high[:, 1]) - strip_of(low[:, 1]) + 1
    boxes = np.repeat(np.arange(len(low)), spans)
    strips = first_strip[boxes] + np.arange(len(boxes)) - np.repeat(np.cumsum(spans) - spans, spans)
    order = np.lexsort((low[boxes, 0], strips))
    boxes, bounds = boxes[order], np.searchsorted(strips[order], np.arange(number + 1))
    for strip, (begin, end) in enumerate(zip(bounds, bounds[1:])):
        members = boxes[begin:end]
        follow = np.searchsorted(low[members, 0], high[members, 0]) - np.arange(len(members)) - 1
        follow = np.maximum(follow, 0)
        # As many members at once as have a bounded number of pairs.
        part = np.cumsum(follow) // PAIRS_AT_ONCE
        for chosen in (np.flatnonzero(part == k) for k in np.unique(part)):
            counts = follow[chosen]
            i = np.repeat(chosen, counts)
            j = i + 1 + np.arange(len(i)) - np.repeat(np.cumsum(counts) - counts, counts)
            i, j = members[i], members[j]
            lower = np.maximum(low[i, 1], low[j, 1])
            keep = (lower < np.minimum(high[i, 1], high[j, 1])) & (strip_of(lower) == strip)
            yield i[keep], j[keep]


def overlapping(p, q):
    """Which of the pairs of counterclockwise triangles (n x 3 x 2) have a common interior point: those of which no side has
    the other triangle on its outer side or line."""
    left = np.arange(len(p))
    for one, other in ((p, q), (q, p)):
        for side in range(3):
            a, b = one[left, side], one[left, (side + 1) % 3]
            inner = np.max([orientations(a, b, other[left, k]) for k in range(3)], axis=0)
            left = left[inner > 0]
    return left


def overlapping_pairs(triangles):
    """Pairs (k x 2) of triangles (m x 3 x 2) whose interiors meet. Triangles without area have none."""
    signs = orientations(triangles[:, 0], triangles[:, 1], triangles[:, 2])
    kept = np.flatnonzero(signs)
    if len(kept) == 0:
        return np.empty((0, 2), int)
    turned = triangles[kept].copy()
    is_clockwise = signs[kept] < 0
    turned[is_clockwise] = turned[is_clockwise][:, ::-1]
    pairs = [np.empty((0, 2), int)]
    for i, j in box_pairs(turned.min(axis=1), turned.max(axis=1)):
        found = overlapping(turned[i], turned[j])
        pairs.append(np.stack([kept[i[found]], kept[j[found]]], axis=1))
    return np.concatenate(pairs)
