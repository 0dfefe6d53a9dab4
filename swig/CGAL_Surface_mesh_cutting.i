// ------------------------------------------------------------------------------
// Copyright (c) 2026 The Surface_mesh_cutting authors.
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
// ------------------------------------------------------------------------------

%define CUTTING_DOCSTRING
"SWIG wrapper for the CGAL Surface Mesh Cutting package provided under the GPL-3.0+ license"
%enddef
%module (package="CGAL", docstring=CUTTING_DOCSTRING) CGAL_Surface_mesh_cutting

// common.i also turns exceptions of C++ into those of the target language, with their text.
%include "SWIG_CGAL/common.i"
Decl_void_type()
SWIG_CGAL_add_java_loadLibrary(CGAL_Surface_mesh_cutting)
SWIG_CGAL_package_common()

%import  "SWIG_CGAL/Common/Macros.h"
%import  "SWIG_CGAL/Kernel/CGAL_Kernel.i"
%include "SWIG_CGAL/Common/Iterator.h"
%include "SWIG_CGAL/Common/Wrapper_iterator_helper.h"

%{
  #include <SWIG_CGAL/Common/Iterator.h>
  #include <SWIG_CGAL/Common/Wrapper_iterator_helper.h>
  #include <SWIG_CGAL/Polyhedron_3/all_includes.h>

  #include <CGAL/Surface_mesh_cutting/unwrap.h>
  #include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>

  #include <algorithm>
  #include <array>
  #include <limits>
  #include <map>
  #include <stdexcept>
  #include <string>
  #include <utility>
  #include <vector>
%}

%define SWIG_CGAL_cutting_java_imports
%{
import java.util.Collection;
import java.util.Iterator;
import CGAL.Kernel.Point_2;
import CGAL.Kernel.Point_3;
import CGAL.Polyhedron_3.Polyhedron_3;
import CGAL.Polyhedron_3.Polyhedron_3_Halfedge_handle;
%}
%enddef
%pragma(java) jniclassimports=SWIG_CGAL_cutting_java_imports
%pragma(java) moduleimports=SWIG_CGAL_cutting_java_imports

%import "SWIG_CGAL/Polyhedron_3/CGAL_Polyhedron_3.i"
SWIG_CGAL_import_Polyhedron_3_SWIG_wrapper
SWIG_CGAL_import_Polyhedron_3_Halfedge_handle_SWIG_wrapper

%include "std_vector.i"
%typemap(javaimports) std::vector<Point_3> %{ import CGAL.Kernel.Point_3; %}
%template(Point_3_Vector) std::vector<Point_3>;
%template(Int_Vector) std::vector<int>;
%template(Polygon_Vector) std::vector< std::vector<int> >;

%types(Point_2*, Point_2); // whose descriptor the next macro uses
SWIG_CGAL_set_wrapper_iterator_helper_output(Point_2)
SWIG_CGAL_output_iterator_typemap_in(Wrapper_iterator_helper<Polyhedron_3_Halfedge_handle_SWIG_wrapper>::output,
                                     Polyhedron_3_Halfedge_handle_SWIG_wrapper,
                                     Polyhedron_3_Halfedge_handle,
                                     Polyhedron_3_Halfedge_handle_SWIG_wrapper::cpp_base,
                                     $descriptor(SWIG_Polyhedron_3::CGAL_Halfedge_handle<Polyhedron_3_>*),
                                     "LCGAL/Polyhedron_3/Polyhedron_3_Halfedge_handle;")

%inline %{
  typedef Wrapper_iterator_helper<Polyhedron_3_Halfedge_handle_SWIG_wrapper>::output Halfedge_output_iterator;
  typedef Wrapper_iterator_helper<Point_2>::output                                  Point_2_output_iterator;

  enum Cutting_effort { FAST_CUTTING, DEFAULT_CUTTING, BEST_CUTTING };

  // What became of a surface, besides its cut and its UVs. The message is empty if the bound is kept.
  struct Unwrapping
  {
    double cut_length;
    double average_distortion; // symmetric Dirichlet energy; 4 is ideal
    int number_of_charts;
    std::string message;
  };

  #ifndef SWIG
  namespace Surface_mesh_cutting_wrapper {

  namespace SMC = CGAL::Surface_mesh_cutting;
  typedef EPIC_Kernel::Point_2 UV;

  // A bound of 0 stands for none, since each language can write it.
  inline auto parameters(double maximum_average_distortion, bool do_bijective, Cutting_effort effort)
  {
    const double infinity = (std::numeric_limits<double>::infinity)();
    return CGAL::parameters::maximum_average_distortion(maximum_average_distortion == 0 ? infinity : maximum_average_distortion)
                            .do_bijective(do_bijective)
                            .effort(effort == FAST_CUTTING ? SMC::Effort::FAST :
                                    effort == BEST_CUTTING ? SMC::Effort::BEST : SMC::Effort::DEFAULT);
  }

  template <typename Result>
  Unwrapping checked(const Result& result)
  {
    if(!result.has_result)
      throw std::runtime_error(result.status.message);
    return { result.cut_length, result.average_distortion, int(result.charts.size()), result.status.message };
  }

  // Edges of a soup at which polygons with different UVs meet, each with its lower vertex first.
  inline std::vector<std::vector<int> > find_cut_edges(const std::vector<std::vector<int> >& polygons,
                                                       const std::vector<std::vector<UV> >& uvs)
  {
    std::map<std::vector<int>, std::pair<std::array<UV, 2>, bool> > ends_and_cuts;
    for(std::size_t p = 0; p < polygons.size(); ++p)
      for(std::size_t k = 0; k < polygons[p].size(); ++k)
      {
        const std::size_t next = (k + 1) % polygons[p].size();
        const bool is_ascending = polygons[p][k] < polygons[p][next];
        const std::size_t low = is_ascending ? k : next, high = is_ascending ? next : k;
        const std::array<UV, 2> ends = { uvs[p][low], uvs[p][high] };
        auto& known = ends_and_cuts.insert({{ polygons[p][low], polygons[p][high] }, { ends, false }}).first->second;
        known.second |= known.first != ends;
      }
    std::vector<std::vector<int> > cut_edges;
    for(const auto& entry : ends_and_cuts)
      if(entry.second.second)
        cut_edges.push_back(entry.first);
    return cut_edges;
  }

  } // namespace Surface_mesh_cutting_wrapper
  #endif // SWIG

  // CGAL::Surface_mesh_cutting::unwrap(): the UVs are those of the corners of each facet in turn, as its halfedges point to them.
  Unwrapping unwrap(Polyhedron_3_SWIG_wrapper& P,
                    Halfedge_output_iterator cut_edges,
                    Point_2_output_iterator uvs,
                    double maximum_average_distortion = 0,
                    bool do_bijective = false,
                    Cutting_effort effort = DEFAULT_CUTTING)
  {
    namespace wrapper = Surface_mesh_cutting_wrapper;
    Polyhedron_3_& polyhedron = P.get_data();
    CGAL::set_halfedgeds_items_id(polyhedron);
    auto is_cut = get(CGAL::dynamic_edge_property_t<bool>(), polyhedron);
    auto uv = get(CGAL::dynamic_halfedge_property_t<wrapper::UV>(), polyhedron);
    const Unwrapping result = wrapper::checked(wrapper::SMC::unwrap<CGAL::Parallel_if_available_tag>(
      polyhedron, is_cut, uv, wrapper::parameters(maximum_average_distortion, do_bijective, effort)));
    for(auto edge : edges(polyhedron))
      if(get(is_cut, edge))
        *cut_edges++ = halfedge(edge, polyhedron);
    for(auto facet : faces(polyhedron))
      for(auto h : CGAL::halfedges_around_face(halfedge(facet, polyhedron), polyhedron))
        *uvs++ = get(uv, h);
    return result;
  }

  // CGAL::Surface_mesh_cutting::unwrap_polygon_soup(): the UVs are those of the corners of each polygon in turn.
  Unwrapping unwrap(const std::vector<Point_3>& points,
                    const std::vector< std::vector<int> >& polygons,
                    std::vector< std::vector<int> >& cut_edges,
                    Point_2_output_iterator uvs,
                    double maximum_average_distortion = 0,
                    bool do_bijective = false,
                    Cutting_effort effort = DEFAULT_CUTTING)
  {
    namespace wrapper = Surface_mesh_cutting_wrapper;
    std::vector<Point_3::cpp_base> cgal_points;
    for(const Point_3& point : points)
      cgal_points.push_back(point.get_data());
    std::vector<std::vector<wrapper::UV> > corner_uvs;
    const Unwrapping result = wrapper::checked(wrapper::SMC::unwrap_polygon_soup<CGAL::Parallel_if_available_tag>(
      cgal_points, polygons, corner_uvs, wrapper::parameters(maximum_average_distortion, do_bijective, effort)));
    cut_edges = wrapper::find_cut_edges(polygons, corner_uvs);
    for(const auto& uvs_of_polygon : corner_uvs)
      std::copy(uvs_of_polygon.begin(), uvs_of_polygon.end(), uvs);
    return result;
  }
%}
