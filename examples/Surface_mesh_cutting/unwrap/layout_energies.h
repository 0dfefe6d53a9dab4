// The distortion of each triangle of a layout.

#ifndef UNWRAP_LAYOUT_ENERGIES_H
#define UNWRAP_LAYOUT_ENERGIES_H

#include "Layout.h"

#include <vector>

// Per triangle of the layout: the symmetric Dirichlet energy at the scale of the surface, 4 is ideal.
std::vector<double> layout_energies(const Layout& layout);

#endif // UNWRAP_LAYOUT_ENERGIES_H
