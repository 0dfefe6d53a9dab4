// The words that `--edge-weights` takes.

#ifndef UNWRAP_WEIGHT_CHOICE_H
#define UNWRAP_WEIGHT_CHOICE_H

#include <array>
#include <optional>
#include <string>

struct Weight_choice
{
  enum class Kind { CREASE, CONCAVE, HARD, STRAIGHT, VISIBILITY, OCCLUSION, SKY, COLORS, PAINT, EDGES };

  Kind kind = Kind::EDGES;
  std::string file; // of PAINT and EDGES
  std::array<int, 3> up = {{0, 1, 0}}; // of SKY
};

// `word` is one of the names, `sky:AXIS`, `paint:FILE` or, if it is nothing of the kind, a file with weights of
// edges. No value stands for an axis or a file that is missing or unknown.
std::optional<Weight_choice> parse_weight_choice(const std::string& word);

// Throws a `Failure` with `Exit_code::UNREADABLE`, which lists the words, if what is taken for a file is none.
void check_is_word_or_file(const Weight_choice& choice);

#endif // UNWRAP_WEIGHT_CHOICE_H
