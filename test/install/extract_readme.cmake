# Makes a project of the code in the README:
#   cmake -DREADME=FILE -DFOLDER=FOLDER -P extract_readme.cmake

file(READ "${README}" text)
foreach(block "cmake;CMakeLists.txt" "cpp;main.cpp")
  list(GET block 0 language)
  list(GET block 1 file)
  if(NOT text MATCHES "\n```${language}\n([^`]*)```\n")
    message(FATAL_ERROR "${README} holds no ${language}")
  endif()
  file(WRITE "${FOLDER}/${file}" "${CMAKE_MATCH_1}")
endforeach()
