// The whole program but the command line and the messages.

#ifndef UNWRAP_UNWRAP_FILE_H
#define UNWRAP_UNWRAP_FILE_H

#include "Layout.h"
#include "Output_places.h"
#include "Polygon_soup.h"
#include "options.h"
#include "outcome.h"

// Checks, cuts and flattens a soup, and tells `outcome` about it. Throws a `Failure` if the soup is refused.
// The layout is filled if `outcome.has_result`.
Layout unwrap_soup(const Polygon_soup& soup, const Options& options, Outcome& outcome);

// Reads, unwraps and writes what the options ask for. Whatever goes wrong becomes an outcome, of
// which the report may be written where `places` says.
Outcome unwrap_file(const Options& options, Output_places& places);

#endif // UNWRAP_UNWRAP_FILE_H
