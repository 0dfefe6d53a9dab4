#!/usr/bin/env python3
"""Runs of unwrap on a data set, in shards that any number of machines work on.

  campaign.py create CAMPAIGN PROGRAM MESHES... [--shards N] [--options '...'] [limits]
  campaign.py work CAMPAIGN SHARD
  campaign.py status CAMPAIGN
  campaign.py shards CAMPAIGN

A campaign is a folder that all machines see: what is to be run (campaign.json), and per shard the
records of corpus/run_mesh.py, one line per mesh. Working on a shard runs each of its meshes
that has no record yet, one process each, so whatever was interrupted is repeated by working on the
shard again. A shard is worked on by one process at a time; a second one fails.

`status` prints one line per shard that is not complete, and fails if there is one; `shards` prints
their number.
"""

import argparse
import fcntl
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CORPUS = HERE.parent / "corpus"
sys.path.insert(0, str(CORPUS))

from outcomes import read_records  # noqa: E402
from run_corpus import meshes_in  # noqa: E402
from thumbnail import thumbnail  # noqa: E402


class Campaign:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.plan = json.loads((self.folder / "campaign.json").read_text())

    @property
    def number_of_shards(self):
        return self.plan["shards"]

    def meshes(self, shard):
        return self.plan["meshes"][shard::self.number_of_shards]

    def results(self, shard):
        return self.folder / "results" / f"{shard}.jsonl"

    def picture(self, mesh):
        return self.folder / "pictures" / f"{self.plan['meshes'].index(mesh)}.svg"

    def records(self):
        """All records, in the order of the meshes."""
        found = [read_records(self.results(shard)) for shard in range(self.number_of_shards)]
        order = {mesh: i for i, mesh in enumerate(self.plan["meshes"])}
        return sorted((record for records in found for record in records), key=lambda record: order[record["mesh"]])

    def missing(self, shard):
        finished = {record["mesh"] for record in read_records(self.results(shard))}
        return [mesh for mesh in self.meshes(shard) if mesh not in finished]

    def command(self, mesh, *places):
        """What runs one mesh; without places, the command that repeats it by hand."""
        return [self.plan["program"], mesh, *places, *self.plan["options"]]

    def run(self, mesh, shard):
        with tempfile.TemporaryDirectory() as folder:
            kept = pathlib.Path(folder, "result.obj")
            line = subprocess.run(
                [sys.executable, "-B", CORPUS / "run_mesh.py", "--keep", kept, "--time-limit",
                 str(self.plan["time_limit"]), "--memory-limit", str(self.plan["memory_limit"]),
                 self.plan["program"], mesh, "--", *self.plan["options"]],
                check=True, stdout=subprocess.PIPE).stdout
            if kept.exists():
                self.picture(mesh).write_text(thumbnail(kept))
        with open(self.results(shard), "ab") as results:
            results.write(line)


def create(arguments):
    folder = pathlib.Path(arguments.campaign)
    for name in "results", "pictures":
        (folder / name).mkdir(parents=True, exist_ok=True)
    meshes = [str(mesh.resolve()) for mesh in dict.fromkeys(meshes_in(arguments.meshes))]
    plan = {"program": str(pathlib.Path(arguments.program).resolve()), "options": arguments.options.split(),
            "time_limit": arguments.time_limit, "memory_limit": arguments.memory_limit,
            "shards": max(1, min(arguments.shards, len(meshes))), "meshes": meshes}
    with open(folder / "campaign.json", "x", encoding="utf-8") as file:  # a campaign is never changed
        json.dump(plan, file, indent=1)
    print(f"{len(meshes)} meshes in {plan['shards']} shards")


def trim_unfinished_line(file):
    """A worker that was killed while it wrote leaves the start of a line."""
    content = file.read()
    file.truncate(content.rfind(b"\n") + 1)


def work(arguments):
    campaign = Campaign(arguments.campaign)
    with open(campaign.results(arguments.shard), "ab+") as results:
        try:
            fcntl.flock(results, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            sys.exit(f"shard {arguments.shard} is being worked on")
        results.seek(0)
        trim_unfinished_line(results)
        for mesh in campaign.missing(arguments.shard):
            campaign.run(mesh, arguments.shard)


def status(arguments):
    campaign = Campaign(arguments.campaign)
    incomplete = 0
    for shard in range(campaign.number_of_shards):
        missing = len(campaign.missing(shard))
        if missing:
            print(f"shard {shard}: {missing} of {len(campaign.meshes(shard))} meshes missing")
            incomplete += 1
    sys.exit(1 if incomplete else 0)


def shards(arguments):
    print(Campaign(arguments.campaign).number_of_shards)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)

    def add(function):
        command = commands.add_parser(function.__name__)
        command.set_defaults(function=function)
        command.add_argument("campaign", help="the folder")
        return command

    command = add(create)
    command.add_argument("program", help="the program unwrap")
    command.add_argument("meshes", nargs="+", help="meshes, folders of meshes, or lists of meshes (.txt)")
    command.add_argument("--shards", type=int, default=100, metavar="N", help="default: %(default)s")
    command.add_argument("--options", default="--threads 1", help="of unwrap, in one word; default: %(default)s")
    command.add_argument("--time-limit", type=float, default=600, metavar="SECONDS", help="per mesh; default: 600")
    command.add_argument("--memory-limit", type=int, default=0, metavar="MB", help="per mesh; default: none")
    add(work).add_argument("shard", type=int)
    add(status)
    add(shards)
    arguments = parser.parse_args()
    arguments.function(arguments)


if __name__ == "__main__":
    main()
