// The files a benchmark is told to measure.

#ifndef SURFACE_MESH_CUTTING_BENCHMARK_MESH_FILES_H
#define SURFACE_MESH_CUTTING_BENCHMARK_MESH_FILES_H

#include <CGAL/config.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

// A mesh file, or those of a folder, in alphabetical order.
inline void add_files(const std::filesystem::path& path, std::vector<std::filesystem::path>& files)
{
  if(!std::filesystem::is_directory(path))
  {
    files.push_back(path);
    return;
  }
  std::set<std::filesystem::path> found;
  for(const auto& entry : std::filesystem::directory_iterator(path))
    if(std::set<std::string>{".off", ".obj", ".ply", ".stl"}.count(entry.path().extension().string()) > 0)
      found.insert(entry.path());
  files.insert(files.end(), found.begin(), found.end());
}

// Of the arguments `[FOLDER [MESH_FILE...]]`: those named, or all of the folder, by default CGAL's; sorted.
inline std::vector<std::filesystem::path> mesh_files(int argc, char** argv)
{
  const std::filesystem::path folder = argc > 1 ? argv[1] : CGAL::data_file_path("meshes");
  std::vector<std::filesystem::path> files;
  for(int i = 2; i < argc; ++i)
    files.push_back(folder / argv[i]);
  if(files.empty())
    add_files(folder, files);
  std::sort(files.begin(), files.end());
  return files;
}

#endif // SURFACE_MESH_CUTTING_BENCHMARK_MESH_FILES_H
