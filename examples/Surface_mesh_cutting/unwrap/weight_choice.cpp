#include "weight_choice.h"

#include "near_misses.h"
#include "outcome.h"

#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <vector>

namespace {

using Kind = Weight_choice::Kind;

std::optional<Weight_choice> parse_sky(const std::string& axis)
{
  static const std::map<std::string, std::array<int, 3> > directions
    = {{"x", {{1, 0, 0}}},   {"y", {{0, 1, 0}}},   {"z", {{0, 0, 1}}},
       {"-x", {{-1, 0, 0}}}, {"-y", {{0, -1, 0}}}, {"-z", {{0, 0, -1}}}};
  const auto found = directions.find(axis);
  if(found == directions.end())
    return std::nullopt;
  return Weight_choice{Kind::SKY, "", found->second};
}

const std::map<std::string, Kind> names_of_kinds
  = {{"crease", Kind::CREASE},         {"concave", Kind::CONCAVE},     {"hard", Kind::HARD},
     {"straight", Kind::STRAIGHT},
     {"visibility", Kind::VISIBILITY}, {"occlusion", Kind::OCCLUSION}, {"sky", Kind::SKY},
     {"colors", Kind::COLORS}};

} // namespace

void check_is_word_or_file(const Weight_choice& choice)
{
  std::error_code error;
  if(choice.kind != Kind::EDGES || std::filesystem::exists(choice.file, error) || error)
    return;
  std::vector<std::string> words;
  for(const auto& [name, kind] : names_of_kinds)
    words.push_back(name);
  throw Failure(Exit_code::UNREADABLE, choice.file + ": there is no such file, and --edge-weights knows the words "
                                         + joined(words) + " and paint:FILE" + suggestion(choice.file, words));
}

std::optional<Weight_choice> parse_weight_choice(const std::string& word)
{
  constexpr std::string_view sky = "sky:", paint = "paint:";
  Weight_choice choice;
  if(const auto found = names_of_kinds.find(word); found != names_of_kinds.end())
    choice.kind = found->second;
  else if(word.compare(0, sky.size(), sky) == 0)
    return parse_sky(word.substr(sky.size()));
  else if(word.compare(0, paint.size(), paint) == 0)
  {
    choice.kind = Kind::PAINT;
    choice.file = word.substr(paint.size());
    if(choice.file.empty())
      return std::nullopt;
  }
  else
    choice.file = word;
  return choice;
}
