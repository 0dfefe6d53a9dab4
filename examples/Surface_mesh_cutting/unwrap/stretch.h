// Distortion in terms that need no formula.

#ifndef UNWRAP_STRETCH_H
#define UNWRAP_STRETCH_H

#include <algorithm>
#include <cmath>

// The symmetric Dirichlet energy of a map that stretches by s one way, and by 1/s the other way, is 2 (s^2 + 1/s^2). This
// is the s of 1 or more for an energy; without distortion, the energy is 4 and s is 1.
inline double stretch_of(double energy)
{
  return std::exp(std::acosh((std::max)(1., energy / 4)) / 2);
}

inline double stretch_in_percent(double energy) { return 100 * (stretch_of(energy) - 1); }

#endif // UNWRAP_STRETCH_H
