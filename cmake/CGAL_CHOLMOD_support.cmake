# To be included after find_package(CHOLMOD QUIET), in the manner of CGAL_TBB_support.
if(TARGET SuiteSparse::CHOLMOD AND NOT TARGET CGAL::CHOLMOD_support)
  add_library(CGAL::CHOLMOD_support INTERFACE IMPORTED)
  set_target_properties(CGAL::CHOLMOD_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS "CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD"
    INTERFACE_LINK_LIBRARIES "SuiteSparse::CHOLMOD")
endif()
