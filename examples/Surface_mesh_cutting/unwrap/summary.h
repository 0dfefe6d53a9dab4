// What a run found, in a line.

#ifndef UNWRAP_SUMMARY_H
#define UNWRAP_SUMMARY_H

#include "outcome.h"

#include <optional>
#include <string>

// Of a layout that is complete.
std::string summary(const Outcome& outcome);

// What is odd about a layout with very many charts, and what may help.
std::optional<std::string> warning_of_many_charts(const Outcome& outcome, const std::string& weld);

// That most of the pages is empty, unless a least filled share was asked for.
std::optional<std::string> warning_of_empty_pages(const Outcome& outcome, std::optional<double> least_fill);

#endif // UNWRAP_SUMMARY_H
