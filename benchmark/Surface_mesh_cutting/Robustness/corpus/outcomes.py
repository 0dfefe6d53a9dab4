"""How the runs of a corpus ended: the classes of outcomes, files of records, and the table.

A file of results has one record, a JSON object, per line. usage: outcomes.py RESULTS... prints the table."""

import collections
import json
import pathlib
import sys

CLASSES = {
    "certified": "done, and proven valid",
    "bound_not_reached": "proven valid, but a requested bound was missed",
    "refused": "the input was refused with a reason",
    "failed": "ended with a reason, without a result",
    "stopped": "reached the time limit of the program itself",
    "usage": "the options were wrong",
    "out_of_memory": "needed more than the memory limit",
    "hang": "ended by the runner at its time limit",
    "uncertified": "claimed success without a proof",
    "crash": "anything else",
}
BY_EXIT_CODE = {0: "certified", 2: "usage", 3: "refused", 4: "refused", 5: "failed", 6: "stopped",
                7: "bound_not_reached"}


def is_proven(report, options, has_map):
    """Whether the report of a success says that everything was proven, and there is a map."""
    return (has_map and report.get("flips") == 0
            and ("--allow-overlap" in options or "--faithful" in options or report.get("overlaps") == 0))


def classify(exit_code, report, options, has_map, is_timed_out):
    """The class of a run; `exit_code` is negative for a signal, `report` is empty if there was none."""
    if is_timed_out:
        return "hang"
    if exit_code == -9 or report.get("message") == "out of memory":
        return "out_of_memory"
    outcome = BY_EXIT_CODE.get(exit_code, "crash") if report else "crash"
    if outcome in ("certified", "bound_not_reached") and not is_proven(report, options, has_map):
        return "uncertified"
    return outcome


def read_records(file):
    """All complete records; a line that a killed run left unfinished is skipped."""
    records = []
    for line in file.read_text().splitlines() if file.exists() else []:
        try:
            records.append(json.loads(line))
        except json.JSONDecodeError:
            pass
    return records


def by_options(records):
    """{options: {mesh: record}}; of several records of a mesh the last one counts."""
    result = collections.defaultdict(dict)
    for record in records:
        result[" ".join(record["options"])][record["mesh"]] = record
    return result


def table(records):
    """One line per set of options, one column per class that occurs, then what was not certified."""
    runs = by_options(records)
    present = {record["outcome"] for meshes in runs.values() for record in meshes.values()}
    columns = [name for name in CLASSES if name in present]
    rows = [["options", "meshes", *columns, "seconds", "longest", "peak MB"]]
    for options, meshes in sorted(runs.items()):
        counts = collections.Counter(record["outcome"] for record in meshes.values())
        seconds = [record["seconds"] for record in meshes.values()]
        rows.append([options or "(none)", str(len(meshes)), *(str(counts[name]) for name in columns),
                     f"{sum(seconds):.0f}", f"{max(seconds):.1f}",
                     f"{max(record['peak_memory_mb'] for record in meshes.values()):.0f}"])
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(cell.ljust(width) if i == 0 else cell.rjust(width)
                       for i, (cell, width) in enumerate(zip(row, widths))) for row in rows]
    for options, meshes in sorted(runs.items()):
        for mesh, record in sorted(meshes.items()):
            if record["outcome"] != "certified":
                message = (record["report"] or {}).get("message", record["messages"][-200:])
                lines.append(f"{record['outcome']}: {mesh} {options}: {' '.join(message.split())}")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table([record for name in sys.argv[1:] for record in read_records(pathlib.Path(name))]))
