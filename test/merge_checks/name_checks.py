"""Checks that the manual's table of names lists every setting of C++, Python, the program and Blender, and no other:

    name_checks.py SOURCE_FOLDER

prints each violation, and exits with 1 if there is one."""

import ast
import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1])


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def documented_parameters():
    """the named parameters of unwrap() and what goes with it"""
    headers = [f"include/CGAL/Surface_mesh_cutting/{name}.h" for name in ("unwrap", "unwrap_polygon_soup", "pack_charts")]
    text = "".join(map(read, ["doc/Surface_mesh_cutting/Named_parameters.txt", *headers]))
    return set(re.findall(r"\\cgalParamNBegin\{(\w+)\}", text))


def keywords():
    """of the functions of the module that map and pack"""
    options = ast.parse(read("python/surface_mesh_cutting/options.py"))
    found = {line.target.id for kind in options.body if isinstance(kind, ast.ClassDef) for line in kind.body
             if isinstance(line, ast.AnnAssign)}
    for module, function in ("cutting", "unwrap"), ("charts", "pack_charts"):
        for each in ast.parse(read(f"python/surface_mesh_cutting/{module}.py")).body:
            if isinstance(each, ast.FunctionDef) and each.name == function:
                found |= {argument.arg for argument in each.args.kwonlyargs}
    return found


def program_options():
    """those that the sources add to the command line"""
    folder = "examples/Surface_mesh_cutting/unwrap"
    text = "".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / folder).glob("*.cpp")))
    # add_option("-o,--output", ...), add_number<int>(app, "--margin", ...), set_version_flag("--version", ...)
    calls = re.findall(r'\b(?:add_\w+|set_\w*flag)(?:<[^()]*>)?\(\s*(?:app,\s*)?"(-[^"]*)"', text)
    return {name for call in calls for name in call.split(",") if name.startswith("--")} | {"--help"}


def properties():
    """of the operator"""
    settings = ast.parse(read("blender/surface_mesh_cutting_addon/settings.py"))
    return {line.target.id for kind in settings.body if isinstance(kind, ast.ClassDef) for line in kind.body
            if isinstance(line, ast.AnnAssign)}


def table():
    """for each row of the settings, the names in each column"""
    text = read("doc/Surface_mesh_cutting/Names.txt").split("\\section smc_names_of_settings")[1].split("\\section")[0]
    for line in re.findall(r"^\|(.*)\|$", text, re.MULTILINE)[2:]:
        yield [[name for name in re.findall(r"`([^`]+)`", cell) if re.fullmatch(r"-*[a-z_-]+", name)]
               for cell in line.split("|")]


def suggestions():
    """what the module suggests for names of others"""
    for each in ast.parse(read("python/surface_mesh_cutting/options.py")).body:
        if isinstance(each, ast.Assign) and each.targets[0].id == "OTHER_NAMES":
            return ast.literal_eval(each.value)
    return {}


def violations():
    rows = list(table())
    for column, (kind, expected) in enumerate((("named parameter", documented_parameters()), ("keyword", keywords()),
                                               ("option", program_options()), ("property", properties()))):
        listed = {name for row in rows for name in row[column]}
        yield from (f"Names.txt: the {kind} {name} is missing" for name in sorted(expected - listed))
        yield from (f"Names.txt: there is no {kind} {name}" for name in sorted(listed - expected))
    known = suggestions()
    for parameters, names, options, _ in rows:
        for other in [*parameters, *(option.lstrip("-").replace("-", "_") for option in options)]:
            if len(names) == 1 and other not in keywords() and known.get(other) not in names:
                yield f"options.py: OTHER_NAMES does not lead from {other} to {names[0]}"


found = list(violations())
print(*found, sep="\n")
sys.exit(bool(found))
