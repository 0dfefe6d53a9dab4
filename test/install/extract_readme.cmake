# Makes a project of the code in the README:
#   cmake -DREADME=FILE -DFOLDER=FOLDER [-DTARGET=TARGET] -P extract_readme.cmake
# TARGET: what it links instead

file(READ "${README}" text)
foreach(block "cmake;CMakeLists.txt" "cpp;main.cpp")
  list(GET block 0 language)
  list(GET block 1 file)
  if(NOT text MATCHES "\n```${language}\n([^`]*)```\n")
    message(FATAL_ERROR "${README} holds no ${language}")
  endif()
  set(block_text "${CMAKE_MATCH_1}")
  if(TARGET)
    string(REPLACE "Surface_mesh_cutting::Surface_mesh_cutting" "${TARGET}" block_text "${block_text}")
  endif()
  file(WRITE "${FOLDER}/${file}" "${block_text}")
endforeach()
