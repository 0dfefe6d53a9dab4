#include "read_binary_off.h"

#include "Off_attributes.h"
#include "byte_order.h"
#include "outcome.h"
#include "stop_request.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

class Binary_off_reader
{
public:
  Binary_off_reader(std::string_view bytes, const Off_header& header, Attributes attributes)
    : m_bytes(bytes), m_header(header), m_is_big_endian(!is_little_endian(bytes, header)), m_attributes(header, attributes)
  {}

  Polygon_soup run()
  {
    if(m_header.has_dimension)
      check_off_dimension(next_index());
    const int number_of_points = next_index(), number_of_polygons = next_index();
    next<std::int32_t>(); // the number of edges
    if(number_of_points == 0 && number_of_polygons == 0)
      throw Failure(Exit_code::UNREADABLE, "the file has neither points nor faces");
    for(int i = 0; i < number_of_points; ++i)
      read_point();
    for(int i = 0; i < number_of_polygons; ++i)
      read_polygon();
    m_attributes.complete(m_soup);
    return std::move(m_soup);
  }

private:
  // The format is big-endian, but some programs write what their machine has: then the file has room for the number of
  // points only if it is read so.
  static bool is_little_endian(std::string_view bytes, const Off_header& header)
  {
    const std::size_t place = header.has_dimension ? sizeof(std::int32_t) : 0;
    if(bytes.size() < place + sizeof(std::int32_t))
      return false;
    const std::size_t room = bytes.size() / (sizeof(float) * std::size_t(header.number_of_coordinates()));
    const auto has_room = [&](bool is_big_endian)
    { return std::size_t(load<std::uint32_t>(bytes.substr(place), is_big_endian)) <= room; };
    return has_room(false) && !has_room(true);
  }

  template <typename Number>
  Number next()
  {
    if(m_bytes.size() < sizeof(Number))
      throw Failure(Exit_code::UNREADABLE, "the file ends before its last element");
    const Number number = load<Number>(m_bytes, m_is_big_endian);
    m_bytes.remove_prefix(sizeof(Number));
    return number;
  }

  int next_index()
  {
    const std::int32_t index = next<std::int32_t>();
    if(index < 0)
      throw Failure(Exit_code::UNREADABLE, "a count or an index is negative");
    return index;
  }

  const std::vector<double>& next_numbers(int number)
  {
    m_numbers.clear();
    for(int i = 0; i < number; ++i)
      m_numbers.push_back(double(next<float>()));
    return m_numbers;
  }

  void read_point()
  {
    std::array<double, 4> x = {{0, 0, 0, 1}};
    for(int i = 0; i < m_header.number_of_coordinates(); ++i)
      x[std::size_t(i)] = double(next<float>());
    m_soup.points.push_back({{x[0] / x[3], x[1] / x[3], x[2] / x[3]}});
    m_attributes.add_point(next_numbers((m_header.has_normal ? 3 : 0) + (m_header.has_color ? 4 : 0) + (m_header.has_uv ? 2 : 0)),
                           m_soup);
    ask_for_stop(m_soup.points.size());
  }

  void read_polygon()
  {
    const int size = next_index();
    for(int k = 0; k < size; ++k)
      m_soup.corners.push_back(next_index());
    m_soup.close_polygon();
    m_attributes.add_polygon(next_numbers(next_index()), m_soup);
    ask_for_stop(m_soup.polygon_ends.size());
  }

  static void ask_for_stop(std::size_t number_of_elements)
  {
    constexpr std::size_t elements_per_question = 4096;
    if(number_of_elements % elements_per_question == 0)
      end_if_stop_is_requested();
  }

  std::string_view m_bytes; // that are not read yet
  const Off_header m_header;
  const bool m_is_big_endian;
  Off_attributes m_attributes;
  Polygon_soup m_soup;
  std::vector<double> m_numbers;
};

} // namespace

Polygon_soup read_binary_off(std::string_view bytes, const Off_header& header, Attributes attributes)
{
  return Binary_off_reader(bytes, header, attributes).run();
}
