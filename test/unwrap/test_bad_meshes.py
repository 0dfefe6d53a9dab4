"""Meshes with known defects. They are no part of the project: the test is skipped without them."""

import sys

from support import Case, MESH_DIR, main

# What is read by interpretation has the exit status 4 with --strict.
EXIT_CODES = {
    # cannot be read
    "bad_empty.obj": 3,            # zero bytes
    "bad_index.off": 3,            # index out of range
    "bad_truncated.off": 3,
    # cannot be unwrapped
    "bad_empty_off.off": 4,        # neither points nor faces
    "bad_inf.off": 4,
    "bad_nan.off": 4,
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
# What is read by interpretation, and as what.
INTERPRETED = {
    "bad_dup_face.off": {"duplicate_faces": 1},
    "bad_fin_face.off": {"non_manifold_edges": 1},
    "bad_nm_edge.off": {"non_manifold_edges": 3},
    "bad_two_sided.obj": {"non_manifold_edges": 1},
    "bad_touch_vertex.obj": {"non_manifold_vertices": 1},
    "bad_klein.off": {"reoriented_faces": None, "non_orientable_edges": None},
    "bad_mobius.off": {"reoriented_faces": None, "non_orientable_edges": None},
    "bad_mixed_orient.off": {"reoriented_faces": None},
    "bad_pentagons.obj": {},
    "bad_quads.obj": {},
    "bad_repeated_index.off": {"degenerate_faces": 1},
    "bad_soup.off": {"welded_vertices": None},
}


class Bad_meshes(Case):
    def test_all_are_listed(self):
        self.assertEqual(sorted(path.name for path in MESH_DIR.glob("bad_*")), sorted({*EXIT_CODES, *INTERPRETED}))

    def test_exit_codes(self):
        for name, expected in EXIT_CODES.items():
            with self.subTest(name=name):
                exit_code, report = self.report(MESH_DIR / name, "-o", "out.obj")
                self.assertEqual(exit_code, expected, report["message"])
                self.assertEqual(self.files(), ["out.obj"] if expected == 0 else [])
                (self.folder / "out.obj").unlink(missing_ok=True)

    def test_interpretation(self):
        for name, expected in INTERPRETED.items():
            with self.subTest(name=name):
                exit_code, report = self.report(MESH_DIR / name, "-o", "out.obj")
                self.assertEqual(exit_code, 0, report["message"])
                counts = {finding["what"]: finding["count"] for finding in report["interpreted"]}
                self.assertEqual(sorted(counts), sorted(expected))
                for what, count in expected.items():
                    self.assertIn(count, (None, counts[what]))
                (self.folder / "out.obj").unlink()
                self.assertEqual(self.report(MESH_DIR / name, "--strict", "-o", "out.obj")[0], EXIT_CODES.get(name, 4))
                (self.folder / "out.obj").unlink(missing_ok=True)


if not (MESH_DIR / "MANIFEST.csv").is_file():
    print("SURFACE_MESH_CUTTING_MESH_DIR is not the folder of these meshes")
    sys.exit(77)
main()
