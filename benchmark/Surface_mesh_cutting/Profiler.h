// A visitor that keeps what the last run took.

#ifndef PROFILER_H
#define PROFILER_H

#include <CGAL/Surface_mesh_cutting/Visitor.h>

struct Profiler : CGAL::Surface_mesh_cutting::Default_visitor
{
  CGAL::Surface_mesh_cutting::Run_profile profile;
  void ended(const CGAL::Surface_mesh_cutting::Run_profile& p) { profile = p; }
};

#endif // PROFILER_H
