#include "Text_scanner.h"
#include "byte_order.h"
#include "mesh_file.h"
#include "outcome.h"
#include "vertex_colors.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

enum class Format { TEXT, LITTLE, BIG };
enum class Type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

struct Property
{
  std::string name;
  Type type;
  bool is_list;
  Type size_type; // of a list
};

struct Element
{
  std::string name;
  int number;
  std::vector<Property> properties;

  // The position of the first property that has one of the names, -1 if there is none.
  int find(std::string_view name_1, std::string_view name_2 = {}) const
  {
    const auto found = std::find_if(properties.begin(), properties.end(), [&](const Property& p)
                                    { return p.name == name_1 || p.name == name_2; });
    return found == properties.end() ? -1 : int(found - properties.begin());
  }
};

struct Header
{
  Format format;
  std::vector<Element> elements;
};

Type read_type(Text_scanner& scanner)
{
  static const std::vector<std::vector<std::string_view> > names = {
    {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"}, {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
  const std::string_view word = scanner.word_in_line();
  for(std::size_t i = 0; i < names.size(); ++i)
    if(word == names[i][0] || word == names[i][1])
      return Type(i);
  scanner.fail("a type", word);
}

Format read_format(Text_scanner& scanner)
{
  const std::string_view word = scanner.word_in_line();
  if(word == "ascii")
    return Format::TEXT;
  if(word == "binary_little_endian")
    return Format::LITTLE;
  if(word == "binary_big_endian")
    return Format::BIG;
  scanner.fail("a format", word);
}

Property read_property(Text_scanner& scanner)
{
  Property property = {};
  const Text_scanner start = scanner;
  property.is_list = scanner.word_in_line() == "list";
  if(property.is_list)
    property.size_type = read_type(scanner);
  else
    scanner = start;
  property.type = read_type(scanner);
  property.name = std::string(scanner.word_in_line());
  return property;
}

Header read_header(Text_scanner& scanner)
{
  if(const std::string_view word = scanner.word(); word != "ply")
    scanner.fail("ply", word);
  Header header = {};
  for(bool has_format = false;;)
  {
    scanner.skip_line();
    const std::string_view keyword = scanner.word();
    if(keyword == "format")
    {
      header.format = read_format(scanner);
      has_format = true;
    }
    else if(keyword == "element")
    {
      const std::string name(scanner.word_in_line());
      header.elements.push_back({name, scanner.index_in_line(), {}});
    }
    else if(keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(read_property(scanner));
    else if(keyword == "end_header" && has_format)
    {
      scanner.skip_line();
      return header;
    }
    else if(keyword != "comment" && keyword != "obj_info")
      scanner.fail("a line of a PLY header", keyword);
  }
}

// The values behind the header, one after the other.
class Values
{
public:
  Values(Format format, Text_scanner scanner)
    : m_format(format), m_scanner(scanner), m_bytes(scanner.rest())
  {}

  double next(Type type)
  {
    if(m_format == Format::TEXT)
      return m_scanner.number();
    switch(type)
    {
      case Type::INT8: return next_binary<std::int8_t>();
      case Type::UINT8: return next_binary<std::uint8_t>();
      case Type::INT16: return next_binary<std::int16_t>();
      case Type::UINT16: return next_binary<std::uint16_t>();
      case Type::INT32: return next_binary<std::int32_t>();
      case Type::UINT32: return next_binary<std::uint32_t>();
      case Type::FLOAT32: return next_binary<float>();
      case Type::FLOAT64: return next_binary<double>();
    }
    return 0;
  }

  // A value that serves as a count or as an index.
  int next_index(Type type)
  {
    const double value = next(type);
    if(!(value >= 0 && value <= INT_MAX) || value != std::floor(value))
      throw Failure(Exit_code::UNREADABLE, "a count or an index is not a number from 0 to "
                                             + std::to_string(INT_MAX));
    return int(value);
  }

  // A bound for the number of values to come.
  std::size_t maximum_number() const
  {
    return m_format == Format::TEXT ? m_scanner.rest().size() : m_bytes.size();
  }

private:
  template <typename Number>
  double next_binary()
  {
    if(m_bytes.size() < sizeof(Number))
      throw Failure(Exit_code::UNREADABLE, "the file ends before its last element");
    const double result = double(load<Number>(m_bytes, m_format == Format::BIG));
    m_bytes.remove_prefix(sizeof(Number));
    return result;
  }

  Format m_format;
  Text_scanner m_scanner;
  std::string_view m_bytes;
};

void skip(const Property& property, Values& values)
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

void add_red(double red, Polygon_soup& soup)
{
  if(!(red >= 0 && red <= 1))
    throw Failure(Exit_code::UNREADABLE, "the color of vertex " + std::to_string(soup.reds.size()) + " is out of range",
                  {Witness::Kind::VERTICES, {int(soup.reds.size())}});
  soup.reds.push_back(red);
}

void read_points(const Element& element, Attributes attributes, Values& values, Polygon_soup& soup)
{
  const int x = element.find("x"), y = element.find("y"), z = element.find("z");
  const int red = attributes.has_colors ? element.find("red", "diffuse_red") : -1;
  for(const int coordinate : {x, y, z})
    if(coordinate < 0 || element.properties[std::size_t(coordinate)].is_list)
      throw Failure(Exit_code::UNREADABLE, "the points have no properties x, y, z");

  soup.points.reserve((std::min)(std::size_t(element.number), values.maximum_number()));
  for(int i = 0; i < element.number; ++i)
  {
    Polygon_soup::Point point = {};
    for(int p = 0; p < int(element.properties.size()); ++p)
    {
      const Property& property = element.properties[std::size_t(p)];
      if(p == x || p == y || p == z)
        point[p == x ? 0 : p == y ? 1 : 2] = values.next(property.type);
      else if(p == red && !property.is_list)
        add_red(values.next(property.type) / largest_color(property.type), soup);
      else
        skip(property, values);
    }
    soup.points.push_back(point);
  }
}

void read_corners(const Property& property, Values& values, Polygon_soup& soup)
{
  const int size = values.next_index(property.size_type);
  for(int k = 0; k < size; ++k)
    soup.corners.push_back(values.next_index(property.type));
}

std::vector<double> read_list(const Property& property, Values& values)
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
  const bool is_finite = std::all_of(texture.begin(), texture.end(), [](double x) { return std::isfinite(x); });
  if(!is_finite || (!texture.empty() && texture.size() != 2 * std::size_t(number_of_corners)))
    throw Failure(Exit_code::UNREADABLE, "face " + std::to_string(soup.number_of_polygons())
                                           + " does not have two finite texture coordinates for each corner",
                  {Witness::Kind::FACES, {soup.number_of_polygons()}});
  for(std::size_t k = 0; k < std::size_t(number_of_corners); ++k)
    soup.corner_uvs.push_back(texture.empty() ? std::nullopt : std::make_optional<Polygon_soup::Texture_point>(
                                                                 {{texture[2 * k], texture[2 * k + 1]}}));
}

void read_polygons(const Element& element, Attributes attributes, Values& values, Polygon_soup& soup)
{
  const int indices = element.find("vertex_indices", "vertex_index");
  if(indices < 0 || !element.properties[std::size_t(indices)].is_list)
    throw Failure(Exit_code::UNREADABLE, "the faces have no list of vertex indices");
  int uvs = attributes.has_uvs ? element.find("texcoord") : -1;
  if(uvs >= 0 && !element.properties[std::size_t(uvs)].is_list)
    uvs = -1;

  soup.polygon_ends.reserve((std::min)(std::size_t(element.number), values.maximum_number()));
  for(int i = 0; i < element.number; ++i)
  {
    std::vector<double> texture;
    const std::size_t first_corner = soup.corners.size();
    for(int p = 0; p < int(element.properties.size()); ++p)
    {
      const Property& property = element.properties[std::size_t(p)];
      if(p == indices)
        read_corners(property, values, soup);
      else if(p == uvs)
        texture = read_list(property, values);
      else
        skip(property, values);
    }
    if(attributes.has_uvs)
      add_uvs(texture, int(soup.corners.size() - first_corner), soup);
    soup.close_polygon();
  }
}

} // namespace

Polygon_soup read_ply(std::string_view bytes, Attributes attributes)
{
  Text_scanner scanner(bytes);
  const Header header = read_header(scanner);
  Values values(header.format, scanner);
  Polygon_soup soup;
  for(const Element& element : header.elements)
  {
    if(element.name == "vertex" || element.name == "vertices")
      read_points(element, attributes, values, soup);
    else if(element.name == "face" || element.name == "faces")
      read_polygons(element, attributes, values, soup);
    else if(element.name == "tristrips")
      throw Failure(Exit_code::UNREADABLE, "triangle strips are not supported");
    else
      for(int i = 0; i < element.number && !element.properties.empty(); ++i)
        for(const Property& property : element.properties)
          skip(property, values);
  }
  complete_reds(soup);
  return soup;
}
