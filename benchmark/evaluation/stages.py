"""Table 3, Figure 14: the paper's method to the letter, stage by stage."""

from measuring import Claim, mean, rows
from paper import LARGEST_ENERGY, STAGE_COLUMNS, stages
from plots import write_plot


def stage_commands(setting):
    commands = {}
    for mesh in setting.closed:
        commands["candidates", mesh] = setting.detectors(mesh, "candidates", "mst")
        commands["faithful", mesh] = setting.detectors(mesh, "faithful", "mst,sph,greedy,greedy_sph,best")
    return commands


def stage_row(mesh, outcomes):
    """A line of Table 3; None if a stage failed."""
    before = [row for row in rows(outcomes["candidates", mesh]) if row["status"] == "done"]
    after = {row["connection"]: row for row in rows(outcomes["faithful", mesh]) if row["status"] == "done"}
    if not before or not {"mst", "greedy"} <= after.keys():
        return None
    first, filtered, final = before[0], after["mst"], after["greedy"]
    seconds = [final[column] for column in ("detect_seconds", "filter_seconds", "connect_seconds")]
    return dict(zip(STAGE_COLUMNS, [
        mesh.name, int(first["faces"]), int(first["features"]), first["L"], first["E"], int(filtered["features"]),
        filtered["L"], filtered["E"], int(final["branches"]), final["L"], final["E"], *seconds, sum(seconds)]))


def stage_table(setting, outcomes):
    table = list(filter(None, (stage_row(mesh, outcomes) for mesh in setting.closed)))
    if not table:
        return [Claim("Table 3", "all stages", "", "", None)]
    averages = [{key: name if key == "mesh" else round(mean(row[key] for row in part), 4) for key in STAGE_COLUMNS}
                for name, part in (("mean of the paper", stages()), ("our mean", table))]
    setting.write_table("table_3_stages", table + averages)
    paper, ours = averages
    set_up = "set logscale xy; set xlabel 'triangles'; set ylabel 'seconds'"
    write_plot(setting.output, "table_3_seconds", set_up,
               [("ours", [(row["triangles"], row["total_s"]) for row in table], "points pt 7"),
                ("paper (triangles = 2 x vertices)", [(2 * row["triangles"], row["total_s"]) for row in stages()],
                 "points pt 6")])

    def change(row, a, b):
        return 100 * (row[b] / row[a] - 1)

    expected = len(setting.closed)
    largest = max(row["E"] for row in table)
    lines = [
        ("filtering makes the cut shorter", "L_before", "L_after"),
        ("connecting through auxiliary points makes the cut shorter", "L_after", "L")]
    claims = [Claim("Table 3", f"{text} (change of the mean length)", f"{change(paper, a, b):+.1f} %",
                    f"{change(ours, a, b):+.1f} %", change(ours, a, b) < 0) for text, a, b in lines]
    shares = [row["filter_s"] / row["total_s"] for row in averages]
    claims += [
        Claim("Table 3", "filtering raises the mean energy only slightly",
              f"{paper['E_after'] - paper['E_before']:+.3f}", f"{ours['E_after'] - ours['E_before']:+.3f}",
              ours["E_after"] - ours["E_before"] < 0.1),
        Claim("Table 3", "mean energy of the results", f"{paper['E']:.3f}", f"{ours['E']:.3f}",
              ours["E"] <= paper["E"] + 0.05),
        Claim("Section 4.1", "filtering takes most of the time", f"{100 * shares[0]:.0f} %",
              f"{100 * shares[1]:.0f} %", shares[1] > 0.5),
        Claim("Section 4.1", "all meshes get a map without flips", "all of 3757",
              f"{len(table)} of {expected} closed meshes of genus 0 within the time limit", len(table) == expected),
        Claim("Section 5", "largest mean energy of a result", f"{LARGEST_ENERGY}", f"{largest:.3f}",
              largest <= LARGEST_ENERGY),
    ]
    setting.stages = table
    measure_feature_sets(setting, outcomes)
    return claims + construction_claim(setting, outcomes)


def construction_claim(setting, outcomes):
    """Figure 14: what is inside the greedy connection hardly matters."""
    table = []
    for mesh in setting.closed:
        ways = {row["connection"]: row for row in rows(outcomes["faithful", mesh]) if row["status"] == "done"}
        if {"greedy", "greedy_sph"} <= ways.keys():
            mst, sph = ways["greedy"], ways["greedy_sph"]
            table.append({"mesh": mesh.name, "L_mst": mst["L"], "L_sph": sph["L"], "E_mst": mst["E"], "E_sph": sph["E"],
                          "difference_percent": 100 * (sph["L"] / mst["L"] - 1)})
    setting.write_table("figure_14_construction", table)
    differences = [abs(row["difference_percent"]) for row in table]
    return [Claim("Figure 14", "SPH instead of MST inside the greedy connection makes a negligible difference",
                  "almost the same cuts",
                  f"length differs by {mean(differences):.2f} % on average, "
                  f"{max(differences, default=0.):.2f} % at most",
                  mean(differences) < 1 if differences else None)]


def measure_feature_sets(setting, outcomes):
    """Section 4.3 on real sets: the feature points of the meshes, where the shortest tree is known."""
    ratios = []
    for mesh in setting.closed:
        ways = {row["connection"]: row["L"] for row in rows(outcomes["faithful", mesh])
                if row["status"] == "done" and row["features"] >= 4}
        if {"greedy", "best"} <= ways.keys():
            ratios.append(ways["greedy"] / ways["best"])
    if ratios:  # lengths have six digits
        setting.values |= {"feature_sets": len(ratios), "feature_ratio": mean(ratios),
                           "feature_percent": 100 * mean(ratio <= 1 + 1e-5 for ratio in ratios)}
