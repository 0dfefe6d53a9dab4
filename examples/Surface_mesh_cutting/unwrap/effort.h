// Efforts by their names on the command line.

#ifndef UNWRAP_EFFORT_H
#define UNWRAP_EFFORT_H

#include <CGAL/Surface_mesh_cutting/Effort.h>

#include <string>

inline CGAL::Surface_mesh_cutting::Effort effort_of(const std::string& name)
{
  using CGAL::Surface_mesh_cutting::Effort;
  return name == "fast" ? Effort::FAST : name == "best" ? Effort::BEST : Effort::DEFAULT;
}

#endif // UNWRAP_EFFORT_H
