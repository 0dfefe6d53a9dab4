#!/usr/bin/env python3
"""Writes CAMPAIGN/index.html about a campaign (see campaign.py): what failed and how to repeat it,
histograms, and a table of all meshes with pictures of their layouts. The page needs no network; it
and the folder `pictures` can be moved together. It can be written while the campaign runs.

  summary_page.py CAMPAIGN
"""

import collections
import html
import math
import pathlib
import shlex
import sys

from campaign import Campaign
from outcomes import CLASSES

TEMPLATE = pathlib.Path(__file__).with_name("summary_page.html")
PROVEN = ("certified", "bound_not_reached")

# Heading, how to find the value in a record, how to show it.
COLUMNS = [
    ("outcome", lambda record: record["outcome"], str),
    ("faces", lambda record: report(record).get("faces"), str),
    ("genus", lambda record: report(record).get("genus"), str),
    ("borders", lambda record: report(record).get("borders"), str),
    ("features", lambda record: report(record).get("features"), str),
    ("length", lambda record: report(record).get("cut_length"), "{:.3f}".format),
    ("E mean", lambda record: report(record).get("E_iso"), "{:.4f}".format),
    ("E max", lambda record: report(record).get("E_max"), "{:.3g}".format),
    ("seconds", lambda record: record["seconds"], "{:.2f}".format),
    ("MB", lambda record: record["peak_memory_mb"], "{:.0f}".format),
]


def report(record):
    return record["report"] or {}


def kind(heading):
    return ' class="text"' if heading in ("layout", "mesh", "outcome") else ""


def histogram(title, values, limit, number_of_bins=30):
    """An inline SVG picture; what lies above the limit is counted in the last bin."""
    values = [value for value in values if value is not None and math.isfinite(value)]
    if not values:
        return ""
    low, high = min(values), min(max(values), limit)
    width = (high - low) / number_of_bins or 1.
    counts = collections.Counter(min(int((value - low) / width), number_of_bins - 1) for value in values)
    top = max(counts.values())
    bars = "".join(
        f'<rect x="{10 * i}" y="{100 - 95 * n / top:.1f}" width="9" height="{95 * n / top:.1f}" fill="#4c8bc0">'
        f"<title>{n} from {low + i * width:.4g}</title></rect>" for i, n in sorted(counts.items()))
    mean = sum(values) / len(values)
    more = " and more" if max(values) > high else ""
    return (f'<figure><svg viewBox="0 0 {10 * number_of_bins} 118" width="330" height="130" font-size="11">{bars}'
            f'<line x1="0" x2="300" y1="100" y2="100" stroke="#57606a"/><text x="0" y="114">{low:.4g}</text>'
            f'<text x="300" y="114" text-anchor="end">{high:.4g}{more}</text></svg>'
            f"<figcaption>{title}: mean {mean:.4g}, largest {max(values):.4g}</figcaption></figure>")


def row(campaign, record):
    name = pathlib.Path(record["mesh"]).name
    picture = campaign.picture(record["mesh"])
    image = f'<img src="pictures/{picture.name}" alt="layout" loading="lazy">' if picture.exists() else ""
    cells = [f"<td>{image}</td>", f'<td class="text" title="{html.escape(record["mesh"])}">{html.escape(name)}</td>']
    for heading, find, show in COLUMNS:
        value = find(record)
        text = "" if value is None else html.escape(show(value))
        exact = f' data-value="{value!r}"' if isinstance(value, float) else ""
        cells.append(f"<td{kind(heading)}{exact}>{text}</td>")
    bad = "" if record["outcome"] in PROVEN else ' class="bad"'
    words = html.escape(f"{name} {record['outcome']}".lower())
    return f'<tr{bad} data-words="{words}">{"".join(cells)}</tr>'


def failure(campaign, record):
    message = report(record).get("message") or record["messages"].strip() or "no message"
    command = shlex.join(campaign.command(record["mesh"]))
    return (f"<details><summary>{html.escape(pathlib.Path(record['mesh']).name)}: {html.escape(message[:200])}"
            f"</summary><pre>{html.escape(command)}</pre></details>")


def failures(campaign, records):
    parts = []
    for outcome, meaning in CLASSES.items():
        group = [record for record in records if record["outcome"] == outcome and outcome not in PROVEN]
        if group:
            parts.append(f"<h3>{outcome}: {len(group)}</h3><p>{html.escape(meaning)}</p>")
            parts += [failure(campaign, record) for record in group]
    return "\n".join(parts) or "<p>Nothing.</p>"


def introduction(campaign, records):
    counts = collections.Counter(record["outcome"] for record in records)
    expected = len(campaign.plan["meshes"])
    seconds = sum(record["seconds"] for record in records)
    options = shlex.join(campaign.plan["options"]) or "none"
    parts = ", ".join(f"{counts[outcome]} {outcome}" for outcome in CLASSES if counts[outcome])
    return (f"{len(records)} of {expected} meshes: {parts}. Options of unwrap: <code>{html.escape(options)}</code>. "
            f"{seconds:.0f} s in all. Lengths are in diagonals of the bounding box; E is the symmetric Dirichlet "
            "energy, at least 4.")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    campaign = Campaign(sys.argv[1])
    records = campaign.records()
    proven = [report(record) for record in records if record["outcome"] in PROVEN]
    page = {
        "title": f"unwrap on {len(campaign.plan['meshes'])} meshes",
        "introduction": introduction(campaign, records),
        "histograms": histogram("Mean energy", [r.get("E_iso") for r in proven], 4.5)
        + histogram("Cut length", [r.get("cut_length") for r in proven], 6.)
        + histogram("Seconds", [record["seconds"] for record in records], 60.),
        "failures": failures(campaign, records),
        "headings": "".join(f"<th{kind(heading)}>{heading}</th>"
                            for heading in ["layout", "mesh"] + [column[0] for column in COLUMNS]),
        "rows": "\n".join(row(campaign, record) for record in records),
    }
    text = TEMPLATE.read_text(encoding="utf-8")
    for name, content in page.items():
        text = text.replace(f"@{name}@", content)
    (campaign.folder / "index.html").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
