#ifndef UNWRAP_SURFACE_NUMBERS_H
#define UNWRAP_SURFACE_NUMBERS_H

#include "Mesh.h"
#include "outcome.h"

// Tells the numbers of components, handles and borders.
void tell_numbers(const Mesh& mesh, Outcome& outcome);

#endif // UNWRAP_SURFACE_NUMBERS_H
