# set_execution_property(PROGRAM PROPERTY VALUE...): appends to a property of the test that runs a program of
# create_single_source_cgal_program(). CGAL 5 puts underscores into the name of that test, CGAL 6 spaces.
function(set_execution_property program property)
  if(NOT BUILD_TESTING)
    return()
  endif()
  foreach(test "execution___of__${program}" "execution   of  ${program}")
    if(TEST "${test}")
      set_property(TEST "${test}" APPEND PROPERTY ${property} ${ARGN})
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "No test runs ${program}: CGAL ${CGAL_VERSION} names it otherwise.")
endfunction()
