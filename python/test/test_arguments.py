"""What the functions refuse, and how they say so."""

import numpy as np
import pytest

import meshes
import surface_mesh_cutting as smc

POINTS, FACES = meshes.sphere(1)


@pytest.mark.parametrize("points", [POINTS[:, :2], POINTS.ravel(), POINTS[None], np.zeros((4, 4)), 1.0])
def test_shapes_of_points(points):
    with pytest.raises(ValueError, match=r"points must have shape \(n, 3\)"):
        smc.unwrap(points, FACES)


@pytest.mark.parametrize("points", [POINTS.astype(complex), POINTS.astype(str), POINTS.astype(object), POINTS > 0, None])
def test_types_of_points(points):
    with pytest.raises(TypeError, match="points must be an array of real numbers"):
        smc.unwrap(points, FACES)


@pytest.mark.parametrize("faces", [FACES.astype(float), FACES.astype(str), FACES > 1, None])
def test_types_of_faces(faces):
    with pytest.raises(TypeError, match="faces must be an array of integers"):
        smc.unwrap(POINTS, faces)


def test_shapes_of_faces():
    for faces in (FACES[None], FACES.ravel()):
        with pytest.raises(ValueError, match="faces must have shape"):
            smc.unwrap(POINTS, faces)
    with pytest.raises(ValueError, match="offsets"):
        smc.unwrap(POINTS, [[0, 1, 2], [0, 1, 2, 3]])
    for offsets in ([], [0], [1, FACES.size], [0, 9, 6, FACES.size], [0, FACES.size + 3], [-3, FACES.size]):
        with pytest.raises(ValueError, match="offsets must increase from 0"):
            smc.unwrap(POINTS, FACES.ravel(), offsets)
    with pytest.raises(ValueError):
        smc.unwrap(POINTS, FACES, [0, FACES.size])


@pytest.mark.parametrize("options, error", [
    (dict(effort="most"), ValueError), (dict(effort=1), TypeError), (dict(weld=1), TypeError),
    (dict(weld_tolerance=-1), ValueError), (dict(weld_tolerance=float("nan")), ValueError),
    (dict(weld_tolerance=0.1), ValueError), (dict(weld_tolerance="0"), TypeError),
    (dict(weld="off", weld_tolerance=1e-6), ValueError),
    (dict(uv_scale="large"), ValueError), (dict(strict=1), TypeError), (dict(bijective="yes"), TypeError),
    (dict(threads=0), ValueError), (dict(threads=1.5), TypeError), (dict(seed=-1), ValueError),
    (dict(symmetry="w"), ValueError), (dict(symmetry=True), TypeError), (dict(seam_smoothness="1"), TypeError),
    (dict(seed=2**32), ValueError), (dict(time_limit=0), ValueError), (dict(time_limit=float("nan")), ValueError),
    (dict(time_limit="1"), TypeError), (dict(progress=3), TypeError), (dict(margin="2"), TypeError),
    (dict(texture_size=0), ValueError), (dict(texture_size=2**31), ValueError), (dict(terminals=[[1, 2]]), ValueError),
    (dict(terminals=[1.5]), TypeError), (dict(mandatory_edges=[1, 2]), ValueError),
    (dict(initial_cut=np.zeros((2, 3), int)), ValueError), (dict(forbidden_edges=[[0.0, 1.0]]), TypeError),
    (dict(edge_weights=[1.0]), TypeError), (dict(edge_weights=([[0, 2]], [1.0, 2.0])), ValueError),
    (dict(efort="fast"), TypeError), (dict(output="cut"), TypeError)])
def test_options(options, error):
    with pytest.raises(error, match=next(iter(options))) as caught:
        smc.unwrap(POINTS, FACES, **options)
    assert not isinstance(caught.value, smc.Error)


@pytest.mark.parametrize("function, name, suggestion", [
    (smc.unwrap, "max_distortion", "maximum_average_distortion"), (smc.unwrap, "must_cut", "mandatory_edges"),
    (smc.unwrap, "allow_overlap", "bijective"), (smc.unwrap, "efort", "effort"), (smc.unwrap, "texturesize", "texture_size"),
    (smc.greedy_cut, "forbidden_edge", "forbidden_edges"), (smc.cut_handles, "never_cut", "forbidden_edges"),
    (smc.pack_charts, "margins", "margin")])
def test_near_misses(function, name, suggestion):
    with pytest.raises(TypeError) as caught:
        function(*([POINTS, FACES, POINTS[FACES][..., :2]][:3 if function is smc.pack_charts else 2]), **{name: 1})
    assert str(caught.value).endswith(f"argument {name!r}; did you mean {suggestion!r}?")


def test_misses_that_are_not_near():
    """No option is suggested that the function does not have."""
    for name in ("max_distortion", "zebra"):
        with pytest.raises(TypeError, match="argument '[a-z_]+'$"):
            smc.cut_handles(POINTS, FACES, **{name: 1})


@pytest.mark.parametrize("value", [4.1, "fast", True, np.float64(4.1)])
def test_options_without_a_name(value):
    with pytest.raises(TypeError, match="offsets must be an array.*by name"):
        smc.unwrap(POINTS, FACES, value)


def test_masked_arrays():
    mask = np.zeros(POINTS.shape, bool)
    assert smc.greedy_cut(np.ma.array(POINTS, mask=mask), FACES).status == "ok"
    mask[3, 1] = True
    with pytest.raises(TypeError, match="points has masked entries"):
        smc.greedy_cut(np.ma.array(POINTS, mask=mask), FACES)
    with pytest.raises(TypeError, match="faces has masked entries"):
        smc.greedy_cut(POINTS, np.ma.masked_equal(FACES, 3))


def test_weld_is_on_or_off():
    soup, alone = POINTS[FACES].reshape(-1, 3), np.arange(FACES.size).reshape(FACES.shape)
    assert smc.greedy_cut(soup, alone, weld=True).components == 1
    assert smc.greedy_cut(soup, alone, weld=np.False_).components == len(FACES)


def test_weld_tolerance():
    """Warnings name the parameters of this module."""
    soup, alone = POINTS[FACES].reshape(-1, 3), np.arange(FACES.size).reshape(FACES.shape)
    moved = soup + 1e-7 * np.sin(np.arange(soup.size)).reshape(soup.shape)
    result = smc.greedy_cut(moved, alone)
    assert result.components == len(FACES)
    assert any("with weld_tolerance=1e-0" in str(warning) for warning in result.warnings)
    assert smc.greedy_cut(moved, alone, weld_tolerance=1e-5).components == 1
    result = smc.greedy_cut(soup, alone, weld="off")
    assert any("with weld='on', the surface has 1 piece" in str(warning) for warning in result.warnings)
    assert not smc.greedy_cut(soup, alone).warnings


def test_points_that_no_face_uses():
    points = np.concatenate([POINTS, [[np.nan, np.inf, 0]]])
    assert smc.unwrap(points, FACES).number_of_charts == smc.unwrap(POINTS, FACES).number_of_charts
    with pytest.raises(smc.InputError):
        smc.unwrap(points, np.concatenate([FACES, [[0, 1, len(POINTS)]]]))


def test_polygon_with_a_hole():
    points = np.array([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0)], float)
    result = smc.unwrap(points, [0, 1, 2, 3, 0, 4, 7, 6, 5, 4], [0, 10], uv_scale="surface")
    assert not result.interpreted and result.average_distortion == pytest.approx(4)
    assert smc.certify_unwrap(points, [0, 1, 2, 3, 0, 4, 7, 6, 5, 4], result.corner_uv, [0, 10])


def refused(*arguments, **options):
    with pytest.raises(smc.InputError) as caught:
        smc.unwrap(*arguments, **options)
    assert str(caught.value) and isinstance(caught.value, ValueError)
    return caught.value


@pytest.mark.parametrize("options, elements", [
    (dict(maximum_average_distortion=4.0), []), (dict(maximum_face_distortion=4.0), []),
    (dict(maximum_chart_distortion=np.nan), []), (dict(maximum_face_distortion=8.0, face_distortion_quantile=0.0), []),
    (dict(seam_smoothness=-1.0), []), (dict(minimum_area_ratio=1.5), []), (dict(influence_threshold=np.inf), []),
    (dict(minimum_distortion_decrease=np.nan), []), (dict(margin=-1.0), []), (dict(margin=np.nan), []),
    (dict(margin=512.0), []), (dict(terminals=[18]), []), (dict(terminals=[-1]), []), (dict(mandatory_edges=[[0, 99]]), []),
    (dict(mandatory_edges=[[1, 0], [0, 6]]), [[0, 1]]), (dict(forbidden_edges=[[5, 5]]), [[5, 5]]),
    (dict(edge_weights=([[0, 6]], [-1.0])), [[0, 6]]), (dict(edge_weights=([[6, 0]], [np.nan])), [[0, 6]])])
def test_parameters(options, elements):
    error = refused(POINTS, FACES, **options)
    assert error.status == "wrong_parameter"
    assert error.elements.tolist() == elements


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_coordinates(value):
    points = POINTS.copy()
    points[[3, 11], 1] = value
    error = refused(points, FACES)
    assert (error.status, error.kind, error.elements.tolist()) == ("invalid_point", "vertices", [3, 11])


@pytest.mark.parametrize("index", [len(POINTS), -1, 2**31, 2**32, -2**63, 2**63 - 1])
def test_indices(index):
    faces = FACES.copy()
    faces[[4, 6], 2] = index
    error = refused(POINTS, faces)
    assert (error.status, error.kind, error.elements.tolist()) == ("wrong_parameter", "faces", [4, 6])


@pytest.mark.parametrize("faces", [[], np.zeros((0, 3), int), np.zeros((0, 7), int), [[0, 0, 1]], np.zeros((3, 0), int)])
@pytest.mark.parametrize("points", [POINTS, POINTS[:2]])
def test_empty(points, faces):
    assert refused(points, faces).status == "empty_mesh"


def test_no_points():
    assert refused([], []).status == "empty_mesh"
    assert refused(np.zeros((0, 3)), FACES).status == "wrong_parameter"
    assert refused([], [], [0]).status == "empty_mesh"


@pytest.mark.parametrize("exponent", [-1000, -500, 500, 1000])
def test_extreme_scales(exponent):
    """A power of two changes no digit."""
    usual, extreme = smc.unwrap(POINTS, FACES), smc.unwrap(POINTS * 2.0**exponent, FACES)
    assert extreme.uv.tobytes() == usual.uv.tobytes()
    assert extreme.average_distortion == usual.average_distortion
    assert extreme.cut_length == usual.cut_length * 2.0**exponent
    assert any("extreme" in warning.message for warning in extreme.warnings)


def test_too_many():
    try:
        faces = np.zeros((3, 2**31 // 9 + 1), np.int64)  # memory that nobody touches
    except MemoryError:
        pytest.skip("not enough address space")
    assert "more than" in str(refused(POINTS, faces))


def test_infeasible():
    everything = meshes.edges(FACES)
    error = refused(POINTS, FACES, forbidden_edges=everything)
    assert error.status == "infeasible_constraints" and error.kind == "edges"
    points, faces = meshes.sphere(0)
    error = refused(points, faces, mandatory_edges=meshes.edges(faces), margin=500.0)
    assert error.status == "infeasible_constraints" and "texture_size" in str(error)


def test_strict():
    faces = np.concatenate([FACES, FACES[:1]])
    error = refused(POINTS, faces, strict=True)
    assert (error.status, error.elements.tolist()) == ("non_manifold", [len(FACES)])
    assert smc.unwrap(POINTS, FACES, strict=True).status == "ok"


def test_errors_are_apart():
    assert issubclass(smc.InputError, smc.Error) and issubclass(smc.StoppedError, smc.Error)
    assert issubclass(smc.ComputationError, RuntimeError)
