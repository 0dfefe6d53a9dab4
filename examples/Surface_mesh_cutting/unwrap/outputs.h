// The files that a run leaves.

#ifndef UNWRAP_OUTPUTS_H
#define UNWRAP_OUTPUTS_H

#include "Layout.h"
#include "options.h"
#include "outcome.h"

// Sees to it that a long run does not end with a file that cannot be written, or over its input.
// Throws a `Failure` with `Exit_code::USAGE`.
void check_outputs(const Options& options);

// Writes all that is asked for. If a file cannot be written, throws a `Failure` with
// `Exit_code::USAGE` and leaves none.
void write_outputs(const Options& options, const Layout& layout, const Outcome& outcome);

// Writes the report alone.
void write_report(const Options& options, const Outcome& outcome);

#endif // UNWRAP_OUTPUTS_H
