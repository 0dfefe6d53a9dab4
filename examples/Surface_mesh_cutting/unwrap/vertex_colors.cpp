#include "vertex_colors.h"

#include "outcome.h"

#include <algorithm>
#include <string_view>

void read_red(Text_scanner& scanner, Polygon_soup& soup)
{
  const std::string_view red = scanner.word_in_line();
  const std::string_view green = scanner.word_in_line(), blue = scanner.word_in_line();
  if(!red.empty() && !green.empty() && !blue.empty())
    soup.reds.push_back(scanner.to_number(red));
}

void complete_reds(Polygon_soup& soup)
{
  constexpr double largest = 255;
  if(soup.reds.size() != soup.points.size())
    soup.reds.clear();
  double maximum = 0;
  for(std::size_t i = 0; i < soup.reds.size(); ++i)
  {
    if(!(soup.reds[i] >= 0 && soup.reds[i] <= largest))
      throw Failure(Exit_code::UNREADABLE, "the color of vertex " + std::to_string(i) + " is not from 0 to 255",
                    {Witness::Kind::VERTICES, {int(i)}});
    maximum = (std::max)(maximum, soup.reds[i]);
  }
  if(maximum > 1)
    for(double& red : soup.reds)
      red /= largest;
}
