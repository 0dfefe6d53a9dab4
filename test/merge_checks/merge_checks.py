"""The formal checks that CGAL makes before it merges a package, and one of the table of constants.

usage: merge_checks.py SOURCE_FOLDER CHECK

prints each violation, and exits with 1 if there is one.
"""

import re
import sys
from pathlib import Path

LINE_LIMIT = 400
EXAMPLE_LIMIT = 80
FIGURE_LIMIT = 200_000  # bytes
SIZE_LIMIT = 300_000  # bytes
TEXT = {".h", ".cpp", ".txt", ".cmake", ".py", ".sh", ".in", ".md", ".json"}
NOT_NAMED_AFTER_ENTITY = {"Visitor", "distortion_measures", "implementation"}  # headers of several entities
OVERLAY = "include/CGAL/STL_Extension/internal/parameters_interface.h"


def files(root, *folders):
    """all files in the folders (by default, of the project), as paths relative to root"""
    for folder in folders or ["."]:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root)
            if path.is_file() and not {".git", "build", "__pycache__"} & set(name.parts):
                yield name


def read(path):
    return path.read_text(encoding="utf-8", errors="replace")


def headers(root):
    return [name for name in files(root, "include") if name.suffix == ".h"]


def program_folders(root):
    """the folders of programs in CGAL's form, with the suffix of their project's name"""
    for kind, suffix in ("test", "Tests"), ("examples", "Examples"), ("benchmark", "Benchmark"):
        for package in "Surface_mesh_cutting", "Surface_mesh_parameterization", "BGL":
            folder = root / kind / package
            if folder.is_dir():
                yield folder, f"{package}_{suffix}"


def without_comments(cmake):
    return re.sub(r"#.*", "", cmake)


def text_files(root):
    """UTF-8, no tabs, no trailing blanks, one newline at the end"""
    for name in files(root):
        if name.suffix not in TEXT and name.parts[0] not in ("package_info", "doc"):
            continue
        if name.suffix in {".png", ".jpg"}:
            continue
        try:
            text = (root / name).read_bytes().decode()
        except UnicodeDecodeError as error:
            yield f"{name}: not UTF-8 ({error})"
            continue
        for number, line in enumerate(text.split("\n"), 1):
            if "\t" in line:
                yield f"{name}:{number}: tab"
            if line != line.rstrip():
                yield f"{name}:{number}: trailing blank"
        if not text.endswith("\n") or text.endswith("\n\n"):
            yield f"{name}: does not end with exactly one newline"


def execute_bits(root):
    """scripts, and only scripts, are executable"""
    for name in files(root):
        is_script = (root / name).read_bytes().startswith(b"#!")
        if is_script != bool((root / name).stat().st_mode & 0o111):
            yield f"{name}: wrong execute bit"


def license_headers(root):
    """copyright, version tags and license, by the package that a header belongs to"""
    for name in headers(root):
        text = read(root / name)
        lgpl = name.parts[2] in ("boost", "STL_Extension")
        license = ("LGPL" if lgpl else "GPL") + "-3.0-or-later OR LicenseRef-Commercial"
        for line in (
            "This file is part of CGAL (www.cgal.org).",
            "$URL$",
            "$Id$",
            f"SPDX-License-Identifier: {license}",
        ):
            if f"\n// {line}\n" not in text:
                yield f"{name}: no line '// {line}'"
        if not re.match(r"// Copyright \(c\) \d{4} .+\n// All rights reserved\.\n", text):
            yield f"{name}: does not start with a copyright"
        if not re.search(r"^// Author\(s\) +: .", text, re.M):
            yield f"{name}: no authors"
        if not lgpl and "internal" not in name.parts and name.parts[2] != "license":
            if f"#include <CGAL/license/{name.parts[2]}.h>" not in text:
                yield f"{name}: does not include its license"


def include_guards(root):
    """guards are named after the path"""
    for name in headers(root):
        if name.as_posix() == OVERLAY:
            continue
        path = name.relative_to("include").as_posix()
        guard = re.sub(r"[^A-Z0-9]", "_", path.upper())
        text = read(root / name)
        if f"\n#ifndef {guard}\n#define {guard}\n" not in text or not text.rstrip().endswith(
            f"#endif // {guard}"
        ):
            yield f"{name}: include guard is not {guard}"


def include_style(root):
    """includes are in angle brackets, and none leads to a package that depends on the including one"""
    upward = {
        "boost": ("CGAL/Surface_mesh_cutting/", "CGAL/Surface_mesh_parameterization/"),
        "Surface_mesh_parameterization": ("CGAL/Surface_mesh_cutting/",),
    }
    for name in headers(root):
        text = read(root / name)
        for included in re.findall(r'^#\s*include\s*"(.*)"', text, re.M):
            yield f'{name}: "{included}" is not in angle brackets'
        for included in re.findall(r"^#\s*include\s*<(.*)>", text, re.M):
            if included.startswith(upward.get(name.parts[2], ())):
                yield f"{name}: must not depend on {included}"


def unique_names(root):
    """no two paths differ only in case"""
    seen = {}
    for name in files(root):
        other = seen.setdefault(name.as_posix().lower(), name)
        if other != name:
            yield f"{name}: differs from {other} only in case"


def listed_programs(root):
    """every program is named in the CMakeLists.txt of its folder, which has CGAL's form"""
    for folder, project in program_folders(root):
        name = (folder / "CMakeLists.txt").relative_to(root)
        if not (root / name).exists():
            yield f"{name}: missing"
            continue
        cmake = without_comments(read(root / name))
        if not cmake.lstrip().startswith("cmake_minimum_required(VERSION 3.12...3.31)"):
            yield f"{name}: does not start with cmake_minimum_required(VERSION 3.12...3.31)"
        if not re.search(rf"project\(\s*{project}\s*\)", cmake):
            yield f"{name}: the project is not called {project}"
        for program in sorted(folder.glob("*.cpp")):
            if not re.search(rf"\b{program.stem}\b", cmake):
                yield f"{name}: does not name {program.name}"


def listed_examples(root):
    """every example is listed in the documentation, and every listed example exists"""
    listing = root / "doc/Surface_mesh_cutting/examples.txt"
    listed = set(re.findall(r"\\example (\S+)", read(listing)))
    existing = {
        path.relative_to(root / "examples").as_posix()
        for folder, project in program_folders(root)
        if project.endswith("_Examples")
        for path in folder.glob("*.cpp")
    }
    for name in sorted(existing - listed):
        yield f"{listing.relative_to(root)}: does not list {name}"
    for name in sorted(listed - existing):
        yield f"{listing.relative_to(root)}: lists {name}, which does not exist"


def shown_examples(root):
    """every example that the manual shows exists, is short, and each one is shown somewhere"""
    shown = set()
    for name in files(root, "doc"):
        if name.suffix == ".txt":
            shown |= set(re.findall(r"\\cgalExample\{(\S+?)\}", read(root / name)))
    listed = set(re.findall(r"\\example (\S+)", read(root / "doc/Surface_mesh_cutting/examples.txt")))
    for name in sorted(shown ^ listed):
        yield f"{name}: {'listed' if name in listed else 'shown'} in the manual only"
    for name in sorted(listed):
        lines = read(root / "examples" / name).count("\n")
        if lines > EXAMPLE_LIMIT:
            yield f"{name}: {lines} lines"


def figures(root):
    """every figure that the manual shows exists and is small, and every figure is shown"""
    folder = root / "doc/Surface_mesh_cutting/fig"
    text = "".join(read(root / name) for name in files(root, "doc") if name.suffix == ".txt")
    shown = set(re.findall(r"\\cgalFigureBegin\{\w+, *([^}]+)\}", text))
    shown |= set(re.findall(r"\\cgalPkgPicture\{([^}]+)\}", text))
    existing = {path.name for path in folder.iterdir()}
    for name in sorted(shown ^ existing):
        yield f"{name}: {'exists but is not shown' if name in existing else 'does not exist'}"
    for name in sorted(existing):
        if (folder / name).stat().st_size > FIGURE_LIMIT:
            yield f"{name}: {(folder / name).stat().st_size} bytes"


def documented_headers(root):
    """every public header of the package is documented, and the overview lists what its name says"""
    overview = read(root / "doc/Surface_mesh_cutting/PackageDescription.txt")
    for folder in "Surface_mesh_cutting", "Surface_mesh_parameterization":
        for path in sorted((root / "include/CGAL" / folder).glob("*.h")):
            name = path.relative_to(root)
            if "\\ingroup Pkg" not in read(path):
                yield f"{name}: nothing is documented"
            elif path.stem not in NOT_NAMED_AFTER_ENTITY and f"::{path.stem}" not in overview:
                yield f"{name}: PackageDescription.txt does not list {path.stem}"


def shared_parameters(root):
    """the functions that run the method, and the groups that they copy, document each named parameter once"""
    places = {}
    headers = [f"include/CGAL/Surface_mesh_cutting/{function}.h"
               for function in ("greedy_cut", "unwrap", "detect_feature_points")]
    for name in *headers, "doc/Surface_mesh_cutting/Named_parameters.txt":
        for parameter in re.findall(r"\\cgalParamNBegin\{(\w+)\}", read(root / name)):
            if parameter in places:
                yield f"{name}: {parameter} is documented in {places[parameter]}, too"
            places.setdefault(parameter, name)


def alternatives(name):
    """a/{b,c} stands for a/b and a/c"""
    found = re.search(r"\{(.*?)\}", name)
    return [name.replace(found[0], word) for word in found[1].split(",")] if found else [name]


def merge_note(root):
    """MERGING.md says where each file goes, and lists the named parameters that the package adds, and the keys that its
    manual cites"""
    note, overlay = read(root / "MERGING.md"), read(root / OVERLAY)
    table = re.search(r"## What moves where\n\n((\|.*\n)+)", note)[1]
    cells = " ".join(row.split("|")[1] for row in table.splitlines())
    places = {Path(name) for written in re.findall(r"`(.*?)`", cells) for name in alternatives(written)}
    for place in sorted(places):
        if not (root / place).exists():
            yield f"MERGING.md: {place} does not exist"
    for name in files(root):
        if not places & {name, *name.parents}:
            yield f"MERGING.md: does not say where {name} goes"
    own = overlay.split("#if CGAL_VERSION_NR")[0]
    for line in re.findall(r"^CGAL_add_named_parameter.*$", own, re.M):
        if line not in note:
            yield f"MERGING.md: no line '{line}'"
    text = "".join(read(root / name) for name in (*files(root, "doc"), *files(root, "include"))
                   if name.suffix in (".txt", ".h"))
    for key in sorted(set(re.findall(r"\\cgalCite\{([^}]+)\}", text))):
        if key not in note:
            yield f"MERGING.md: no bibliography entry {key}"
        if f"[{key}]" not in read(root / "doc/bibliography.txt"):
            yield f"doc/bibliography.txt: no {key}"


def file_lengths(root):
    """files are small; long_files.txt names the exceptions, each with its reason"""
    allowed = {}
    for line in read(root / "test/merge_checks/long_files.txt").splitlines():
        if line and not line.startswith("#"):
            name, _, reason = line.partition(" ")
            allowed[name] = reason.strip()
    for name, reason in allowed.items():
        if not reason or not (root / name).exists():
            yield f"long_files.txt: {name} needs a reason, and to exist"
    for name in files(root):
        content = (root / name).read_bytes()
        if name.as_posix() in allowed:
            continue
        if len(content) > SIZE_LIMIT:
            yield f"{name}: {len(content)} bytes"
        if name.suffix in TEXT and content.count(b"\n") > LINE_LIMIT:
            yield f"{name}: {content.count(bytes([10]))} lines"


def absolute_paths(root):
    """no path of a particular machine"""
    pattern = re.compile(r"""(?<![\w.$})/-])/(home|root|work|tmp|mnt|opt|Users)/\w""")
    for name in files(root):
        if name.suffix not in TEXT and name.suffix != "":
            continue
        for number, line in enumerate(read(root / name).splitlines(), 1):
            if pattern.search(line):
                yield f"{name}:{number}: {line.strip()}"


def package_info(root):
    """all files of package_info are there, and dependencies are sorted"""
    folder = root / "package_info/Surface_mesh_cutting"
    for file in (
        "copyright",
        "dependencies",
        "description.txt",
        "license.txt",
        "long_description.txt",
        "maintainer",
    ):
        if not (folder / file).is_file() or not read(folder / file).strip():
            yield f"package_info: {file} is missing or empty"
    for file in *root.glob("package_info/*/dependencies"), root / "doc/Surface_mesh_cutting/dependencies":
        lines = read(file).splitlines()
        if len(lines) != len(set(lines)):
            yield f"{file.relative_to(root)}: names a package twice"


def tuned_constants(root):
    """each row of the table of constants marks a piece of code that occurs once"""
    folder = root / "benchmark/constants"
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(folder))
    import varied_headers  # of the project that is checked
    names = set()
    for row in varied_headers.read_constants(folder / "constants.csv"):
        try:
            varied_headers.place(row, read(root / "include/CGAL" / row["file"]))
        except SystemExit as problem:
            yield str(problem)
        if row["constant"] in names:
            yield f"benchmark/constants/constants.csv: {row['constant']}: another constant has this name"
        names.add(row["constant"])


CHECKS = [
    text_files,
    execute_bits,
    license_headers,
    include_guards,
    include_style,
    unique_names,
    listed_programs,
    listed_examples,
    shown_examples,
    figures,
    shared_parameters,
    merge_note,
    documented_headers,
    file_lengths,
    absolute_paths,
    package_info,
    tuned_constants,
]


def main():
    checks = {check.__name__: check for check in CHECKS}
    if len(sys.argv) != 3 or sys.argv[2] not in checks:
        sys.exit(__doc__ + "\nchecks: " + " ".join(checks))
    problems = list(checks[sys.argv[2]](Path(sys.argv[1])))
    for problem in problems:
        print(problem)
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()
