// Shows how far a computation of the library is, and ends it when a stop is requested.

#ifndef UNWRAP_PROGRESS_VISITOR_H
#define UNWRAP_PROGRESS_VISITOR_H

#include "Progress_display.h"
#include "Stop_visitor.h"
#include "options.h"

class Progress_visitor : public Stop_visitor
{
public:
  explicit Progress_visitor(const Options& options) : m_progress(style_of(options)) {}

  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction) { m_progress.show(name_of(phase), fraction); }

private:
  static const char* name_of(CGAL::Surface_mesh_cutting::Phase phase)
  {
    using CGAL::Surface_mesh_cutting::Phase;
    switch(phase)
    {
      case Phase::CANDIDATES: return "finding candidates";
      case Phase::FILTER: return "filtering";
      case Phase::CONNECT: return "connecting";
      case Phase::REFINE: return "refining";
      case Phase::PARAMETERIZE: return "flattening";
      case Phase::PACK: return "packing";
    }
    return "";
  }

  static Progress_display::Style style_of(const Options& options)
  {
    return options.has_progress_lines ? Progress_display::Style::LINES
         : options.is_quiet ? Progress_display::Style::NONE : Progress_display::Style::BAR;
  }

  Progress_display m_progress;
};

#endif // UNWRAP_PROGRESS_VISITOR_H
