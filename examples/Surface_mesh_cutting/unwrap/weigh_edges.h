// What `--edge-weights` makes cuts cost.

#ifndef UNWRAP_WEIGH_EDGES_H
#define UNWRAP_WEIGH_EDGES_H

#include "Mesh.h"
#include "Polygon_soup.h"
#include "weight_choice.h"

#include <vector>

// The lengths of the edges times the factors of all choices. A file of edges gives weights instead: their
// factor is weight over length. `soup` is what the mesh is made from.
// Throws a `Failure`: `Exit_code::UNREADABLE` if a file cannot be read or has an index out of range,
// `Exit_code::UNSUPPORTED` if it names an edge that the mesh does not have, or if there are no colors.
void weigh_edges(const std::vector<Weight_choice>& choices, const Polygon_soup& soup, Mesh& mesh,
                 Mesh::Property_map<Edge, double> weights);

#endif // UNWRAP_WEIGH_EDGES_H
