#include "html_writer.h"

#include "base64.h"
#include "distortion_image.h"
#include "file_extension.h"
#include "layout_energies.h"
#include "outcome.h"
#include "page_parts.h"
#include "three_js.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace {

template <typename Number, typename Rows>
std::string to_buffer(const char* id, const Rows& rows)
{
  std::vector<Number> numbers;
  for(const auto& row : rows)
    for(const auto number : row)
      numbers.push_back(Number(number));
  const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  return std::string("<script type=\"text/plain\" id=\"") + id + "\">" + to_base64(bytes) + "</script>\n";
}

template <typename Number, typename Value>
std::string to_column(const char* id, const std::vector<Value>& values)
{
  std::vector<std::array<Value, 1> > rows;
  for(const Value value : values)
    rows.push_back({{value}});
  return to_buffer<Number>(id, rows);
}

// Coordinates of type `float` suffice around the middle of the surface. Points that no face uses are there.
std::vector<std::array<double, 3> > centered_points(const Layout& layout)
{
  std::vector<std::array<double, 3> > points(layout.points.size(), {{0, 0, 0}});
  for(std::size_t i = 0; i < 3 && !layout.corners.empty(); ++i)
  {
    double low = layout.points[std::size_t(layout.corners.front())][i], high = low;
    for(const int v : layout.corners)
    {
      low = (std::min)(low, layout.points[std::size_t(v)][i]);
      high = (std::max)(high, layout.points[std::size_t(v)][i]);
    }
    for(const int v : layout.corners)
      points[std::size_t(v)][i] = layout.points[std::size_t(v)][i] - (0.5 * low + 0.5 * high);
  }
  return points;
}

std::string to_buffers(const Layout& layout)
{
  std::vector<std::array<double, 3> > points = centered_points(layout);
  for(auto& p : points)
    for(double& coordinate : p)
      coordinate /= layout.bounding_box_diagonal;
  return to_buffer<float>("points", points) + to_buffer<float>("uvs", layout.uv_points)
       + to_buffer<std::uint32_t>("triangles", layout.triangles)
       + to_buffer<std::uint32_t>("uv-triangles", layout.uv_triangles) + to_column<float>("energies", layout_energies(layout))
       + to_buffer<std::uint32_t>("cut", layout.cut) + to_buffer<std::uint32_t>("borders", layout.chart_borders)
       + to_column<std::uint32_t>("features", layout.feature_points);
}

// No text within may end the element that holds it.
std::string escaped(std::string_view json)
{
  std::string text;
  for(const char c : json)
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

// Models for printers stand on the plane of x and y.
std::string up_axis(const Options& options)
{
  return !options.up.empty() ? options.up : is_for_printing(options.input) ? "z" : "y";
}

// The bounds that were asked for; null stands for none.
nlohmann::ordered_json bounds(const Options& options)
{
  const auto or_null = [](const std::optional<double>& bound)
  { return bound ? nlohmann::ordered_json(*bound) : nlohmann::ordered_json(); };
  return {{"mean", or_null(options.maximum_average_distortion)},
          {"faces", or_null(options.maximum_face_distortion)},
          {"face_quantile", options.face_quantile},
          {"charts", or_null(options.maximum_chart_distortion)}};
}

std::string facts(const Layout& layout, const Options& options)
{
  const nlohmann::ordered_json facts = {{"name", std::filesystem::path(name_of_input(options.input)).filename().string()},
                                        {"margin", options.margin},
                                        {"texture_size", options.texture_size},
                                        {"diagonal", layout.bounding_box_diagonal},
                                        {"up", up_axis(options)},
                                        {"bounds", bounds(options)},
                                        {"ramp", distortion_colors}};
  return facts.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace

void check_page_can_be_made()
{
  if(!has_three_js())
    throw Failure(Exit_code::USAGE, "--html needs three.js, of Debian's package libjs-three, when the program is configured and when it runs");
}

std::string to_html(const Layout& layout, const std::string& report, const Options& options)
{
  std::string page;
  std::string_view rest = page_html;
  const auto insert = [&](std::string_view mark, std::string_view text)
  {
    const std::size_t place = rest.find(mark);
    page.append(rest.substr(0, place)).append(text);
    rest.remove_prefix(place + mark.size());
  };
  insert("{{css}}", page_css);
  insert("{{report}}", escaped(report));
  insert("{{facts}}", escaped(facts(layout, options)));
  insert("{{buffers}}", to_buffers(layout));
  insert("{{three}}", three_js());
  insert("{{js}}", page_js);
  return page.append(rest);
}
