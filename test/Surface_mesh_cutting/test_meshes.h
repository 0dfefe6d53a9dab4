// Meshes of all types to test with.

#ifndef TEST_MESHES_H
#define TEST_MESHES_H

#include "surface_meshes.h"

#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>

namespace test {

using Inexact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Exact_kernel>;
using Linear_cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
  2, 3, CGAL::Linear_cell_complex_traits<3, Inexact_kernel> >::type;

} // namespace test

#endif // TEST_MESHES_H
