// The one decision about where a run may write. It is made before the first byte, also for the
// report of a failure.

#ifndef UNWRAP_OUTPUT_PLACES_H
#define UNWRAP_OUTPUT_PLACES_H

#include "Output_place.h"
#include "options.h"

#include <optional>
#include <string>
#include <vector>

// What is not asked for, or must not be written, has no place.
struct Output_places
{
  std::optional<Output_place> material, texture, page, cut, report;
  std::vector<std::optional<Output_place> > meshes, pictures; // with --page-files one for each page, else at most one
  std::vector<std::string> names; // of all files, as the user calls them
};

// No output may replace an input or another output, and each has to be writable. Otherwise throws a
// `Failure` with `Exit_code::USAGE`; `places.report` is then where that may be reported, if anywhere.
// The number of pages matters with --page-files only, and is not known before the run.
void decide_places(const Options& options, int number_of_pages, Output_places& places);

// The same for a command line that is not understood, whose inputs are not known: its report may go
// to the standard output, to a device or pipe, to where nothing is, or in place of a former report.
void decide_place_of_report(const std::string& name, Output_places& places);

#endif // UNWRAP_OUTPUT_PLACES_H
