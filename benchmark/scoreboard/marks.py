"""Numbers and tables in texts that rest on stored results.

A number is written as <!--=CLAIM.VALUE-->NUMBER, with as many decimals as the text is to have, and a table as

    <!--table CLAIM.TABLE COLUMN,...-->

    the table

    <!--/table-->

where the columns may be left out, and CLAIM.TABLE is `claims` for the table of all claims."""

import re

NUMBER = re.compile(r"<!--=(\w+)\.(\w+)-->([+-]?\d+(?:,\d{3})*(?:\.\d+)?)")
TABLE = re.compile(r"(<!--table ([\w.]+)(?: ([^>]*))?-->\n\n)(.*?)(\n?<!--/table-->)", re.S)
OPENING = re.compile(r"<!--(?:=|table )")
# A number with a unit that only measuring can give.
MEASURE = re.compile(r"\b\d[\d,.]*\s*(?:%|s|ms|MB|GB|seconds?|milliseconds?|minutes?|megabytes|gigabytes|kilobytes|percent)(?![\w/])")


class Unknown(Exception):
    """A mark that names what is not stored."""


def formatted(value, like):
    """The value with the decimals and the sign of the text that it replaces."""
    decimals = len(like.split(".")[1]) if "." in like else 0
    return f"{value:{'+' if like.startswith('+') else ''},.{decimals}f}"


def markdown(rows):
    lines = [f"| {' | '.join(row)} |" for row in rows]
    return "\n".join([lines[0], "|" + " --- |" * len(rows[0]), *lines[1:]]) + "\n"


def table_of_claims(records):
    """What benchmark/README.md leads to."""
    rows = [["claim, with the last result", "command", "takes", "measured"]]
    for name in sorted(records, key=lambda name: (records[name]["command"], name)):
        record = records[name]
        rows.append([record["statement"], f"`{record['command']}`", f"{record['minutes']:g} min",
                     f"{record['date']}, {record['commit']}"])
    return rows


def stored_table(records, name, columns):
    if name == "claims":
        return table_of_claims(records)
    claim, _, table = name.partition(".")
    try:
        rows = records[claim]["tables"][table]
        chosen = [rows[0].index(column.strip()) for column in columns.split(",")] if columns else range(len(rows[0]))
    except (KeyError, ValueError) as error:
        raise Unknown(f"{name}: {error}") from error
    return [[row[i] for i in chosen] for row in rows]


def updated(text, records):
    """The text with all that is marked as it is stored."""
    def number(match):
        claim, value, like = match.groups()
        try:
            stored = records[claim]["values"][value]
        except KeyError as error:
            raise Unknown(f"{claim}.{value} is not stored") from error
        return match[0][:-len(like)] + formatted(stored, like)

    def table(match):
        return match[1] + markdown(stored_table(records, match[2], match[3])) + "\n" + match[5].lstrip("\n")

    if len(OPENING.findall(text)) != len(NUMBER.findall(text)) + len(TABLE.findall(text)):
        raise Unknown("a mark has no number, or a table no end")
    return TABLE.sub(table, NUMBER.sub(number, text))


def unmarked(text):
    """Measures in the text that no mark holds: (line, measure)."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match[0])
    for pattern in (NUMBER, TABLE, re.compile(r"```.*?```|\\code.*?\\endcode", re.S), re.compile(r"^    .*$", re.M),
                    re.compile(r"`[^`\n]*`"), re.compile(r"<!--.*?-->", re.S)):
        text = pattern.sub(blank, text)
    return [(number, match[0]) for number, line in enumerate(text.splitlines(), 1) for match in MEASURE.finditer(line)]
