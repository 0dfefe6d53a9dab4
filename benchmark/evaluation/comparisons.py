"""Figures 16 and 18: other detectors, other Steiner trees."""

import statistics

from measuring import Claim, mean, report, rows
from paper import MEAN_TREE_RATIO, SHORTEST_TREES
from plots import cumulative, histogram, write_plot

RIVALS = ["seamster"]
DETECTORS = [*RIVALS, "ours"]


def detector_commands(setting):
    return {("detectors", mesh): setting.detectors(mesh, ",".join(DETECTORS), "best") for mesh in setting.closed}


def detector_table(setting, outcomes):
    """Figure 16."""
    table = [row for outcome in outcomes.values() for row in rows(outcome)]
    setting.write_table("figure_16_detectors", table)
    done = {name: {row["mesh"]: row for row in table if row["detector"] == name and row["status"] == "done"}
            for name in DETECTORS}
    setting.write_table("figure_16_statistics",
                        [statistic(name, found.values()) for name, found in done.items() if found])
    write_plot(setting.output, "figure_16_detectors",
               "set xlabel 'mean energy (4.6 and more in the last bin)'; set ylabel 'share of the meshes'",
               [(name, histogram([row["E"] for row in found.values()], 4., 4.6, 15), "linespoints")
                for name, found in done.items()])
    setting.rivals = {name: done[name] for name in RIVALS}
    setting.values["largest_default_energy"] = max((row["E"] for row in done["ours"].values()), default=0.)
    return [claim for rival in RIVALS for claim in rival_claims(rival, done[rival], done["ours"])]


def statistic(name, found):
    energies = [row["E"] for row in found]
    return {"detector": name, "meshes": len(energies), "E_mean": mean(energies), "E_max": max(energies),
            "E_deviation": statistics.pstdev(energies), "L_mean": mean(row["L"] for row in found),
            "features_mean": mean(row["features"] for row in found),
            "detect_s_mean": mean(row["detect_seconds"] + row["filter_seconds"] for row in found)}


def rival_claims(rival, theirs, ours):
    """On the meshes on which both succeed."""
    common = sorted(theirs.keys() & ours.keys())
    if not common:
        return [Claim("Figure 16", f"lower mean energy than {rival}", "lower", "", None)]
    energy, rival_energy = (mean(found[mesh]["E"] for mesh in common) for found in (ours, theirs))
    better = sum(all(theirs[mesh][column] < ours[mesh][column] for column in "EL") for mesh in common)
    return [
        Claim("Figure 16", f"lower mean energy than {rival}", "lower",
              f"{energy:.3f} against {rival_energy:.3f} on {len(common)} meshes", energy < rival_energy),
        Claim("Section 4.2", f"hardly a mesh on which {rival} has both lower energy and a shorter cut",
              "not measured", f"{better} of {len(common)}", better < len(common) / 10)]


def same_energy_commands(setting):
    """A rival that misses features has shorter cuts. What counts is the length at the same energy."""
    return {(rival, mesh): setting.unwrap(mesh, "--max-distortion", row["E"])
            for rival, found in setting.rivals.items() for mesh in setting.closed
            if (row := found.get(mesh.name))}


def same_energy_table(setting, outcomes):
    table = []
    for (rival, mesh), outcome in outcomes.items():
        r, row = report(outcome), setting.rivals[rival][mesh.name]
        if r and r["status"] == "done":
            table.append({"mesh": mesh.name, "rival": rival, "E_rival": row["E"], "L_rival": row["L"], "E": r["E_iso"],
                          "L": r["cut_length"]})
    setting.write_table("figure_16_same_energy", table)
    claims = []
    for rival, found in setting.rivals.items():
        own = [row for row in table if row["rival"] == rival]
        ours, theirs = (mean(row[column] for row in own) for column in ("L", "L_rival"))
        claims.append(Claim("Section 4.2", f"bounded to the energy of {rival}, no longer cuts", "not measured",
                            f"{ours:.3f} against {theirs:.3f} on {len(own)} of {len(found)} meshes" if own else "",
                            ours <= theirs * (1 + 1e-5) if own else None))  # theirs have six digits
    return claims


def steiner_commands(setting):
    return {("steiner", mesh): [setting.programs / "connect_random_terminals", mesh.parent, mesh.name]
            for mesh in setting.closed}


def steiner_table(setting, outcomes):
    """Figure 18: ratios to the shortest tree, where that is proven."""
    table = [row for outcome in outcomes.values() for row in rows(outcome)
             if outcome.exit_code == 0 and row["optimal"] == 1]
    setting.write_table("figure_18_steiner_trees", table)
    if not table:
        return [Claim("Figure 18", "greedy trees are close to the shortest", "", "", None)]
    ratios = {name: [row[f"length_{name}"] / row["length_best"] for row in table] for name in ("mst", "sph", "greedy")}
    write_plot(setting.output, "figure_18_steiner_trees",
               "set xlabel 'length / shortest length'; set ylabel 'share of the sets'; set xrange [1:1.2]; "
               "set yrange [0:1]; set key bottom right",
               [(name, cumulative(values), "steps") for name, values in ratios.items()])
    exact = {name: sum(ratio <= 1 + 1e-9 for ratio in values) / len(values) for name, values in ratios.items()}
    others = f"MST {mean(ratios['mst']):.4f}, SPH {mean(ratios['sph']):.4f}"
    ours = mean(ratios["greedy"])
    return [
        Claim("Figure 18", "the greedy connection often finds a shortest tree", f"{100 * SHORTEST_TREES:.1f} %",
              f"{100 * exact['greedy']:.1f} % of {len(table)} sets (MST {100 * exact['mst']:.1f} %, "
              f"SPH {100 * exact['sph']:.1f} %)", exact["greedy"] >= SHORTEST_TREES - 0.1),
        Claim("Figure 18", "mean ratio of the greedy connection to the shortest", f"{MEAN_TREE_RATIO}", f"{ours:.4f}",
              ours <= MEAN_TREE_RATIO + 0.002),
        Claim("Figure 18", "greedy is shorter than MST and SPH on average", "shorter", f"{ours:.4f}; {others}",
              ours < min(mean(ratios["mst"]), mean(ratios["sph"])))]
