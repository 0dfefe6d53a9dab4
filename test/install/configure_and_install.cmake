# Configures the project, and installs it before anything is built:
#   cmake -DSOURCES=FOLDER -DFOLDER=FOLDER -DGENERATOR=NAME -DCOMPILER=FILE -DCGAL=FOLDER -DCGAL_VERSION=VERSION
#         -P configure_and_install.cmake

file(REMOVE_RECURSE "${FOLDER}")

# configure(NAME OPTION...): sets `result` and `output`
function(configure name)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${SOURCES}" -B "${FOLDER}/${name}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
      -DBUILD_TESTING=OFF -DSURFACE_MESH_CUTTING_WITH_PYTHON=OFF ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(require_output text)
  string(FIND "${output}" "${text}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "'${text}' is missing in:\n${output}")
  endif()
endfunction()

# No other CGAL takes the place of one that is chosen.
configure(wrong_cgal "-DCGAL_DIR=${FOLDER}/nowhere")
if(result EQUAL 0)
  message(FATAL_ERROR "A wrong CGAL_DIR is not noticed:\n${output}")
endif()

# A package that accepts requests for its own major version alone, as that of Eigen 5 does.
file(WRITE "${FOLDER}/eigen/Eigen3Config.cmake" [[
set(EIGEN3_FOUND TRUE)
set(EIGEN3_INCLUDE_DIR "${CMAKE_CURRENT_LIST_DIR}")
if(NOT TARGET Eigen3::Eigen)
  add_library(Eigen3::Eigen INTERFACE IMPORTED)
endif()
]])
file(WRITE "${FOLDER}/eigen/Eigen3ConfigVersion.cmake" [[
set(PACKAGE_VERSION 5.0.1)
if(NOT PACKAGE_FIND_VERSION OR PACKAGE_FIND_VERSION_MAJOR EQUAL 5)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
]])
configure(eigen_5 "-DCGAL_DIR=${CGAL}" "-DEigen3_DIR=${FOLDER}/eigen"
  -DCMAKE_FIND_PACKAGE_PREFER_CONFIG=ON) # to the module of CGAL 5, which would find another one
if(NOT result EQUAL 0)
  message(FATAL_ERROR "Eigen 5 is refused:\n${output}")
endif()
require_output("Using CGAL ${CGAL_VERSION} (${CGAL}) and Eigen 5.0.1")

execute_process(COMMAND "${CMAKE_COMMAND}" --install "${FOLDER}/eigen_5" --prefix "${FOLDER}/prefix"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0 OR EXISTS "${FOLDER}/prefix")
  message(FATAL_ERROR "Half of the package is installed:\n${output}")
endif()
require_output("cmake --build ${FOLDER}/eigen_5 --target Surface_mesh_cutting")

configure(headers "-DCGAL_DIR=${CGAL}" -DSURFACE_MESH_CUTTING_WITH_LIBRARY=OFF)
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${FOLDER}/headers" --prefix "${FOLDER}/prefix"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The headers alone are not installed:\n${output}")
endif()
