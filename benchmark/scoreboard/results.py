"""The stored results of all drivers: a line of JSON each time that a claim was measured.

A record has the name of the claim, the command that measures it, its values and tables, and the commit, date, seconds and
processor. Values are numbers by name; a table is a list of rows of text, the first of which are its headings."""

import json
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "results"


def append(driver, record, folder=FOLDER):
    with open(folder / f"{driver}.json", "a", encoding="utf-8") as file:
        file.write(json.dumps(record) + "\n")


def latest(folder=FOLDER):
    """{claim: its last record}; each claim belongs to one driver."""
    records = {}
    for file in sorted(folder.glob("*.json")):
        for line in file.read_text(encoding="utf-8").splitlines():
            record = json.loads(line)
            records[record["claim"]] = record
    return records
