// Numbers and lengths of a surface.

#ifndef UNWRAP_SURFACE_NUMBERS_H
#define UNWRAP_SURFACE_NUMBERS_H

#include "Mesh.h"
#include "outcome.h"

int number_of_charts(const Mesh& mesh, Cut_map is_cut);

double edge_length(const Mesh& mesh, Edge e);

// The diagonal of the bounding box.
double diagonal_of(const Mesh& mesh);

// Tells the numbers of components, handles and borders.
void tell_numbers(const Mesh& mesh, Outcome& outcome);

#endif // UNWRAP_SURFACE_NUMBERS_H
