"""Results and exceptions that go from one process to another."""

import copy
import dataclasses
import inspect
import multiprocessing
import pickle
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

import meshes
import surface_mesh_cutting as smc

POINTS, FACES = meshes.sphere(1)
BROKEN = np.where(np.arange(len(POINTS))[:, None] == 3, np.nan, POINTS)
COPIES = [copy.copy, copy.deepcopy,
          *(lambda value, protocol=protocol: pickle.loads(pickle.dumps(value, protocol))
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1))]


def assert_same(one, other):
    assert type(one) is type(other)
    if isinstance(one, np.ndarray):
        assert one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    elif dataclasses.is_dataclass(one):
        for field in dataclasses.fields(one):
            assert_same(getattr(one, field.name), getattr(other, field.name))
    elif isinstance(one, tuple):
        assert len(one) == len(other)
        for pair in zip(one, other):
            assert_same(*pair)
    else:
        assert one == other


def results():
    """One of each class that the functions return, and of those inside."""
    cut = smc.unwrap(POINTS, np.concatenate([FACES, FACES[:1]]))  # with a face that is there twice
    yield cut
    yield from cut.interpreted
    yield smc.greedy_cut(np.concatenate([POINTS, [[9, 9, 9]]]), FACES).warnings[0]
    yield smc.greedy_cut(POINTS, FACES)
    yield smc.detect_feature_points(POINTS, FACES)
    yield smc.connect_points(POINTS, FACES, [0, 1])
    yield smc.cut_handles(*meshes.torus_of_quads())
    yield smc.pack_charts(POINTS, FACES, cut.corner_uv[:-1])
    yield smc.certify_unwrap(POINTS, FACES, cut.corner_uv[:-1])
    yield smc.steiner_tree([[0, 1], [1, 2]], [1.0, 2.0], [0, 2])


def test_results():
    seen = set()
    for result in results():
        seen.add(type(result))
        for make_copy in COPIES:
            assert_same(make_copy(result), result)
    bases = {smc.Result, smc.SurfaceResult}
    assert seen | bases == {each for each in vars(smc).values() if inspect.isclass(each) and dataclasses.is_dataclass(each)}


@pytest.mark.parametrize("kind", [smc.InputError, smc.ComputationError, smc.StoppedError, smc.Error])
@pytest.mark.parametrize("make_copy", COPIES)
def test_exceptions(kind, make_copy):
    error = kind(smc.Finding("non_manifold", "two words", "edges", np.array([[1, 2]])))
    error.note = "of the caller"
    found = make_copy(error)
    assert type(found) is kind and str(found) == "two words" and found.args == error.args
    assert (found.status, found.kind, found.note) == ("non_manifold", "edges", "of the caller")
    assert_same(found.elements, error.elements)


def length(points):
    return smc.greedy_cut(points, FACES, threads=1).cut_length


def assert_refused(get):
    with pytest.raises(smc.InputError) as caught:
        get()
    assert (caught.value.status, caught.value.kind, caught.value.elements.tolist()) == ("invalid_point", "vertices", [3])


def test_pool():
    """The exception passes, as do the other results."""
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        answers = [pool.apply_async(length, (points,)) for points in (POINTS, BROKEN, 2 * POINTS)]
        assert_refused(lambda: answers[1].get(timeout=60))
        assert answers[2].get(timeout=60) == 2 * answers[0].get(timeout=60) > 0
        with pytest.raises(smc.InputError):
            pool.map_async(length, [POINTS, BROKEN]).get(timeout=60)


def test_executor():
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        answers = [pool.submit(length, points) for points in (POINTS, BROKEN, 2 * POINTS)]
        assert_refused(lambda: answers[1].result(timeout=60))
        assert answers[2].result(timeout=60) == 2 * answers[0].result(timeout=60) > 0
