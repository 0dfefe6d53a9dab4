"""Figures 10 to 13: the thresholds, and other triangulations of the same shape."""

from measuring import Claim, rank_correlation, report
from paper import TRIANGULATIONS, UNEVEN, stage
from plots import write_plot

# epsilon_iso of the energy, epsilon_len in diagonals of the bounding box; the defaults are among them.
ISOMETRIC = [0.0005, 0.001, 0.002, 0.003, 0.005, 0.007, 0.01, 0.015, 0.02, 0.03, 0.05, 0.07, 0.1]
LENGTH = [0.001, 0.002, 0.003, 0.005, 0.007, 0.01, 0.02, 0.03, 0.05, 0.1, 0.2, 0.4]


def model(setting, name):
    """The mesh of this name if it is there, otherwise one of middle size."""
    named = [mesh for mesh in setting.closed if mesh.stem.lower() == name]
    return named[0] if named else setting.closed[len(setting.closed) // 2]


def sweep_commands(setting):
    mesh = model(setting, "hand")
    commands = {("eps_iso", x): setting.unwrap(mesh, "--faithful", "--eps-iso", x) for x in ISOMETRIC}
    commands.update({("eps_len", x): setting.unwrap(mesh, "--faithful", "--eps-len", x) for x in LENGTH})
    return commands


def sweep_rows(outcomes, name):
    found = ((x, report(outcome)) for (key, x), outcome in outcomes.items() if key == name)
    return [{name: x, "features": r["features"], "auxiliary": r["auxiliary"], "L": r["cut_length"], "E": r["E_iso"],
             "seconds": r["cpu_seconds"]["connect"]} for x, r in found if r]


def trend(source, table, column, against, rises):
    """A claim that a column rises or falls with the threshold."""
    values = rank_correlation([row[against] for row in table], [row[column] for row in table])
    direction = "rises" if rises else "falls"
    return Claim(source, f"{column} {direction} with {against}", direction,
                 f"rank correlation {values:+.2f}", (values > 0.5) if rises else (values < -0.5))


def sweep_tables(setting, outcomes):
    mesh = model(setting, "hand").name
    claims = []
    for name, source, trends in (
            ("eps_iso", "Figure 10", [("E", True), ("features", False), ("L", False)]),
            ("eps_len", "Figure 11", [("auxiliary", False), ("L", True), ("seconds", False)])):
        table = sweep_rows(outcomes, name)
        if len(table) < 3:
            claims.append(Claim(source, f"sweep of {name}", "", "", None))
            continue
        stem = f"{source.lower().replace(' ', '_')}_{name}"
        setting.write_table(stem, table)
        second = "features" if name == "eps_iso" else "auxiliary"
        write_plot(setting.output, stem,
                   f"set logscale x; set xlabel '{name} ({mesh})'; set ylabel 'L'; set y2tics; set key top center",
                   [("L", [(row[name], row["L"]) for row in table], "using 1:2 with linespoints"),
                    (f"{second} (right)", [(row[name], row[second]) for row in table],
                     "using 1:2 axes x1y2 with linespoints")])
        claims += [trend(source, table, column, name, rises) for column, rises in trends]
    return claims


def triangulation_meshes(setting):
    return {name: setting.output / "triangulations" / f"{name}.off" for name in [*TRIANGULATIONS, "uneven"]}


def making_commands(setting):
    mesh = model(setting, "bunny")
    return {("make", mesh): [setting.programs / "make_triangulations", mesh, setting.output / "triangulations"]}


def triangulation_commands(setting):
    return {("triangulation", name): setting.unwrap(mesh, "--faithful")
            for name, mesh in triangulation_meshes(setting).items() if mesh.exists()}


def triangulation_table(setting, outcomes):
    table = []
    for name, source in {**TRIANGULATIONS, "uneven": None}.items():
        r = report(outcomes[("triangulation", name)]) if ("triangulation", name) in outcomes else None
        if r:
            paper = stage(source) if source else {}
            table.append({"triangulation": name, "triangles": r["faces"], "features": r["features"],
                          "L": r["cut_length"], "E": r["E_iso"], "seconds": r["cpu_seconds"]["total"],
                          "paper_L": paper.get("L", ""), "paper_E": paper.get("E", "")})
    setting.write_table("figure_12_13_triangulations", table)
    setting.triangulations = {row["triangulation"]: row for row in table}
    even = [row for row in table if row["triangulation"] != "uneven"]
    uneven = [row for row in table if row["triangulation"] == "uneven"]
    papers = [stage(name) for name in TRIANGULATIONS.values()]
    claims = []
    for column, limit in ("L", 1.25), ("E", 1.02):
        values = [row[column] for row in even]
        known = [row[column] for row in papers]
        claims.append(Claim("Figure 12", f"{column} is similar for all triangulations of a shape",
                            f"{min(known):.3f} to {max(known):.3f}",
                            f"{min(values):.3f} to {max(values):.3f} ({len(values)} of 6)" if values else "",
                            max(values) / min(values) < limit if len(values) == 6 else None))
    claims.append(Claim("Figure 13", "low energy at uneven densities, too",
                        ", ".join(f"{stage(name)['E']:.3f}" for name in UNEVEN),
                        ", ".join(f"{row['E']:.3f}" for row in uneven), uneven[0]["E"] < 4.2 if uneven else None))
    return claims
