# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of the program in words, with what to do."""

import re

from . import stretch

NO_PROGRAM = ("The program unwrap was not found: install the add-on from an archive that holds it, or set its path in the "
              "preferences of the add-on")

_ADVICE = {
    2: "The program and the add-on are of different versions: install both from the same archive",
    3: "This is a mistake in the add-on: please report it",
    4: "Repair what is selected, or ask for less: fewer seams to keep, a smaller vertex group",
    5: "Try Allow Overlaps, or another effort",
    6: "Allow more time",
}
_INTERPRETED = {
    "non_manifold_edges": "Edges with more than two faces, which became seams",
    "non_manifold_vertices": "Vertices that connect faces without a common edge",
    "reoriented_faces": "Faces that point the other way than their neighbors (Mesh > Normals > Recalculate Outside)",
    "non_orientable_edges": "Edges that became seams because the surface has only one side, like a Moebius strip",
    "degenerate_faces": "Faces without area (Mesh > Clean Up > Degenerate Dissolve)",
    "repeated_corners": "Faces with corners that repeat others (Mesh > Clean Up > Degenerate Dissolve)",
    "divided_faces": "Faces that visit a vertex several times",
    "duplicate_faces": "Faces that exist more than once (Mesh > Merge > By Distance)",
    "welded_vertices": "Vertices at the same place as others (Mesh > Merge > By Distance)",
}


# The program's warnings, by words that it uses.
_WARNINGS = {
    "at the same point": "Several vertices are at the same place: merge them (Mesh > Merge > By Distance) if the faces there "
                         "belong together",
    "inside out": "Closed parts are inside out (Mesh > Normals > Recalculate Outside)",
    "of length zero": "Edges of length zero (Mesh > Merge > By Distance)",
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
    texts = [next((words for part, words in _WARNINGS.items() if part in text), _without_numbers(text))
             for text in report["warnings"]]
    texts += [f"{_INTERPRETED.get(found['what'], found['what'])}: {found['count']}" for found in report["interpreted"]]
    if result.exit_code == 6:
        texts.append("Stopped: this is the best layout found so far")
    if result.exit_code == 7 and report["witness"] is not None:
        texts.append("Some faces or islands are stretched more than their limit: seams cannot go where they would lower that")
    elif result.exit_code == 7:
        texts.append(f"The stretch is {stretch.percent_of(report['E_iso']):.1f} %: seams cannot go where they would lower it "
                     "to the limit")
    return texts


def summary(results):
    """Measures of all layouts."""
    islands = sum(result.report["charts"] for result in results)
    percents = ", ".join(f"{stretch.percent_of(result.report['E_iso']):.1f} %" for result in results)
    return f"{islands} island{'s' if islands > 1 else ''}, mean stretch {percents}"
