"""What maps without overlaps cost where the plane has little room."""

import pathlib

from bench import Measured, mean_of, total_seconds
from meshes import CROWDED
from ramp import TURNS, write_ramp

BOUND = "4.03"


def measure_room(bench):
    """At a tight bound, against maps that may overlap."""
    meshes = bench.meshes(CROWDED)
    free, bijective = (bench.reports(meshes, "--max-distortion", BOUND, *options, jobs=bench.options.jobs)
                       for options in (["--allow-overlap"], []))
    table = [["Surface", "with overlaps", "without", "charts", "s"]]
    for name, one, other in zip(CROWDED, free, bijective):
        table.append([pathlib.Path(name).stem, f"{one['cut_length']:.3f}", f"{other['cut_length']:.3f}", str(other["charts"]),
                      f"{total_seconds(other):.1f}"])
    return Measured({"surfaces": len(meshes), "kept": sum(report["status"] == "done" for report in bijective),
                     "overlaps": sum(report["overlaps"] for report in bijective),
                     "whole": sum(report["charts"] == before["charts"] for report, before in zip(bijective, free)),
                     "length_percent": 100 * (mean_of(bijective, "cut_length") / mean_of(free, "cut_length") - 1),
                     "seconds": sum(map(total_seconds, bijective))}, {"room": table})


def measure_ramp(bench):
    """Where there is no room at all."""
    ramp = bench.folder / "ramp.off"
    write_ramp(ramp)
    report, = bench.reports([ramp], "--effort", "fast")
    return Measured({"turns": TURNS, "triangles": report["faces"], "charts": report["charts"], "length": report["cut_length"],
                     "energy": report["E_iso"], "seconds": total_seconds(report)})
