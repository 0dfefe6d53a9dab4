"""A ramp of many turns: without overlaps, its layout takes many charts."""

import math

from off_files import write_off

TURNS = 20


def write_ramp(path, turns=TURNS, steps_per_turn=200, width=32):
    length = turns * steps_per_turn
    points, faces = [], []
    for i in range(length + 1):
        angle = 2 * math.pi * i / steps_per_turn
        radii = (1 + j / width for j in range(width + 1))
        points += ((radius * math.cos(angle), radius * math.sin(angle), 0.05 * angle) for radius in radii)
    for a in (i * (width + 1) + j for i in range(length) for j in range(width)):
        faces += [(a, a + width + 1, a + width + 2), (a, a + width + 2, a + 1)]
    write_off(path, points, faces)
