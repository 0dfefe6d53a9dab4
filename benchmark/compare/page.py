"""The comparison as one page of HTML that needs nothing else: tables, and a figure for each measure."""

import html
import math

import tables

COLORS = ("#c8102e", "#e8862e", "#2166ac", "#35978f", "#762a83", "#7fbf7b", "#8c510a", "#666666", "#000000")
WIDTH, HEIGHT, MARGIN = 900, 240, 60
STYLE = """body { font: 14px sans-serif; margin: 2em; max-width: 1200px }
table { border-collapse: collapse; margin: 1em 0; font-size: 12px }
td, th { border: 1px solid #ccc; padding: 2px 6px; text-align: right } td:first-child { text-align: left } svg { display: block }"""


def table(rows):
    def line(row, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row) + "</tr>"
    return "<table>" + line(rows[0], "th") + "".join(line(row, "td") for row in rows[1:]) + "</table>"


def figure(records, programs, measure):
    """A dot for each mesh and program, meshes in the order of the first program's values; logarithmic axes have four decades."""
    columns = sorted(zip(*([value if value is not None else math.inf for value in tables.values(records, name, measure)]
                           for name in programs), records), key=lambda column: column[0])
    found = [value for column in columns for value in column[:-1] if math.isfinite(value)]
    if not found:
        return ""

    def scaled(value):
        return math.log10(max(value, 1e-4 * max(found), 1e-9)) if measure.is_logarithmic else value

    low, high = scaled(min(found)), scaled(max(found))
    span = high - low or 1

    def place(value):
        return HEIGHT - 30 - (HEIGHT - 60) * (scaled(value) - low) / span if math.isfinite(value) else 12

    marks = []
    for share in (0, 0.25, 0.5, 0.75, 1):
        level = low + share * span
        y = HEIGHT - 30 - (HEIGHT - 60) * share
        label = 10 ** level if measure.is_logarithmic else level
        marks.append(f"<path d='M{MARGIN} {y:.1f}H{WIDTH}' stroke='#ddd'/><text x='{MARGIN - 5}' y='{y + 4:.1f}' text-anchor='end' "
                     f"font-size='11'>{label:.3g}</text>")
    for i, column in enumerate(columns):
        left = MARGIN + 10 + (WIDTH - MARGIN - 20) * (i + 0.5) / len(columns) - 1.5 * len(programs)
        for k, (value, name, color) in enumerate(zip(column, programs, COLORS)):
            x = left + 3 * k
            label = f"{column[-1]}, {name}: {value:.4g}" if math.isfinite(value) else f"{column[-1]}, {name}: no result"
            shape = f"<circle cx='{x:.1f}' cy='{place(value):.1f}' r='3.2'" if math.isfinite(value) else \
                f"<path d='M{x - 3:.1f} 9l6 6m0 -6l-6 6' stroke='{color}'"
            marks.append(f"{shape} fill='{color}'><title>{html.escape(label)}</title></{shape[1:shape.index(' ')]}>")
    return f"<h3>{html.escape(measure.title)}</h3><svg width='{WIDTH}' height='{HEIGHT}'>{''.join(marks)}</svg>"


def page(records, found, programs, ours):
    legend = " ".join(f"<b style='color:{color}'>&#9679; {html.escape(name)}</b>" for name, color in zip(programs, COLORS))
    parts = [f"<h1>{len(records)} surfaces</h1>", f"<p>{legend}</p>", table(found["programs"]),
             "<h2>Measures, mesh by mesh</h2><p>A cross above is a run without a result.</p>",
             *(figure(records, programs, measure) for measure in tables.MEASURES)]
    for name in programs:
        parts += [f"<h2>{html.escape(name)} minus {html.escape(ours)}</h2>", table(found[name])] if name != ours else []
    for name, rows in found.items():
        parts += [f"<h2>{html.escape(name.replace('_minus_', ' minus '))}</h2>", table(rows)] if "_minus_" in name else []
    parts += ["<h2>Exceptions</h2>", table(found["exceptions"]), "<h2>All runs</h2>", table(tables.of_meshes(records, programs))]
    head = f"<head><meta charset='utf-8'><title>Comparison</title><style>{STYLE}</style></head>"
    return f"<!DOCTYPE html><html lang='en'>{head}<body>" + "\n".join(parts) + "</body></html>\n"
