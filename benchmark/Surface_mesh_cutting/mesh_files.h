// The files a benchmark is told to measure.

#ifndef SURFACE_MESH_CUTTING_BENCHMARK_MESH_FILES_H
#define SURFACE_MESH_CUTTING_BENCHMARK_MESH_FILES_H

#include <CGAL/config.h>

#include <algorithm>
#include <filesystem>
#include <vector>

// Of the arguments `[FOLDER [MESH_FILE...]]`: those named, or all of the folder, by default CGAL's; sorted.
inline std::vector<std::filesystem::path> mesh_files(int argc, char** argv)
{
  const std::filesystem::path folder = argc > 1 ? argv[1] : CGAL::data_file_path("meshes");
  std::vector<std::filesystem::path> files;
  for(int i = 2; i < argc; ++i)
    files.push_back(folder / argv[i]);
  if(files.empty() && std::filesystem::is_directory(folder))
    for(const auto& entry : std::filesystem::directory_iterator(folder))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

#endif // SURFACE_MESH_CUTTING_BENCHMARK_MESH_FILES_H
