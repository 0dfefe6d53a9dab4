#include "summary.h"

#include "stretch.h"

#include <sstream>

namespace {

void write_number(double number, int digits, std::ostream& out)
{
  std::ostringstream text;
  text.precision(digits);
  text << number;
  out << std::stod(text.str()); // 120, not 1.2e+02
}

std::string counted(int number, const std::string& one, const std::string& many)
{
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

} // namespace

std::string summary(const Outcome& outcome)
{
  std::ostringstream text;
  text << (*outcome.polygons == 0 ? counted(*outcome.faces, "triangle", "triangles")
                                  : counted(*outcome.faces, "polygon", "polygons"))
       << " in " << counted(*outcome.charts, "chart", "charts");
  if(outcome.average_energy) // else some triangles are clockwise
  {
    text << ", stretched by ";
    write_number(stretch_in_percent(*outcome.average_energy), 2, text);
    text << " % on average (energy ";
    write_number(*outcome.average_energy, 4, text);
    text << ")";
  }
  text << ", cut of ";
  write_number(*outcome.cut_length, 4, text);
  text << " bounding box diagonals";
  if(const std::optional<double> fill = outcome.mean_fill())
  {
    text << ", ";
    write_number(100 * *fill, 3, text);
    text << " % of " << (outcome.fills.size() == 1 ? "the square" : std::to_string(outcome.fills.size()) + " pages")
         << " filled";
  }
  return text.str();
}

std::optional<std::string> warning_of_many_charts(const Outcome& outcome, const std::string& weld)
{
  constexpr int many = 100, few_faces = 10; // charts, faces of each
  if(*outcome.charts < many || *outcome.faces > few_faces * *outcome.charts)
    return std::nullopt;
  return "the layout has " + std::to_string(*outcome.charts) + " charts for " + std::to_string(*outcome.faces)
         + " faces, since the surface consists of so many parts"
         + (weld == "on" ? "" : "; --weld on connects parts whose vertices are at the same points");
}

std::optional<std::string> warning_of_empty_pages(const Outcome& outcome, std::optional<double> least_fill)
{
  constexpr double little = 0.25;
  const std::optional<double> fill = outcome.mean_fill();
  if(least_fill || !fill || *fill >= little)
    return std::nullopt;
  std::ostringstream text;
  text << "most of the texture is empty: charts fill ";
  write_number(100 * *fill, 3, text);
  text << " % of it; --min-fill divides long ones";
  return text.str();
}
