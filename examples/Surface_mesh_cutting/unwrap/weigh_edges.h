// What `--edge-weights` makes cuts cost.

#ifndef UNWRAP_WEIGH_EDGES_H
#define UNWRAP_WEIGH_EDGES_H

#include "Polygon_soup.h"
#include "Surface.h"
#include "weight_choice.h"

#include <vector>

// The lengths of the edges times the factors of all choices. A file of edges gives weights instead: their
// factor is weight over length. `surface` is read from the soup.
// Throws a `Failure`: `Exit_code::UNREADABLE` if a file cannot be read or has an index out of range,
// `Exit_code::UNSUPPORTED` if it names an edge that the mesh does not have, or if there are no colors.
void weigh_edges(const std::vector<Weight_choice>& choices, const Polygon_soup& soup, Surface& surface,
                 Mesh::Property_map<Edge, double> weights);

#endif // UNWRAP_WEIGH_EDGES_H
