// The words that `--edge-weights` takes.

#ifndef UNWRAP_WEIGHT_CHOICE_H
#define UNWRAP_WEIGHT_CHOICE_H

#include <array>
#include <optional>
#include <string>

struct Weight_choice
{
  enum class Kind { CREASE, CONCAVE, STRAIGHT, VISIBILITY, OCCLUSION, SKY, COLORS, PAINT, EDGES };

  Kind kind = Kind::EDGES;
  std::string file; // of PAINT and EDGES
  std::array<int, 3> up = {{0, 1, 0}}; // of SKY
};

// `word` is one of the names, `sky:AXIS`, `paint:FILE` or, if it is nothing of the kind, a file with weights of
// edges. No value stands for an axis or a file that is missing or unknown.
std::optional<Weight_choice> parse_weight_choice(const std::string& word);

#endif // UNWRAP_WEIGHT_CHOICE_H
