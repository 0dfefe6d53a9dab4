// Shows how far the run is during a computation of the library, and ends it when a stop is requested.

#ifndef UNWRAP_PROGRESS_VISITOR_H
#define UNWRAP_PROGRESS_VISITOR_H

#include "Progress_display.h"
#include "Stop_visitor.h"
#include "options.h"

// Where a part of a run begins and ends, from 0 to 1.
struct Part_of_run
{
  double begin, end;
};

class Progress_visitor : public Stop_visitor
{
public:
  // `part`: what the computation is of the run.
  Progress_visitor(const Options& options, const Part_of_run& part) : m_part(part), m_progress(style_of(options)) {}

  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction)
  {
    m_progress.show(name_of(phase), m_part.begin + (m_part.end - m_part.begin) * fraction);
  }

  void ended(const CGAL::Surface_mesh_cutting::Run_profile& profile) { m_profile = profile; }

  // The profile of the computation, once it has ended.
  const CGAL::Surface_mesh_cutting::Run_profile& profile() const { return m_profile; }

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

  const Part_of_run m_part;
  CGAL::Surface_mesh_cutting::Run_profile m_profile;
  Progress_display m_progress;
};

#endif // UNWRAP_PROGRESS_VISITOR_H
