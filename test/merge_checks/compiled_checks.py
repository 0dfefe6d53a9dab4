"""The formal checks that need a compiler.

usage: compiled_checks.py SOURCE_FOLDER CHECK COMPILER [OPTION...]

named_parameters       each documented named parameter compiles
package_dependencies   each package_info/.../dependencies is what the headers of the package include
write_dependencies     writes these files
varied_constants       the headers compile whose tuned constants are not constant expressions
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path


def compile_source(source, command, *options):
    return subprocess.run(
        [*command, "-std=c++17", *options, "-x", "c++", "-"],
        input=source, text=True, stdout=subprocess.PIPE, check=True,
    ).stdout


def named_parameters(root, command):
    names = set()
    for path in sorted([*root.glob("include/**/*.h"), *root.glob("doc/**/*.[ht]*")]):
        names |= set(re.findall(r"\\cgalParamNBegin\{(\w+)\}", path.read_text(errors="replace")))
    source = "#include <CGAL/Named_function_parameters.h>\nint main()\n{\n  int a = 0;\n"
    for name in sorted(names):
        source += f"  (void)CGAL::parameters::{name}(a).{name}(a);\n"
    compile_source(source + "}\n", command, "-fsyntax-only")
    print("checked:", *sorted(names))


def package_of(root, header):
    """the CGAL package that a header belongs to, from its place or from its $URL$ line"""
    if (root / "include") in header.parents:
        folder = header.relative_to(root / "include/CGAL").parts[0]
        return {"boost": "BGL", "license": "Installation"}.get(folder, folder)
    url = re.search(r"\$URL: \S*/blob/[^/]+/(\w+)/include/", header.read_text(errors="replace"))
    return url.group(1) if url else "Installation"


def computed_dependencies(root, command):
    """for each file of dependencies, what it has to hold"""
    for folder in "Surface_mesh_cutting", "Surface_mesh_parameterization", "boost/graph":
        own = sorted((root / "include/CGAL" / folder).rglob("*.h"))
        source = "".join(f"#include <{path.relative_to(root / 'include')}>\n" for path in own)
        words = compile_source(source, command, "-M").replace("\\\n", " ")
        included = re.findall(r"((?:\\ |\S)+)", words)[1:]
        included = {Path(name.replace("\\ ", " ")).resolve() for name in included}
        packages = sorted({package_of(root, path) for path in included if "CGAL" in path.parts})
        yield root / "package_info" / package_of(root, own[0]) / "dependencies", "\n".join(packages) + "\n"


def package_dependencies(root, command):
    wrong = [file for file, computed in computed_dependencies(root, command) if file.read_text() != computed]
    if wrong:
        sys.exit(f"{', '.join(map(str, wrong))}: not the sorted list, run the target write_dependencies")


def write_dependencies(root, command):
    for file, computed in computed_dependencies(root, command):
        file.write_text(computed)


def varied_constants(root, command):
    folder = root / "benchmark/constants"
    sys.path.insert(0, str(folder))
    import varied_headers  # of the project that is checked

    constants = varied_headers.read_constants(folder / "constants.csv")
    headers = sorted({row["file"] for row in constants if row["file"].endswith(".h")})
    source = "".join(f"#include <CGAL/{header}>\n" for header in headers)
    with tempfile.TemporaryDirectory() as varied:
        varied_headers.write_varied_headers(root / "include", Path(varied), constants)
        compile_source(source, [command[0], f"-I{varied}", *command[1:]], "-fsyntax-only")
    print("checked:", *headers)


def main():
    checks = {
        check.__name__: check
        for check in (named_parameters, package_dependencies, write_dependencies, varied_constants)
    }
    if len(sys.argv) < 4 or sys.argv[2] not in checks:
        sys.exit(__doc__)
    try:
        checks[sys.argv[2]](Path(sys.argv[1]).resolve(), sys.argv[3:])
    except subprocess.CalledProcessError as error:
        sys.exit(f"{sys.argv[2]}: the compiler failed with {error.returncode}")


if __name__ == "__main__":
    main()
