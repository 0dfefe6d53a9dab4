#!/usr/bin/env python3
"""Tells whether campaigns over the same meshes have the same results, bit for bit: for each mesh exactly
one record, with the same outcome, digest of the mesh with texture coordinates, and measures (times and
memory left out). Prints the differences, and fails if there are any.

  compare_campaigns.py CAMPAIGN...     with one campaign: whether it is complete
"""

import collections
import re
import sys

from campaign import Campaign

MEASURED_ANEW = ("seconds", "cpu_seconds", "peak_memory_mb")


def results(campaign):
    """{mesh: result}; prints what is missing or there twice."""
    records = campaign.records()
    counts = collections.Counter(record["mesh"] for record in records)
    problems = [f"{campaign.folder}: {counts[mesh]} records of {mesh}"
                for mesh in campaign.plan["meshes"] if counts[mesh] != 1]
    found = {}
    for record in records:
        report = {key: value for key, value in (record["report"] or {}).items() if key not in MEASURED_ANEW}
        report["message"] = re.sub(r", [^ ]+ s$", "", report.get("message", ""))
        found[record["mesh"]] = (record["outcome"], record["digest"], report)
    return found, problems


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    campaigns = [Campaign(folder) for folder in sys.argv[1:]]
    first, problems = results(campaigns[0])
    for campaign in campaigns[1:]:
        other, more = results(campaign)
        problems += more
        problems += [f"{campaign.folder}: another result for {mesh}"
                     for mesh in sorted(first.keys() | other.keys()) if first.get(mesh) != other.get(mesh)]
    print("\n".join(problems) or f"{len(first)} meshes, the same in {len(campaigns)} campaigns")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
