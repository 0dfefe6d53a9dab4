// Ends a computation of the library when a stop is requested.

#ifndef UNWRAP_STOP_VISITOR_H
#define UNWRAP_STOP_VISITOR_H

#include "stop_request.h"

#include <CGAL/Surface_mesh_cutting/Visitor.h>

struct Stop_visitor : CGAL::Surface_mesh_cutting::Default_visitor
{
  bool go_further() const { return !is_stop_requested(); }
};

#endif // UNWRAP_STOP_VISITOR_H
