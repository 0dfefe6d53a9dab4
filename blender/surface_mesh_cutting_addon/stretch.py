# SPDX-License-Identifier: GPL-3.0-or-later
"""Distortion as artists know it: the stretch in percent at which all lengths are that much too long, or too short.

The program measures the mean symmetric Dirichlet energy, which is 2 (s^2 + 1 / s^2) for lengths that are s times too long."""

import math


def energy_of(percent):
    square = (1 + percent / 100) ** 2
    return 2 * (square + 1 / square)


def percent_of(energy):
    half = max(energy / 2, 2.0)  # rounding may leave less than the ideal
    return 100 * (math.sqrt((half + math.sqrt(half * half - 4)) / 2) - 1)
