// Charts moved into the unit square.

#ifndef UNWRAP_PACK_H
#define UNWRAP_PACK_H

#include "Mesh.h"
#include "options.h"
#include "outcome.h"

// Whether charts are packed: not where they keep the surface's scale.
bool has_packing(const Options& options);

constexpr double share_without_packing = 0.9; // of a run, for its progress

// Packs as the options ask for, and tells the number of charts, their scale and how much of the square they fill.
// `given_scale` is that of the UVs, in their units per unit of length. Throws a `Failure` where that is not possible.
void pack(const Mesh& mesh, Cut_map is_cut, UV_map uvs, double given_scale, const Options& options, Outcome& outcome);

#endif // UNWRAP_PACK_H
