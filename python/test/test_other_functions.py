"""Connections, handles, charts, certificates and Steiner trees, against what is known or found by brute force."""

import doctest
import itertools

import numpy as np
import pytest

import meshes
import surface_mesh_cutting as smc


def test_documentation():
    assert doctest.testmod(smc).failed == 0
    for name in smc.__all__:
        assert getattr(smc, name).__doc__


def test_connect_points():
    points, faces = meshes.sphere(3)
    result = smc.connect_points(points, faces, [0, 1])
    assert result.is_optimal and result.lower_bound == pytest.approx(result.cut_length)
    assert meshes.disks_of(faces, result.cut_edges) == [1]
    edges = meshes.edges(faces)
    weights = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    terminals = [0, 1, 2, 40, 77]
    tree = smc.steiner_tree(edges, weights, terminals)
    result = smc.connect_points(points, faces, terminals)
    assert result.cut_length == pytest.approx(tree.length, rel=1e-9) and tree.is_optimal
    for heuristic in ("metric_closure", "shortest_path_heuristic", "greedy"):
        longer = smc.connect_points(points, faces, terminals, connection=heuristic)
        assert longer.cut_length >= result.cut_length * (1 - 1e-9)
    with pytest.raises(smc.InputError):
        smc.connect_points(points, faces, [])
    with pytest.raises(smc.InputError, match="no point 9999"):
        smc.connect_points(points, faces, [9999])
    with pytest.raises(ValueError, match="terminals"):
        smc.connect_points(points, faces, [[1], [2]])


def test_symmetric_layout():
    points = np.array([[1, 0, 0], [3, 0, 0], [2, 2, 0], [-1, 0, 0], [-3, 0, 0], [-2, 2, 0]], dtype=float)
    points[2::3, 1] += [0.5, 0.5]
    faces = np.array([[0, 1, 2], [4, 3, 5]])
    turns = [np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) for a in (1, 3)]
    uv = np.array([points[face, :2] @ turn for face, turn in zip(faces, turns)])
    packed = smc.pack_charts(points, faces, uv, symmetry="x", rotate="upright").corner_uv
    right, left = packed[0], packed[1][[1, 0, 2]]
    assert np.ptp(right[:, 0] + left[:, 0]) < 1e-12 and np.abs(right[:, 1] - left[:, 1]).max() < 1e-12
    with pytest.raises(ValueError, match="symmetry"):
        smc.pack_charts(points, faces, uv, symmetry="w")


def test_cut_handles():
    points, faces = meshes.torus_of_quads(24, 8)
    result = smc.cut_handles(points, faces)
    assert len(result.loops) == 1 and len(result.loops[0]) == 8  # around the tube
    loop = result.loops[0]
    edges = {tuple(sorted(pair)) for pair in zip(loop.tolist(), np.roll(loop, -1).tolist())}
    assert edges == set(map(tuple, result.cut_edges.tolist()))
    assert result.cut_length == pytest.approx(
        np.linalg.norm(points[loop] - points[np.roll(loop, -1)], axis=1).sum())
    assert meshes.disks_of(faces, result.cut_edges) == [0]  # a tube
    assert smc.cut_handles(*meshes.sphere(2)).loops == ()
    with pytest.raises(smc.InputError) as caught:
        smc.cut_handles(points, faces, forbidden_edges=meshes.edges(faces))
    assert caught.value.status == "infeasible_constraints"


def test_certificates():
    points, faces = meshes.sphere(3)
    result = smc.unwrap(points, faces)
    good = smc.certify_unwrap(points, faces, result.corner_uv)
    assert good and good.finding.status == "ok"
    flipped = smc.certify_unwrap(points, faces, result.corner_uv * [-1, 1])
    assert not flipped and flipped.finding.status == "not_certified"
    assert len(flipped.finding.elements) == len(faces)
    inside = int(np.flatnonzero(~np.isin(faces, result.cut_edges).any(axis=1))[0])  # a face away from the cut
    moved = result.corner_uv.copy()
    moved[inside] += 10  # a ring remains
    assert smc.certify_unwrap(points, faces, moved).finding.status == "not_cut_to_disks"
    moved = result.corner_uv.copy()
    moved[inside] = moved[inside, ::-1]
    assert not smc.certify_unwrap(points, faces, moved)
    moved[inside] = np.nan
    assert not smc.certify_unwrap(points, faces, moved)
    for wrong in (result.corner_uv[:-1], result.corner_uv.reshape(-1, 2), result.uv):
        with pytest.raises(ValueError, match="corner_uv must have shape"):
            smc.certify_unwrap(points, faces, wrong)
    doubled = np.concatenate([points, points + 10])
    twice = np.concatenate([faces, faces + len(points)])
    overlapping = np.concatenate([result.corner_uv, result.corner_uv])
    assert not smc.certify_unwrap(doubled, twice, overlapping)
    assert smc.certify_unwrap(doubled, twice, overlapping, bijective=False)


def test_pages():
    points, faces = meshes.sphere(2)
    flat = smc.unwrap(points, faces, uv_scale="surface")
    assert flat.page_fills == ()
    many = np.concatenate([points + [5 * i, 0, 0] for i in range(3)])
    all_faces = np.concatenate([faces + i * len(points) for i in range(3)])
    uv = np.concatenate([flat.corner_uv] * 3)
    side = np.ptp(flat.uv, axis=0).max()
    packed = smc.pack_charts(many, all_faces, uv, texels_per_unit=1000 / (1.1 * side))
    assert packed.scale * 1024 == pytest.approx(1000 / (1.1 * side), rel=1e-5)
    assert len(packed.page_fills) == 3 and sum(packed.page_fills) == pytest.approx(3 * packed.fill)
    assert sorted({tuple(tile) for tile in np.floor(packed.corner_uv.mean(axis=1))}) == [(0, 0), (1, 0), (2, 0)]
    assert smc.pack_charts(many, all_faces, uv, pages=3).scale > smc.pack_charts(many, all_faces, uv).scale
    with pytest.raises(smc.InputError):
        smc.pack_charts(many, all_faces, uv, texels_per_unit=1000 / (1.1 * side), pages=2)
    for wrong in {"pages": 0}, {"texels_per_unit": 0}, {"texels_per_unit": float("nan")}:
        with pytest.raises(ValueError):
            smc.pack_charts(many, all_faces, uv, **wrong)
    assert len(smc.unwrap(many, all_faces, pages=2).page_fills) == 2


def test_pack_charts():
    points, faces = meshes.sphere(2)
    flat = smc.unwrap(points, faces, uv_scale="surface")
    packed = smc.pack_charts(points, faces, flat.corner_uv)
    together = smc.unwrap(points, faces)
    assert packed.corner_uv.tobytes() == together.corner_uv.tobytes()
    assert (packed.scale, packed.fill) == (together.uv_scale, together.fill)
    sides = np.linalg.norm(flat.corner_uv - np.roll(flat.corner_uv, 1, axis=1), axis=-1)
    scaled = np.linalg.norm(packed.corner_uv - np.roll(packed.corner_uv, 1, axis=1), axis=-1)
    assert scaled == pytest.approx(sides * packed.scale, rel=1e-6)

    count = 40
    many = np.concatenate([points + [4 * i, 0, 0] for i in range(count)])
    all_faces = np.concatenate([faces + len(points) * i for i in range(count)])
    uv = np.concatenate([flat.corner_uv] * count)
    packed = smc.pack_charts(many, all_faces, uv, margin=4, texture_size=512)
    assert packed.number_of_charts == count
    assert smc.certify_unwrap(many, all_faces, packed.corner_uv)
    for chart in packed.corner_uv.reshape(count, -1, 2):
        assert chart.min() >= 4 / 512 and chart.max() <= 1 - 4 / 512
    with pytest.raises(smc.ComputationError) as caught:
        smc.pack_charts(many, all_faces, -uv * [1, -1])
    assert caught.value.status == "not_certified" and len(caught.value.elements) > 0
    with pytest.raises(smc.InputError, match="margin"):
        smc.pack_charts(points, faces, flat.corner_uv, margin=-1)
    fast, best = (smc.pack_charts(points, faces, flat.corner_uv, effort=effort) for effort in ("fast", "best"))
    assert 0 < fast.fill < 1.1 * best.fill
    with pytest.raises(ValueError, match="effort"):
        smc.pack_charts(many, all_faces, uv, effort="most")
    with pytest.raises(ValueError, match="rotate"):
        smc.pack_charts(points, faces, flat.corner_uv, rotate="quarters")
    kept = smc.pack_charts(points, faces, flat.corner_uv, rotate="none")
    shift = kept.corner_uv - kept.scale * flat.corner_uv  # the same everywhere
    assert np.ptp(shift.reshape(-1, 2), axis=0) == pytest.approx([0, 0], abs=1e-12)


def shortest_by_brute_force(number, edges, weights, terminals):
    """Over all subsets of vertices: the spanning tree of what they induce."""
    others = [v for v in range(number) if v not in terminals]
    best = np.inf
    order = np.argsort(weights)
    for count in range(len(others) + 1):
        for extra in itertools.combinations(others, count):
            inside = set(terminals) | set(extra)
            parent = {v: v for v in inside}

            def find(v):
                while parent[v] != v:
                    v = parent[v]
                return v

            length, joined = 0.0, 1
            for e in order:
                a, b = edges[e]
                if a in inside and b in inside and find(a) != find(b):
                    parent[find(a)] = find(b)
                    length += weights[e]
                    joined += 1
            if joined == len(inside):
                best = min(best, length)
    return best


def test_steiner_trees():
    seed = 20261122
    print("seed", seed)
    random = np.random.default_rng(seed)
    for _ in range(30):
        number = int(random.integers(4, 10))
        edges = random.integers(0, number, (3 * number, 2))
        weights = random.random(len(edges))
        terminals = random.choice(number, 4, replace=False).tolist()
        expected = shortest_by_brute_force(number, edges, weights, terminals)
        if np.isinf(expected):
            with pytest.raises(smc.InputError) as caught:
                smc.steiner_tree(edges, weights, terminals)
            assert caught.value.status == "terminals_not_connected"
            continue
        for method in ("best", "exact", "local_search", "greedy", "shortest_path_heuristic", "metric_closure"):
            tree = smc.steiner_tree(edges, weights, terminals, method=method)
            assert tree.length == pytest.approx(weights[tree.edges].sum())
            assert tree.length >= expected - 1e-12
        assert smc.steiner_tree(edges, weights, terminals, method="exact").length == pytest.approx(expected)


def test_arguments_of_steiner_trees():
    path = [[0, 1], [1, 2]]
    assert smc.steiner_tree(path, [1, 2], [0, 2]).edges.tolist() == [0, 1]
    assert smc.steiner_tree(path, [1, 2], [1]).edges.tolist() == []
    assert smc.steiner_tree([], [], []).length == 0
    for weights in ([1, -1], [1, np.nan], [1, np.inf]):
        with pytest.raises(smc.InputError) as caught:
            smc.steiner_tree(path, weights, [0, 2])
        assert caught.value.elements.tolist() == [1]
    with pytest.raises(smc.InputError, match="does not exist"):
        smc.steiner_tree(path, [1, 2], [0], number_of_vertices=2)
    for terminals in ([-1], [5]):
        with pytest.raises(ValueError, match="terminals"):
            smc.steiner_tree(path, [1, 2], terminals, number_of_vertices=3)
    with pytest.raises(ValueError, match="weights"):
        smc.steiner_tree(path, [1], [0, 2])
    with pytest.raises(ValueError, match="method"):
        smc.steiner_tree(path, [1, 2], [0, 2], method="guess")
    with pytest.raises(ValueError, match="too large"):
        smc.steiner_tree([[0, 2**31]], [1], [0])
