// The files that a run leaves.

#ifndef UNWRAP_OUTPUTS_H
#define UNWRAP_OUTPUTS_H

#include "Layout.h"
#include "Output_places.h"
#include "options.h"
#include "outcome.h"

#include <string>
#include <vector>

// Writes all that is asked for. If that fails, throws a `Failure` with `Exit_code::USAGE` or
// `Exit_code::STOPPED` and leaves no file.
void write_outputs(const Options& options, const Output_places& places, const Layout& layout, const Outcome& outcome);

// What of the input is lost by `write_outputs`, and which file has another name than expected.
std::vector<std::string> warnings_about_outputs(const Options& options, const Output_places& places, const Layout& layout);

// Writes the report alone, if it has a place.
void write_report(const Output_places& places, const Outcome& outcome);

#endif // UNWRAP_OUTPUTS_H
