# Programs of one source each, compiled in few units, since most of the time would go to what all of them include. Each has
# its own `main()`; tests define all else in a namespace of their own, examples nothing that others define otherwise.

# With flags or types of their own.
set(separate_programs test_headers_alone test_openmesh draw_cut_example openmesh_example unwrap_polyhedron_example)

# unite_programs_of(FOLDER SIZE): up to SIZE programs that follow each other in the folder's list become one unit, of which
# each of them consists; it runs the `main()` of the program that it is called as.
function(unite_programs_of folder size)
  get_property(programs DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  list(REMOVE_ITEM programs ${separate_programs})
  list(FILTER programs INCLUDE REGEX "^test_|_example$")
  list(LENGTH programs number)
  if(number GREATER 0)
    math(EXPR last "${number} - 1")
    foreach(first RANGE 0 ${last} ${size})
      list(SUBLIST programs ${first} ${size} unit)
      unite_programs("${folder}" ${unit})
    endforeach()
  endif()
endfunction()

# unite_programs(FOLDER FIRST FURTHER...)
function(unite_programs folder first)
  set(includes "")
  set(calls "")
  set(libraries "")
  foreach(program IN ITEMS ${first} ${ARGN})
    get_target_property(source ${program} SOURCES)
    string(APPEND includes "#define main main_of_${program}\n#include \"${source}\"\n#undef main\n")
    string(APPEND calls "  if(name == \"${program}\")\n    return run(main_of_${program}, argc, argv);\n")
    get_target_property(libraries_of_program ${program} LINK_LIBRARIES)
    list(APPEND libraries ${libraries_of_program})
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  set(unit "${PROJECT_BINARY_DIR}/${folder}/unit_of_${first}.cpp")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/united_programs.cpp.in" "${unit}" @ONLY)
  set_target_properties(${first} ${ARGN} PROPERTIES
    LINK_LIBRARIES "${libraries}" LINKER_LANGUAGE CXX UNITY_BUILD OFF)
  set_target_properties(${first} PROPERTIES SOURCES "${unit}")
  if(ARGN)
    set_target_properties(${ARGN} PROPERTIES SOURCES "$<TARGET_OBJECTS:${first}>")
  endif()
endfunction()
