from CGAL.CGAL_Kernel import Point_3
from CGAL.CGAL_Polyhedron_3 import Polyhedron_3
from CGAL import CGAL_Surface_mesh_cutting
from CGAL.CGAL_Surface_mesh_cutting import Int_Vector
from CGAL.CGAL_Surface_mesh_cutting import Point_3_Vector
from CGAL.CGAL_Surface_mesh_cutting import Polygon_Vector


def signed_area(corners):
    """The area of a polygon, positive iff it is counterclockwise."""
    pairs = zip(corners, corners[1:] + corners[:1])
    return sum(p.x() * q.y() - q.x() * p.y() for p, q in pairs) / 2


def text_of_exception(function, *arguments):
    try:
        function(*arguments)
    except Exception as error:
        return str(error)
    raise AssertionError("no exception")


def make_cube():
    points = Point_3_Vector()
    for i in range(8):
        points.append(Point_3(i & 1, i >> 1 & 1, i >> 2))
    polygons = Polygon_Vector()
    for corners in (0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5):
        polygon = Int_Vector()
        for i in corners:
            polygon.append(i)
        polygons.append(polygon)
    return points, polygons


def test_polyhedron():
    P = Polyhedron_3()
    P.make_tetrahedron(Point_3(1, 0, 0), Point_3(0, 0, 1), Point_3(0, 0, 0), Point_3(0, 1, 0))
    cut_edges = []
    uvs = []
    bound = 4.001
    result = CGAL_Surface_mesh_cutting.unwrap(P, cut_edges, uvs, bound, True)
    # Each vertex carries curvature, so that a tree of all four must be cut.
    assert len(cut_edges) == 3 and result.number_of_charts == 1 and result.message == ""
    assert result.average_distortion <= bound and result.cut_length >= 3
    ends = [end for h in cut_edges for end in (h.vertex(), h.opposite().vertex())]
    assert all(v in ends for v in P.vertices())
    facets = [uvs[i:i + 3] for i in range(0, len(uvs), 3)]
    assert len(facets) == 4 and all(signed_area(facet) > 0.45 for facet in facets)


def test_soup():
    points, polygons = make_cube()
    cut_edges = Polygon_Vector()
    uvs = []
    result = CGAL_Surface_mesh_cutting.unwrap(points, polygons, cut_edges, uvs, 4.001, True,
                                              CGAL_Surface_mesh_cutting.FAST_CUTTING)
    assert len(cut_edges) == 7 and abs(result.cut_length - 7) < 1e-9 and result.number_of_charts == 1
    assert {i for edge in cut_edges for i in edge} == set(range(8))
    assert len(uvs) == 24 and all(0.95 < signed_area(uvs[i:i + 4]) < 1.05 for i in range(0, 24, 4))

    # By default, there is no bound, and charts may overlap.
    loose = CGAL_Surface_mesh_cutting.unwrap(points, polygons, cut_edges, uvs)
    assert loose.cut_length <= result.cut_length and loose.average_distortion >= 4 and len(uvs) == 48


def test_exceptions():
    uvs = []
    unwrap = CGAL_Surface_mesh_cutting.unwrap
    assert "no face" in text_of_exception(unwrap, Polyhedron_3(), [], uvs)
    points, polygons = make_cube()
    assert "maximum_average_distortion" in text_of_exception(unwrap, points, polygons, Polygon_Vector(), uvs, 3.0)
    polygon = Int_Vector()
    for i in 0, 1, 8:
        polygon.append(i)
    polygons.append(polygon)
    assert "point" in text_of_exception(unwrap, points, polygons, Polygon_Vector(), uvs)
    assert uvs == []


test_polyhedron()
test_soup()
test_exceptions()
