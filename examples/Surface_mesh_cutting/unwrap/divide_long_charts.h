#ifndef UNWRAP_DIVIDE_LONG_CHARTS_H
#define UNWRAP_DIVIDE_LONG_CHARTS_H

#include "Mesh.h"
#include "options.h"
#include "outcome.h"

// Packs like `pack()`. Where that fills less of the pages than asked for, charts that need a large square for their area
// are divided across, and packed again. Adds to the cut and its length, or warns that this is not worth it.
void pack_with_least_fill(const Mesh& mesh, Cut_map is_cut, UV_map uvs, double given_scale, const Options& options,
                          Outcome& outcome);

#endif // UNWRAP_DIVIDE_LONG_CHARTS_H
