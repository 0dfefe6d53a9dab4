# An installed package for find_package(Surface_mesh_cutting). The headers go
# into a folder of their own: one of them has the name of a header of CGAL.

include(CMakePackageConfigHelpers)
set(package_dir lib/cmake/Surface_mesh_cutting)

if(SURFACE_MESH_CUTTING_WITH_LIBRARY)
  install(CODE "
    if(NOT EXISTS \"$<TARGET_FILE:Surface_mesh_cutting>\")
      message(FATAL_ERROR \"Nothing is installed before the library is built:\\n\"
        \"  cmake --build ${PROJECT_BINARY_DIR} --target Surface_mesh_cutting\\n\"
        \"The CMake option -DSURFACE_MESH_CUTTING_WITH_LIBRARY=OFF leaves the headers alone.\")
    endif()")
endif()
install(DIRECTORY include/CGAL DESTINATION include/surface_mesh_cutting)
install(TARGETS Surface_mesh_cutting_headers Surface_mesh_cutting EXPORT Surface_mesh_cuttingTargets ARCHIVE DESTINATION lib)
install(EXPORT Surface_mesh_cuttingTargets
  NAMESPACE Surface_mesh_cutting:: DESTINATION ${package_dir})

# The library depends on what it was compiled with.
set(SURFACE_MESH_CUTTING_LIBRARY_DEPENDENCIES "")
if(SURFACE_MESH_CUTTING_WITH_LIBRARY)
  foreach(library TBB METIS)
    if(TARGET CGAL::${library}_support)
      list(APPEND SURFACE_MESH_CUTTING_LIBRARY_DEPENDENCIES ${library})
    endif()
  endforeach()
endif()

configure_package_config_file(
  cmake/Surface_mesh_cuttingConfig.cmake.in
  "${PROJECT_BINARY_DIR}/Surface_mesh_cuttingConfig.cmake"
  INSTALL_DESTINATION ${package_dir})
set(architecture ARCH_INDEPENDENT)
if(SURFACE_MESH_CUTTING_WITH_LIBRARY)
  set(architecture "")
endif()
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Surface_mesh_cuttingConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion ${architecture})
install(FILES
  "${PROJECT_BINARY_DIR}/Surface_mesh_cuttingConfig.cmake"
  "${PROJECT_BINARY_DIR}/Surface_mesh_cuttingConfigVersion.cmake"
  DESTINATION ${package_dir})

# A package for Debian: cpack -G DEB in the build folder, as scripts/package.sh does.
set(CPACK_PACKAGE_NAME libsurface-mesh-cutting-dev)
set(CPACK_PACKAGE_CONTACT "The Surface_mesh_cutting authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Short cuts of surfaces, and maps without flips: headers and library")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "libcgal-dev (>= ${SURFACE_MESH_CUTTING_MINIMUM_CGAL}), libeigen3-dev (>= ${SURFACE_MESH_CUTTING_MINIMUM_EIGEN}), libboost-dev")
foreach(library ${SURFACE_MESH_CUTTING_LIBRARY_DEPENDENCIES})
  string(TOLOWER "${library}" name)
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", lib${name}-dev")
endforeach()
install(FILES cmake/copyright DESTINATION share/doc/${CPACK_PACKAGE_NAME})
include(CPack)
