# Headers, parsed once for many sources. A source is given a set only if it includes all of the set anyway, itself or
# through our own headers; so what compiles with the set includes what it needs.
# (ccache caches what uses them with CCACHE_SLOPPINESS=pch_defines,time_macros.)

# Of other projects, from small to large.
set(precompiled_sets graph numbers parameters predicates solvers surface cutting cutting_of_surface)

set(precompiled_graph
  boost/graph/graph_traits.hpp boost/property_map/property_map.hpp boost/graph/detail/d_ary_heap.hpp)
set(precompiled_numbers Eigen/Core)
set(precompiled_parameters ${precompiled_numbers} boost/graph/graph_traits.hpp CGAL/Named_function_parameters.h)
set(precompiled_predicates ${precompiled_numbers} CGAL/Exact_predicates_inexact_constructions_kernel.h)
set(precompiled_solvers ${precompiled_predicates} Eigen/SparseCore)
set(precompiled_surface ${precompiled_predicates} CGAL/Simple_cartesian.h CGAL/Surface_mesh.h)
set(precompiled_cutting ${precompiled_solvers} ${precompiled_graph} boost/graph/dijkstra_shortest_paths.hpp
  boost/graph/kruskal_min_spanning_tree.hpp CGAL/Named_function_parameters.h CGAL/boost/graph/helpers.h)
set(precompiled_cutting_of_surface ${precompiled_cutting} ${precompiled_surface}
  CGAL/Constrained_Delaunay_triangulation_2.h)

# One of our own each, with all that it includes, for the headers built on it: where these are compiled alone, most of
# the time would go to what is below them.
set(precompiled_own_sets index_arrays functions mapping)
set(precompiled_index_arrays CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h)
set(precompiled_functions CGAL/Surface_mesh_cutting/internal/indexed_functions.h)
set(precompiled_mapping CGAL/Surface_mesh_cutting/internal/mapping/final_map.h)
# All, by the time that parsing them takes.
set(precompiled_sets_of_headers graph numbers index_arrays functions parameters predicates solvers surface cutting
  cutting_of_surface mapping)

# reached_headers(FILE RESULT): what its lines of #include reach, whatever #if stands around them but that of an X_impl.h,
# which programs leave to the library
function(reached_headers file result)
  get_property(is_known GLOBAL PROPERTY "reached_headers_of_${file}" SET)
  if(NOT is_known)
    get_filename_component(folder "${file}" DIRECTORY)
    set(headers "")
    file(STRINGS "${file}" lines REGEX "^ *# *include +[<\"]")
    list(FILTER lines EXCLUDE REGEX "_impl\\.h>")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^ *# *include +[<\"]([^>\"]+).*" "\\1" header "${line}")
      list(APPEND headers "${header}")
      foreach(own IN ITEMS "${PROJECT_SOURCE_DIR}/include/${header}" "${folder}/${header}")
        if(EXISTS "${own}")
          reached_headers("${own}" further)
          list(APPEND headers ${further})
          break()
        endif()
      endforeach()
    endforeach()
    list(REMOVE_DUPLICATES headers)
    set_property(GLOBAL PROPERTY "reached_headers_of_${file}" "${headers}")
  endif()
  get_property(headers GLOBAL PROPERTY "reached_headers_of_${file}")
  set(${result} "${headers}" PARENT_SCOPE)
endfunction()

# precompiled_set_for(FILE RESULT SET...): the name of the last SET that fits, or nothing
function(precompiled_set_for file result)
  reached_headers("${file}" reached)
  set(${result} "" PARENT_SCOPE)
  foreach(name IN LISTS ARGN)
    set(missing ${precompiled_${name}})
    list(REMOVE_ITEM missing ${reached})
    if(NOT missing)
      set(${result} "${name}" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# What most sources of the program unwrap include.
set(precompiled_mesh CGAL/Simple_cartesian.h CGAL/Surface_mesh.h)

# precompile_set_for_sources_of(TARGET SET): for each of its many sources that reaches all of the set; called from the
# folder of the target
function(precompile_set_for_sources_of target set)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  set(headers ${precompiled_${set}})
  list(TRANSFORM headers PREPEND "<")
  list(TRANSFORM headers APPEND ">")
  target_precompile_headers(${target} PRIVATE ${headers})
  foreach(source IN LISTS sources)
    precompiled_set_for("${folder}/${source}" name ${set})
    if(NOT name)
      set_source_files_properties("${folder}/${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()
