"""Results of unwrap(), greedy_cut() and detect_feature_points(): the bytes of the program, and what is known."""

import json
import subprocess
import time

import numpy as np
import pytest

import meshes
import surface_mesh_cutting as smc


def write_obj(path, points, faces):
    lines = ["v " + " ".join(map(repr, map(float, p))) for p in points]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def run_program(program, folder, points, faces, *options):
    """The UVs, their indices and the report of the program."""
    write_obj(folder / "mesh.obj", points, faces)
    subprocess.run([program, "mesh.obj", "-o", "out.obj", "--json", "out.json", "--quiet", *options],
                   cwd=folder, check=True, timeout=120)
    lines = [line.split() for line in (folder / "out.obj").read_text().splitlines()]
    uv = np.array([line[1:] for line in lines if line[0] == "vt"], float)
    uv_faces = np.array([[int(word.split("/")[1]) - 1 for word in line[1:]] for line in lines if line[0] == "f"])
    return uv, uv_faces, json.loads((folder / "out.json").read_text())


CASES = [("default", {}, []), ("fast on the surface's scale", dict(effort="fast", uv_scale="surface"),
                               ["--effort", "fast", "--uv-scale", "surface"]),
         ("bound", dict(maximum_average_distortion=4.05, seed=3), ["--max-distortion", "4.05", "--seed", "3"]),
         ("faithful", dict(faithful=True), ["--faithful"]),
         ("margin", dict(margin=8, texture_size=256, bijective=False),
          ["--margin", "8", "--texture-size", "256", "--allow-overlap"]),
         ("quarter turns", dict(rotate="quarter", effort="fast"), ["--rotate", "quarter", "--effort", "fast"])]


@pytest.mark.parametrize("name, options, words", CASES, ids=[case[0] for case in CASES])
@pytest.mark.parametrize("make_mesh", [lambda: meshes.sphere(3), meshes.torus_of_quads], ids=["sphere", "torus"])
def test_same_bytes_as_the_program(program, tmp_path, make_mesh, name, options, words):
    points, faces = make_mesh()
    uv, uv_faces, report = run_program(program, tmp_path, points, faces, *words)
    result = smc.unwrap(points, faces, **options)
    assert result.corner_uv.tobytes() == uv[uv_faces].tobytes()
    assert len(result.uv) == len(uv)
    assert result.average_distortion == report["E_iso"]
    assert result.largest_face_distortion == report["E_max"]
    assert list(result.distortion_quantiles.values()) == list(report["E_quantiles"].values())
    assert result.charts_distortion == report["charts_distortion"]
    assert result.cut_length / result.bounding_box_diagonal == report["cut_length"]
    assert (result.uv_scale, result.fill, result.number_of_charts) == (report["uv_scale"], report["fill"], report["charts"])
    assert len(result.feature_points) == report["features"]
    diagonal = result.bounding_box_diagonal
    cuts = {(t[0] / diagonal, t[2]) for t in result.trade_offs}
    assert {tuple(cut) for cut in report["tradeoff"]} <= cuts


def check_valid(points, faces, result):
    """Against the certificate, the points, and topology found without the library."""
    assert result.status == "ok" and not result.stopped
    assert np.array_equal(result.uv_points[result.uv_faces], faces)
    assert meshes.disks_of(faces, result.cut_edges) == [1] * result.number_of_charts
    lengths = np.linalg.norm(points[result.cut_edges[:, 0]] - points[result.cut_edges[:, 1]], axis=1)
    assert result.cut_length == pytest.approx(lengths.sum(), rel=1e-12)
    assert smc.certify_unwrap(points, faces, result.corner_uv)
    assert result.uv.min() > 0 and result.uv.max() < 1


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads(threads):
    points, faces = meshes.sphere(4)
    result = smc.unwrap(points, faces, threads=threads)
    check_valid(points, faces, result)
    reference = smc.unwrap(points, faces, threads=3)
    assert result.uv.tobytes() == reference.uv.tobytes()
    assert np.array_equal(result.cut_edges, reference.cut_edges)


def test_several_threads_of_python():
    from concurrent.futures import ThreadPoolExecutor

    points, faces = meshes.sphere(3)
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda seed: smc.unwrap(points, faces, seed=seed % 2), range(8)))
    for seed, result in enumerate(results):
        assert result.uv.tobytes() == smc.unwrap(points, faces, seed=seed % 2).uv.tobytes()


def test_polygons():
    points, faces = meshes.torus_of_quads()
    result = smc.unwrap(points, faces)
    check_valid(points, faces, result)
    assert (result.components, result.genus, result.borders) == (1, 1, 0)
    flat = smc.unwrap(points, faces.ravel(), np.arange(0, faces.size + 1, 4))
    assert flat.uv_faces.shape == (faces.size,)
    assert flat.corner_uv.tobytes() == result.corner_uv.tobytes()

    points, corners, offsets = meshes.prism(7)
    result = smc.unwrap(points, corners, offsets)
    assert result.uv_faces.shape == corners.shape
    assert np.array_equal(result.uv_points[result.uv_faces], corners)
    assert smc.certify_unwrap(points, corners, result.corner_uv, offsets)
    with pytest.raises(smc.InputError) as caught:
        smc.unwrap(points, corners, offsets, strict=True)
    assert caught.value.status == "not_triangulated"
    assert np.array_equal(caught.value.elements, np.arange(9))


def test_types_of_arrays():
    points, faces = meshes.sphere(2)
    points = points.astype(np.float32).astype(float)
    expected = smc.unwrap(points, faces).uv.tobytes()
    for other in (points.astype(np.float32), np.asfortranarray(points), points[::-1][::-1], points.tolist()):
        assert smc.unwrap(other, faces).uv.tobytes() == expected
    for other in (faces.astype(np.int32), faces.astype(np.uint16), np.asfortranarray(faces), faces.tolist()):
        assert smc.unwrap(points, other).uv.tobytes() == expected
    result = smc.unwrap(points, faces)
    assert result.uv.dtype == np.float64 and result.uv_faces.dtype == np.int64 and result.cut_edges.dtype == np.int64
    assert result.uv.flags.writeable and result.uv.flags.c_contiguous


def test_arguments_stay():
    points, faces = meshes.sphere(2)
    before = points.tobytes(), faces.tobytes()
    points.flags.writeable = faces.flags.writeable = False
    smc.unwrap(points, faces)
    assert before == (points.tobytes(), faces.tobytes())


def test_interpreted():
    points, faces = meshes.sphere(2)
    turned = faces.copy()
    turned[5] = turned[5, ::-1]
    doubled = np.concatenate([turned, faces[7:8], [[3, 3, 4]]])
    result = smc.unwrap(points, doubled)
    found = {reading.what: reading.elements.tolist() for reading in result.interpreted}
    assert found == {"reoriented_faces": [5], "duplicate_faces": [len(faces)], "degenerate_faces": [len(faces) + 1]}
    with pytest.raises(smc.InputError):
        smc.unwrap(points, doubled, strict=True)
    assert smc.certify_unwrap(points, doubled, result.corner_uv)

    soup = points[faces].reshape(-1, 3)  # each face has points of its own
    alone = np.arange(faces.size).reshape(faces.shape)
    welded = smc.unwrap(soup, alone)
    assert welded.components == 1 and welded.interpreted[0].what == "welded_vertices"
    assert smc.greedy_cut(soup, alone, weld="off").components == len(faces)
    nearly_alone = alone.copy()
    neighbor = next(i for i in range(1, len(faces)) if faces[0, 0] in faces[i])
    nearly_alone[neighbor, list(faces[neighbor]).index(faces[0, 0])] = 0
    assert smc.greedy_cut(soup, nearly_alone).components == 1
    # Any of the points at one place names it.
    first = [int(np.flatnonzero((soup == point).all(axis=1))[0]) for point in soup[alone[0, :2]]]
    last = [int(np.flatnonzero((soup == point).all(axis=1))[-1]) for point in soup[alone[0, :2]]]
    assert first != last
    result = smc.greedy_cut(soup, alone, mandatory_edges=[last])
    assert sorted(first) in result.cut_edges.tolist()


def test_constraints():
    points, faces = meshes.sphere(3)
    free = smc.greedy_cut(points, faces)
    everything = meshes.edges(faces)
    never = free.cut_edges[::2]
    must = everything[[10, 200]]
    result = smc.unwrap(points, faces, mandatory_edges=must[:, ::-1], forbidden_edges=never, terminals=[17, 30])
    cut = set(map(tuple, result.cut_edges.tolist()))
    assert cut >= set(map(tuple, must.tolist()))
    assert not cut & set(map(tuple, never.tolist()))
    assert {17, 30} <= set(result.cut_edges.ravel().tolist())
    check_valid(points, faces, result)

    # What is expensive is avoided, and what the cut costs is the sum of the weights.
    weights = np.where(points[everything].mean(axis=1)[:, 0] > 0, 100.0, 1.0)
    result = smc.greedy_cut(points, faces, edge_weights=(everything, weights))
    weight_of = dict(zip(map(tuple, everything.tolist()), weights))
    costs = [weight_of[edge] for edge in map(tuple, result.cut_edges.tolist())]
    assert result.cut_cost == pytest.approx(sum(costs), rel=1e-12)
    assert sum(cost > 1 for cost in costs) < len(costs) / 4
    some = smc.greedy_cut(points, faces, edge_weights=(everything[:50], np.full(50, np.inf)))
    assert not set(map(tuple, everything[:50].tolist())) & set(map(tuple, some.cut_edges.tolist()))

    seams = smc.unwrap(points, faces, initial_cut=free.cut_edges)
    check_valid(points, faces, seams)


def test_bound_not_reached():
    points, faces = meshes.sphere(2)
    # Only the edges around one vertex may be cut.
    edges = sorted({tuple(sorted((f[i], f[i - 1]))) for f in np.asarray(faces).tolist() for i in range(3)})
    forbidden = [edge for edge in edges if 0 not in edge]
    result = smc.unwrap(points, faces, maximum_average_distortion=4.01, forbidden_edges=forbidden)
    assert result.status == "bound_not_reached" and result.message
    assert smc.certify_unwrap(points, faces, result.corner_uv)


def test_seconds_of_packing():
    """Most of the time of many charts."""
    points, faces = meshes.sphere(2)
    alone = np.arange(faces.size).reshape(faces.shape)
    start = time.monotonic()
    result = smc.unwrap(points[faces].reshape(-1, 3), alone, weld="off", effort="fast")
    elapsed = time.monotonic() - start
    assert result.number_of_charts == len(faces)
    assert elapsed / 2 < result.seconds["packing"] <= result.seconds["total"] <= elapsed
    assert smc.unwrap(points, faces, uv_scale="surface").seconds["packing"] == 0


def test_features_and_cut():
    points, faces = meshes.sphere(3)
    cut = smc.greedy_cut(points, faces)
    assert meshes.disks_of(faces, cut.cut_edges) == [1]
    features = smc.detect_feature_points(points, faces)
    assert features.number_of_candidates > 0 and len(features.feature_points) > 0
    connected = smc.connect_points(points, faces, features.feature_points)
    assert set(features.feature_points.tolist()) <= set(connected.cut_edges.ravel().tolist())
    assert set(cut.feature_points.tolist()) <= set(cut.cut_edges.ravel().tolist())
    assert set(features.seconds) == {"candidates", "filter", "connect", "refine", "parameterize", "packing", "total"}
    assert np.array_equal(cut.cut_edges, np.unique(np.sort(cut.cut_edges, axis=1), axis=0))
