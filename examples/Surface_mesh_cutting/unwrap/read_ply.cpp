#include "Ply_header.h"
#include "Ply_source.h"
#include "Ply_values.h"
#include "Text_scanner.h"
#include "complete_normals.h"
#include "mesh_file.h"
#include "outcome.h"
#include "point_uvs.h"
#include "triangle_strip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using Type = Ply_header::Type;
using Property = Ply_header::Property;
using Element = Ply_header::Element;

void skip(const Property& property, Ply_values& values)
{
  const int size = property.is_list ? values.next_index(property.size_type) : 1;
  for(int i = 0; i < size; ++i)
    values.next(property.type);
}

// Colors are fractions of the largest value of their type, or of 1.
double largest_color(Type type)
{
  return type == Type::FLOAT32 || type == Type::FLOAT64 ? 1 : type == Type::UINT16 ? 65535 : 255;
}

// What is read of a point: coordinates, then a normal, a color, and texture coordinates.
struct Point_properties
{
  Point_properties(const Element& element, Attributes attributes)
    : slots(element.properties.size(), -1)
  {
    const auto find = [&](int slot, std::string_view name_1, std::string_view name_2 = {})
    {
      const int property = element.find(name_1, name_2);
      if(property < 0 || element.properties[std::size_t(property)].is_list)
        return false;
      slots[std::size_t(property)] = slot;
      return true;
    };
    if(!find(0, "x") || !find(1, "y") || !find(2, "z"))
      throw Failure(Exit_code::UNREADABLE, "the points have no properties x, y, z");
    if(attributes.has_looks)
      find_looks(find);
    if(!attributes.has_uvs)
      return;
    int slot = first_uv;
    for(const int property : element.find_point_uv())
      slots[std::size_t(property)] = slot++;
    has_uvs = slot > first_uv;
  }

  template <typename Find>
  void find_looks(Find find)
  {
    const bool has_nx = find(3, "nx"), has_ny = find(4, "ny"), has_nz = find(5, "nz");
    has_normals = has_nx && has_ny && has_nz;
    has_colors = find(first_color, "red", "diffuse_red");
    find(first_color + 1, "green", "diffuse_green");
    find(first_color + 2, "blue", "diffuse_blue");
  }

  static double scale(int slot, Type type)
  {
    return slot >= first_color && slot < first_uv ? largest_color(type) : 1;
  }

  static constexpr int first_color = 6, first_uv = 9, number_of_slots = 11;

  std::vector<int> slots; // per property, where in this order, -1 for nowhere
  bool has_normals = false, has_colors = false, has_uvs = false;
};

// Where values of a file are to be replaced; null if nobody asks.
using Places = std::vector<Ply_source::Place>;

// What the elements of points have.
class Point_reader
{
public:
  Point_reader(Attributes attributes, Places* places, Polygon_soup& soup)
    : m_attributes(attributes), m_places(places), m_soup(soup)
  {}

  void read(const Element& element, Ply_values& values)
  {
    const Point_properties properties(element, m_attributes);
    const std::vector<int> uv = m_places != nullptr && m_attributes.uv_set == 0 ? element.find_point_uv() : std::vector<int>();
    m_soup.points.reserve((std::min)(std::size_t(element.number), values.maximum_number()));
    for(int i = 0; i < element.number; ++i)
    {
      for(int p = 0; p < int(element.properties.size()); ++p)
      {
        const std::size_t begin = p == 0 ? values.next_begin() : values.end();
        read_value(element.properties[std::size_t(p)], properties.slots[std::size_t(p)], values);
        if(std::find(uv.begin(), uv.end(), p) != uv.end())
          m_places->push_back({begin, values.end(), Ply_source::Content::POINT_UV});
      }
      values.end_element();
      add_point(properties);
    }
    if(!m_uvs.empty())
      m_uvs.resize(m_soup.points.size());
  }

  const Point_uvs& uvs() const { return m_uvs; }

private:
  void read_value(const Property& property, int slot, Ply_values& values)
  {
    if(slot < 0)
      skip(property, values);
    else
      m_numbers[std::size_t(slot)] = values.next(property.type) / Point_properties::scale(slot, property.type);
  }

  void add_point(const Point_properties& properties)
  {
    const auto three = [&](std::size_t first)
    { return std::array<double, 3>{{m_numbers[first], m_numbers[first + 1], m_numbers[first + 2]}}; };
    m_soup.points.push_back(three(0));
    if(properties.has_normals)
      m_soup.normals.push_back(three(3));
    if(properties.has_colors)
      m_soup.colors.push_back(three(Point_properties::first_color));
    if(properties.has_uvs)
    {
      const std::size_t first = Point_properties::first_uv;
      m_uvs.resize(m_soup.points.size());
      m_uvs.back() = {{m_numbers[first], m_numbers[first + 1]}};
    }
  }

  const Attributes m_attributes;
  Places* const m_places;
  Polygon_soup& m_soup;
  Point_uvs m_uvs;
  std::array<double, Point_properties::number_of_slots> m_numbers = {};
};

// What is given for each point must be given for all, also where there are several elements of points.
void complete_point_attributes(Polygon_soup& soup)
{
  if(soup.colors.size() != soup.points.size())
    soup.colors.clear();
  if(soup.normals.size() != soup.points.size())
    soup.normals.clear();
  if(!soup.normals.empty())
    soup.corner_normals = soup.corners;
  complete_normals(soup);
}

void add_notes(const Ply_header& header, Polygon_soup& soup)
{
  const Data_kinds kinds = header.kinds();
  soup.kinds.insert(kinds.begin(), kinds.end());
  for(const std::string_view comment : header.comments)
    if(!comment.empty())
      soup.obj_statements.lines.push_back({-1, (comment.front() == '#' ? "" : "# ") + std::string(comment)});
}

// The position of the property that lists the vertices of an element of `polygons`.
int find_vertex_indices(const Element& element, const std::string& polygons)
{
  const int indices = element.find("vertex_indices", "vertex_index");
  if(indices < 0 || !element.properties[std::size_t(indices)].is_list)
    throw Failure(Exit_code::UNREADABLE, "the " + polygons + " have no list of vertex indices");
  return indices;
}

// Repeated vertices only lead from one part of a strip to the next.
void add_strip(const std::vector<int>& vertices, Attributes attributes, Polygon_soup& soup)
{
  const std::vector<int> corners = triangles_of_strip(vertices);
  for(std::size_t k = 0; k < corners.size(); k += 3)
    if(corners[k] != corners[k + 1] && corners[k] != corners[k + 2] && corners[k + 1] != corners[k + 2])
    {
      soup.corners.insert(soup.corners.end(), &corners[k], &corners[k] + 3);
      if(attributes.has_uvs)
        soup.corner_uvs.insert(soup.corner_uvs.end(), 3, std::nullopt);
      soup.close_polygon();
    }
}

void read_corners(const Property& property, Ply_values& values, Polygon_soup& soup)
{
  const int size = values.next_index(property.size_type);
  for(int k = 0; k < size; ++k)
    soup.corners.push_back(values.next_index(property.type));
}

std::vector<double> read_list(const Property& property, Ply_values& values)
{
  std::vector<double> numbers;
  const int size = values.next_index(property.size_type);
  for(int i = 0; i < size; ++i)
    numbers.push_back(values.next(property.type));
  return numbers;
}

// `texture` holds the two coordinates of each corner, or nothing.
void add_uvs(const std::vector<double>& texture, int number_of_corners, Polygon_soup& soup)
{
  if(!texture.empty() && texture.size() != 2 * std::size_t(number_of_corners))
    throw Failure(Exit_code::UNREADABLE, "face " + std::to_string(soup.number_of_polygons())
                                           + " does not have two texture coordinates for each corner",
                  {Witness::Kind::FACES, {soup.number_of_polygons()}});
  for(std::size_t k = 0; k < std::size_t(number_of_corners); ++k)
    soup.corner_uvs.push_back(texture.empty() ? std::nullopt : std::make_optional<Polygon_soup::Texture_point>(
                                                                 {{texture[2 * k], texture[2 * k + 1]}}));
}

// `places` gets where the texture coordinates of each polygon are to be written, unless it is null.
void read_polygons(const Element& element, Attributes attributes, Ply_values& values, Polygon_soup& soup,
                   Places* places)
{
  const int indices = find_vertex_indices(element, "faces"), replaced = element.find(Ply_header::name_of_uvs(attributes.uv_set)),
            uvs = replaced >= 0 ? replaced : element.find(Ply_header::name_of_uvs(0));
  const bool does_read_uvs = attributes.has_uvs && uvs >= 0 && element.properties[std::size_t(uvs)].is_list;

  soup.polygon_ends.reserve((std::min)(std::size_t(element.number), values.maximum_number()));
  for(int i = 0; i < element.number; ++i)
  {
    std::vector<double> texture;
    const std::size_t first_corner = soup.corners.size();
    for(int p = 0; p < int(element.properties.size()); ++p)
    {
      const Property& property = element.properties[std::size_t(p)];
      const std::size_t begin = p == replaced && places != nullptr ? values.next_begin() : 0;
      if(p == indices)
        read_corners(property, values, soup);
      else if(p == uvs && does_read_uvs)
        texture = read_list(property, values);
      else
        skip(property, values);
      if(p == replaced && places != nullptr)
        places->push_back({begin, values.end(), Ply_source::Content::TEXTURE_COORDINATES});
    }
    if(replaced < 0 && places != nullptr)
      places->push_back({values.end(), values.end(), Ply_source::Content::TEXTURE_COORDINATES});
    values.end_element();
    if(attributes.has_uvs)
      add_uvs(texture, int(soup.corners.size() - first_corner), soup);
    soup.close_polygon();
  }
}

// One list may hold several strips, with -1 between them.
void read_list_of_strips(const Property& property, Attributes attributes, Ply_values& values, Polygon_soup& soup)
{
  std::vector<int> strip;
  for(int size = values.next_index(property.size_type); size > 0; --size)
    if(const std::optional<int> vertex = values.next_index_or_end(property.type))
      strip.push_back(*vertex);
    else
      add_strip(std::exchange(strip, {}), attributes, soup);
  add_strip(strip, attributes, soup);
}

void read_strips(const Element& element, Attributes attributes, Ply_values& values, Polygon_soup& soup)
{
  const int indices = find_vertex_indices(element, "triangle strips");
  for(int i = 0; i < element.number; ++i)
  {
    for(int p = 0; p < int(element.properties.size()); ++p)
      if(p == indices)
        read_list_of_strips(element.properties[std::size_t(p)], attributes, values, soup);
      else
        skip(element.properties[std::size_t(p)], values);
    values.end_element();
  }
}

void skip_elements(const Element& element, Ply_values& values)
{
  for(int i = 0; i < element.number && !element.properties.empty(); ++i)
  {
    for(const Property& property : element.properties)
      skip(property, values);
    values.end_element();
  }
}

std::string end_of_line(std::string_view line)
{
  const std::size_t end = line.find_last_not_of("\r\n");
  return std::string(line.substr(end == std::string_view::npos ? 0 : end + 1));
}

// With the places in its header.
Ply_source make_source(const Ply_header& header, int uv_set, std::string_view bytes)
{
  using Content = Ply_source::Content;
  Ply_source source = {std::string(bytes), header.format, end_of_line(header.format_line), {}};
  const auto add = [&](std::string_view text, Content content)
  {
    const std::size_t begin = std::size_t(text.data() - bytes.data());
    source.places.push_back({begin, begin + text.size(), content});
  };
  const auto behind = [](std::string_view line) { return line.substr(line.size()); };
  add(behind(header.format_line), Content::IMAGE);
  for(const std::string_view line : header.image_lines)
    add(line, Content::FORMER_IMAGE);
  for(const Element& element : header.elements)
  {
    if(const int uvs = element.find(Ply_header::name_of_uvs(uv_set)); element.has_polygons() && !element.properties.empty())
      add(uvs < 0 ? behind(element.properties.back().line) : element.properties[std::size_t(uvs)].line,
          Content::PROPERTY);
    if(element.has_points() && uv_set == 0)
      for(const int property : element.find_point_uv())
        add(element.properties[std::size_t(property)].line, Content::POINT_UV);
  }
  std::sort(source.places.begin(), source.places.end(),
            [](const Ply_source::Place& a, const Ply_source::Place& b)
            { return std::make_pair(a.begin, a.end) < std::make_pair(b.begin, b.end); });
  return source;
}

} // namespace

Polygon_soup read_ply(std::string_view bytes, Attributes attributes)
{
  bytes = without_byte_order_mark(bytes);
  Text_scanner scanner(bytes);
  const Ply_header header = read_ply_header(scanner);
  Ply_values values(header, scanner, bytes);
  const bool has_strips = std::any_of(header.elements.begin(), header.elements.end(),
                                      [](const Element& element) { return element.has_strips(); });
  const std::shared_ptr<Ply_source> source // whose corners have a place for texture coordinates
    = attributes.has_source && !has_strips ? std::make_shared<Ply_source>(make_source(header, attributes.uv_set, bytes)) : nullptr;
  Places* const places = source ? &source->places : nullptr;
  Polygon_soup soup;
  Point_reader points(attributes, places, soup);
  for(const Element& element : header.elements)
  {
    if(element.has_points())
      points.read(element, values);
    else if(element.has_polygons())
      read_polygons(element, attributes, values, soup, places);
    else if(element.has_strips())
      read_strips(element, attributes, values, soup);
    else
      skip_elements(element, values);
  }
  complete_point_attributes(soup);
  if(attributes.has_looks)
    add_notes(header, soup);
  const auto has_value = [](const auto& uv) { return uv.has_value(); };
  if(!points.uvs().empty() && std::none_of(soup.corner_uvs.begin(), soup.corner_uvs.end(), has_value))
    set_corner_uvs(points.uvs(), soup);
  soup.ply_source = source;
  return soup;
}
