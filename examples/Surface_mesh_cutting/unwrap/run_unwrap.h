// The one place where the program meets the library.

#ifndef UNWRAP_RUN_UNWRAP_H
#define UNWRAP_RUN_UNWRAP_H

#include "Layout.h"
#include "Polygon_soup.h"
#include "Surface.h"
#include "options.h"
#include "outcome.h"

#include <string>
#include <vector>

// The names that `--solver` takes. The first one is the default.
std::vector<std::string> available_solvers();

// How many threads can run at a time; 1 if the program was built without TBB.
int available_threads();

// Cuts and flattens the surface as which a soup was read, and tells `outcome` about it.
// The layout is filled if `outcome.has_result`.
Layout run_unwrap(const Polygon_soup& soup, Surface& surface, const Options& options, Outcome& outcome);

#endif // UNWRAP_RUN_UNWRAP_H
