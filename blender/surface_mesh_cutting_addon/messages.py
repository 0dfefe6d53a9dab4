# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of the program in words, with what to do."""

import re

NO_PROGRAM = ("The program unwrap was not found: build it, and set its path in the preferences of the add-on "
              "or put its folder on PATH")

_ADVICE = {
    2: "The program is of another version than the add-on: build both again",
    3: "This is a defect of the add-on",
    4: "Repair what is selected, or ask for less: fewer seams to keep, a smaller vertex group",
    5: "Try Allow Overlaps, or another effort",
    6: "Allow more time",
}
_INTERPRETED = {
    "non_manifold_edges": "edges with more than two faces, which became seams",
    "non_manifold_vertices": "vertices at which faces do not hang together",
    "reoriented_faces": "faces that look to the other side than their neighbors",
    "non_orientable_edges": "edges opened because the surface has only one side",
    "degenerate_faces": "faces with a vertex twice",
    "duplicate_faces": "faces that are there more than once",
    "welded_vertices": "vertices at the same place as others",
}


def _without_numbers(message):
    """The program counts the faces that it gets; in Blender, what it names is selected."""
    message = re.sub(r" \(counted from 0.*\)$", "", message)
    message = re.sub(r": (vertex|vertices|edges?|faces?) [\d, -]+( and \d+ more)?$", "", message)
    return re.sub(r"\b(vertex|edge|face) \d+(-\d+)?", r"a \1", message)


def failure(result):
    """Why a run has no layout, and what to do."""
    report = result.report
    message = _without_numbers(report["message"])
    advice = _ADVICE.get(result.exit_code)
    return message[:1].upper() + message[1:] + (". " + advice if advice else "")


def warnings(result):
    """What the user should know about a run with a layout."""
    report = result.report
    texts = [_without_numbers(text) for text in report["warnings"]]
    texts += [f"{_INTERPRETED.get(found['what'], found['what'])}: {found['count']}" for found in report["interpreted"]]
    if result.exit_code == 6:
        texts.append("stopped: this is the best result so far")
    if result.exit_code == 7:
        texts.append(f"the bound is not reached, the mean energy is {report['E_iso']:.4g}: allow more")
    return texts


def summary(results):
    """Measures of all layouts."""
    charts = sum(result.report["charts"] for result in results)
    energies = ", ".join(f"{result.report['E_iso']:.3f}" for result in results)
    return f"{charts} chart{'s' if charts > 1 else ''}, mean energy {energies} (4: no distortion)"
