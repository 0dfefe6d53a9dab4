# SPDX-License-Identifier: GPL-3.0-or-later
"""The call of the program `unwrap`: its arguments, and its input files."""

import numpy as np

from . import angles, files
from .stretch import energy_of

MESH, LAYOUT, REPORT = "mesh.ply", "layout.obj", "report.json"

SHARP_FACTOR = 0.2  # of the program's weights "crease"
GROUP_FACTOR = 10
NEVER_FROM = 0.5  # the weight in the vertex group
ANGLE_TOLERANCE = 1e-4  # radians, as coordinates have single precision


class Refusal(Exception):
    """What the user asks for cannot be done; the text says why, and what to do."""


def _number(value):
    """As the user sees it: Blender's numbers have single precision."""
    return f"{value:.7g}"


def _constrain(surface, settings, folder):
    """The arguments for edges that become seams, and for those to start from. An edge with one face is open anyway."""
    is_fixed = np.zeros(len(surface.edge_vertices), bool)
    if settings.marked_seams == 'KEEP':
        is_fixed |= surface.is_seam
    if settings.cut_marked_sharp:
        is_fixed |= surface.is_sharp
    if settings.cut_materials:
        is_fixed |= surface.is_between_materials()
    if settings.cut_sharp:
        is_fixed |= angles.at_edges(surface) >= settings.sharp_angle - ANGLE_TOLERANCE
    is_start = surface.is_seam & (settings.marked_seams == 'START')
    faces_at = np.bincount(surface.corner_edges, minlength=len(surface.edge_vertices))
    arguments = []
    for option, name, is_chosen in (("--must-cut", "fixed.selection.txt", is_fixed),
                                    ("--initial-cut", "start.selection.txt", is_start)):
        edges = surface.edge_vertices[is_chosen & (faces_at > 1)]
        if len(edges) > 0:
            files.write_edges(folder / name, edges)
            arguments += [option, name]
    return arguments


def _weigh(surface, settings, folder):
    """The arguments for edges that cost less than their length."""
    arguments = ["--hard-surface"] if settings.hard_surface else []
    for is_wanted, word in ((settings.sharp, "crease"), (settings.hidden, "visibility"), (settings.straight, "straight")):
        if is_wanted:
            arguments += ["--edge-weights", word]
    if settings.marked_sharp and surface.is_sharp.any():
        files.write_edge_factors(folder / "sharp.txt", surface.edge_vertices[surface.is_sharp], SHARP_FACTOR)
        arguments += ["--edge-weights", "sharp.txt"]
    return arguments


def _bound(settings):
    """The arguments for limits of the stretch."""
    arguments = []
    for is_wanted, option, stretch in ((settings.limits_stretch, "--max-distortion", settings.stretch),
                                       (settings.limits_island_stretch, "--max-chart-distortion", settings.island_stretch),
                                       (settings.limits_face_stretch, "--max-face-distortion", settings.face_stretch)):
        if is_wanted:
            arguments += [option, _number(energy_of(stretch))]
    if settings.limits_face_stretch and settings.face_share < 100:
        arguments += ["--face-quantile", _number(settings.face_share / 100)]
    return arguments


def _use_group(surface, settings, folder):
    """The arguments for the vertex group."""
    if not settings.vertex_group:
        return []
    weights = surface.group_weights(settings.vertex_group)
    if weights is None:
        raise Refusal(f'No object has a vertex group "{settings.vertex_group}": choose another one, or none')
    if settings.group_use == 'NEVER':
        edges = surface.edge_vertices[(weights[surface.edge_vertices] >= NEVER_FROM).all(axis=1)]
        if len(edges) == 0:
            return []
        files.write_edges(folder / "never.selection.txt", edges)
        return ["--never-cut", "never.selection.txt"]
    exponent = 1 if settings.group_use == 'AVOID' else -1
    files.write_vertex_factors(folder / "paint.txt", (1 + (GROUP_FACTOR - 1) * weights) ** exponent)
    return ["--edge-weights", "paint:paint.txt"]


def _check(settings):
    """Raises `Refusal` if settings exclude each other."""
    is_light_map = settings.target == 'LIGHT_MAP'
    if is_light_map and settings.stacks:
        raise Refusal("Light falls on each part: a light map cannot stack equal parts")
    if is_light_map and settings.scale != 'unit':
        raise Refusal("A light map needs the scale Fill the Square")
    if settings.scale == 'unit' and not is_light_map and 2 * settings.margin >= settings.texture_size:
        raise Refusal("The margin must be less than half of the texture size")


def prepare(surface, settings, threads, folder):
    """Writes the input files into `folder` and returns the arguments, whose file names are relative to it.

    `threads` is a number of threads, or 0 for as many as there are cores. Raises `Refusal`."""
    _check(settings)
    files.write_ply(folder / MESH, surface)
    arguments = [MESH, "-o", LAYOUT, "--json", REPORT, "--progress", "--effort", settings.effort,
                 "--uv-scale", settings.scale]
    if settings.scale == 'unit':
        arguments += (["--lightmap", str(settings.texture_size)] if settings.target == 'LIGHT_MAP' else
                      ["--margin", _number(settings.margin), "--texture-size", str(settings.texture_size)])
        if settings.turn != 'automatic':
            arguments += ["--rotate", settings.turn]
        if settings.limits_density:
            arguments += ["--texels-per-unit", _number(settings.density), "--udim"]
        elif settings.pages > 1:
            arguments += ["--pages", str(settings.pages), "--udim"]
        if settings.limits_fill and not settings.limits_density:
            arguments += ["--min-fill", _number(settings.fill / 100)]
    if settings.stacks:
        arguments.append("--stack")
    if settings.symmetry != 'off':
        arguments += ["--symmetry", settings.symmetry]
    if settings.seam_smoothness != 1:  # otherwise, the program knows which efforts take the time
        arguments += ["--seam-smoothness", _number(settings.seam_smoothness)]
    if settings.may_overlap:
        arguments.append("--allow-overlap")
    if settings.time_limit > 0:
        arguments += ["--time-limit", _number(settings.time_limit)]
    if threads > 0:
        arguments += ["--threads", str(threads)]
    return (arguments + _bound(settings) + _constrain(surface, settings, folder) + _weigh(surface, settings, folder)
            + _use_group(surface, settings, folder))
