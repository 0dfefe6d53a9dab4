"""Meshes with known defects. They are no part of the project: the test is skipped without them."""

import sys

from support import Case, MESH_DIR, main

EXIT_CODES = {
    # cannot be read
    "bad_empty.obj": 3,            # zero bytes
    "bad_index.off": 3,            # index out of range
    "bad_truncated.off": 3,
    # cannot be unwrapped as they are
    "bad_empty_off.off": 4,        # neither points nor faces
    "bad_dup_face.off": 4,
    "bad_fin_face.off": 4,         # an edge with three faces
    "bad_nm_edge.off": 4,          # edges with four faces
    "bad_two_sided.obj": 4,        # an edge with four faces
    "bad_touch_vertex.obj": 4,     # a vertex with two fans
    "bad_inf.off": 4,
    "bad_nan.off": 4,
    "bad_klein.off": 4,            # not orientable
    "bad_mobius.off": 4,           # not orientable
    "bad_mixed_orient.off": 4,
    "bad_pentagons.obj": 4,
    "bad_quads.obj": 4,
    "bad_repeated_index.off": 4,
    # valid
    "bad_dup_vertices.off": 0,     # two open halves
    "bad_one_tri.off": 0,          # a disk
    "bad_soup.off": 0,             # every face is a component
    "bad_degenerate.off": 0,       # a face without area
    "bad_inside_out.off": 0,
    "bad_isolated.off": 0,         # vertices without faces
    "bad_selfint.obj": 0,          # intersects itself
    "bad_tetra.off": 0,            # the smallest closed mesh
    "bad_zero_edge.off": 0,        # two neighbors at one place
}


class Bad_meshes(Case):
    def test_all_are_listed(self):
        self.assertEqual(sorted(path.name for path in MESH_DIR.glob("bad_*")), sorted(EXIT_CODES))

    def test_exit_codes(self):
        for name, expected in EXIT_CODES.items():
            with self.subTest(name=name):
                exit_code, report = self.report(MESH_DIR / name, "-o", "out.obj")
                self.assertEqual(exit_code, expected, report["message"])
                self.assertEqual(self.files(), ["out.obj"] if expected == 0 else [])
                (self.folder / "out.obj").unlink(missing_ok=True)


if not (MESH_DIR / "MANIFEST.csv").is_file():
    print("SURFACE_MESH_CUTTING_MESH_DIR is not the folder of these meshes")
    sys.exit(77)
main()
