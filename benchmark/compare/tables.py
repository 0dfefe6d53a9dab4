"""Summaries of the records of all runs: tables of text, the first row of which has the headings."""

import dataclasses
import math

import paired_statistics


@dataclasses.dataclass(frozen=True)
class Measure:
    key: str
    title: str
    digits: int = 2
    sign: int = 1  # -1 where larger values are better
    is_logarithmic: bool = True  # in figures


MEASURES = (
    Measure("charts", "charts", 0), Measure("seam", "seam on the surface"), Measure("uv_seam", "seam in the unit square"),
    Measure("E_mean", "mean energy", 3), Measure("E_99", "energy, 99 %", 3), Measure("E_max", "largest energy", 1),
    Measure("E_chart", "worst chart, energy", 3),
    Measure("angle_discrepancy", "angles", 3), Measure("area_discrepancy", "areas", 3),
    Measure("partuv_angle", "angles, PartUV", 3, -1, False), Measure("partuv_area", "areas, PartUV", 3),
    Measure("partuv_worst_chart", "worst chart, PartUV", 3),
    Measure("overlaps", "overlapping pairs", 0, 1, False), Measure("flipped", "flipped faces", 0, 1, False),
    Measure("fill", "fill", 3, -1, False), Measure("seconds", "seconds"), Measure("memory_mb", "MB", 0))


def text(value, digits):
    if value is None or math.isnan(value):
        return "-"
    return f"{value:,.{digits}f}".replace("inf", "\u221e")


def value_of(record, measure):
    """None for a run without a result."""
    return record.get(measure.key) if record["outcome"] == "done" else None


def values(records, program, measure):
    """Mesh by mesh."""
    return [value_of(row[program], measure) for row in records.values()]


def totals(records, programs):
    """Median and mean of each measure, for the runs with a result."""
    rows = [["program", "meshes", "without result", *(f"{m.title}: median / mean" for m in MEASURES)]]
    for program in programs:
        found = [paired_statistics.summary(values(records, program, m)) for m in MEASURES]
        rows.append([program, str(len(records)), str(found[0][2]),
                     *(f"{text(median, m.digits)} / {text(mean, m.digits)}" for m, (median, mean, _) in zip(MEASURES, found))])
    return rows


def pairs(records, ours, theirs):
    """For each measure, how a program differs from ours."""
    rows = [["measure", "ours is better", "equal", "worse", "median difference", "95 % confidence", "p, signed rank"]]
    for m in MEASURES:
        first, second = ([value if value is None else m.sign * value for value in values(records, name, m)]
                         for name in (ours, theirs))
        found = paired_statistics.compare(first, second)
        low, median, high = (text(value, m.digits + 1) for value in (found.low, found.median, found.high))
        rows.append([m.title, str(found.better), str(found.equal), str(found.meshes - found.better - found.equal),
                     median, f"{low} to {high}", f"{found.p:.2g}"])
    return rows


def is_beaten(one, other, key):
    """Whether another run has a smaller value, or alone a result."""
    first, second = (record.get(key) if record["outcome"] == "done" else math.inf for record in (one, other))
    return second < first - 1e-9


def counts(records, ours, rivals):
    """On how many meshes no rival is better than ours, and what is wrong with ours."""
    found = {key: sum(not any(is_beaten(row[ours], row[name], key) for name in rivals) for row in records.values())
             for key in ("charts", "seam", "uv_seam")}
    return {"meshes": len(records), **{f"best_{key}": number for key, number in found.items()},
            "unfinished": sum(row[ours]["outcome"] != "done" for row in records.values()),
            **{key: sum(row[ours].get(key, 0) for row in records.values()) for key in ("overlaps", "flipped")}}


def counts_at_bounds(records, bounds):
    """For each program (ours, rival, key) that got a measure of a rival as a bound, of the meshes that the rival cuts: on how many it
    keeps the bound, and on how many its seam is shorter."""
    found = {}
    for name, rival, key in bounds:
        rows = [(row[name], row[rival]) for row in records.values() if row[rival]["outcome"] == "done" and row[rival]["seam"] > 0]
        done = [(ours, theirs) for ours, theirs in rows if ours["outcome"] == "done"]
        found |= {f"{name}_meshes": len(rows), f"{name}_kept": sum(ours[key] <= theirs[key] for ours, theirs in done),
                  f"{name}_shorter": sum(ours["seam"] < theirs["seam"] for ours, theirs in done)}
    return found


def values_of_all(records, ours, programs, rivals):
    """Numbers by name, for texts: counts(), and medians and means of each program."""
    found = counts(records, ours, rivals)
    for program in programs:
        for m in MEASURES:
            median, mean, missing = paired_statistics.summary(values(records, program, m))
            found |= {f"{program}_{m.key}_median": median, f"{program}_{m.key}": mean, f"{program}_missing": missing}
    return found


def exceptions(records, ours, rivals):
    """Runs with fewer charts or a shorter seam than ours, and those of ours without a result or with overlaps."""
    rows = [["mesh", "program", "charts, ours", "theirs", "seam, ours", "theirs", "energy, ours", "theirs", "outcome of ours"]]
    chosen = [m for m in MEASURES if m.key in ("charts", "seam", "E_mean")]
    for mesh, row in records.items():
        one = row[ours]
        for name in rivals:
            if one["outcome"] != "done" or one["overlaps"] or any(is_beaten(one, row[name], key) for key in ("charts", "seam")):
                rows.append([mesh, name, *(text(value_of(record, m), m.digits) for m in chosen for record in (one, row[name])),
                             f"{one['outcome']} {one['message']}".strip()])
    return rows


def of_meshes(records, programs):
    rows = [["mesh", "program", "outcome", *(m.title for m in MEASURES)]]
    for mesh, row in records.items():
        rows += [[mesh, name, row[name]["outcome"], *(text(value_of(row[name], m), m.digits) for m in MEASURES)]
                 for name in programs]
    return rows


def markdown(rows):
    lines = [f"| {' | '.join(cell.replace('|', '/').replace(chr(10), ' ') for cell in row)} |" for row in rows]
    return "\n".join([lines[0], "|" + " --- |" * len(rows[0]), *lines[1:]]) + "\n"
