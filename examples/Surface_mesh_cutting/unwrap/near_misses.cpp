#include "near_misses.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace {

// How many letters have to be put in, taken out or changed (Levenshtein).
std::size_t edit_distance(const std::string& from, const std::string& to)
{
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for(std::size_t j = 0; j < to.size(); ++j)
    {
      const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = (std::min)({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// Whether enough letters begin the other word to tell it.
bool is_beginning(const std::string& word, const std::string& of)
{
  constexpr std::size_t shortest = 5; // with the dashes of an option
  return word.size() >= shortest && of.compare(0, word.size(), word) == 0;
}

} // namespace

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for(const std::string& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& words)
{
  constexpr std::size_t longest = 100;
  if(word.size() > longest || words.empty())
    return "";
  const auto distance = [&word](const std::string& other)
  {
    constexpr std::size_t rest = 2; // counts like so many letters
    const std::size_t letters = edit_distance(word, other);
    return is_beginning(word, other) || is_beginning(other, word) ? (std::min)(letters, rest) : letters;
  };
  const std::string& nearest = *std::min_element(
    words.begin(), words.end(), [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
  return 2 * distance(nearest) <= nearest.size() ? "; did you mean " + nearest + "?" : "";
}
