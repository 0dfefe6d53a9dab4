#include "Ply_header.h"

#include <algorithm>
#include <utility>

namespace {

using Type = Ply_header::Type;
using Property = Ply_header::Property;

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

Ply_header::Format read_format(Text_scanner& scanner)
{
  const std::string_view word = scanner.word_in_line();
  if(word == "ascii")
    return Ply_header::Format::TEXT;
  if(word == "binary_little_endian")
    return Ply_header::Format::LITTLE;
  if(word == "binary_big_endian")
    return Ply_header::Format::BIG;
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

// From the first of its words to the next line.
std::string_view finish_line(std::string_view first_word, Text_scanner& scanner)
{
  scanner.skip_line();
  return {first_word.data(), std::size_t(scanner.rest().data() - first_word.data())};
}

// Some programs tell who they are without the word that starts a comment, before anything is declared.
bool is_unmarked_comment(std::string_view keyword, const Ply_header& header)
{
  return !header.format_line.empty() && header.elements.empty() && !keyword.empty() && keyword != "property"
         && keyword != "end_header";
}

void read_comment(std::string_view keyword, Text_scanner& scanner, Ply_header& header)
{
  Text_scanner words = scanner;
  if(keyword == "comment" && words.word_in_line() == Ply_header::image_comment)
  {
    header.image_lines.push_back(finish_line(keyword, scanner));
    return;
  }
  header.comments.push_back(scanner.rest_of_line());
  scanner.skip_line();
}

Data_kind kind_of(std::string_view property, bool is_of_points)
{
  static const std::vector<std::string_view> normals = {"nx", "ny", "nz"};
  static const std::vector<std::string_view> colors
    = {"red", "green", "blue", "diffuse_red", "diffuse_green", "diffuse_blue"};
  const auto is_in = [&](const std::vector<std::string_view>& names)
  { return std::find(names.begin(), names.end(), property) != names.end(); };
  return is_in(colors) ? (is_of_points ? Data_kind::COLORS : Data_kind::FACE_COLORS)
       : property == "alpha" ? Data_kind::TRANSPARENCY
       : is_of_points && is_in(normals) ? Data_kind::NORMALS : Data_kind::OTHER_PROPERTIES;
}

} // namespace

std::vector<int> Ply_header::Element::find_point_uv() const
{
  const auto is_number = [&](int p) { return p >= 0 && !properties[std::size_t(p)].is_list; };
  for(const auto& [u, v] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")})
    if(is_number(find(u)) && is_number(find(v)))
      return {find(u), find(v)};
  return {};
}

int Ply_header::Element::find(std::string_view name_1, std::string_view name_2) const
{
  const auto found = std::find_if(properties.begin(), properties.end(), [&](const Property& p)
                                  { return p.name == name_1 || p.name == name_2; });
  return found == properties.end() ? -1 : int(found - properties.begin());
}

std::size_t Ply_header::number_of_elements() const
{
  std::size_t number = 0;
  for(const Element& element : elements)
    number += std::size_t(element.number);
  return number;
}

Data_kinds Ply_header::kinds() const
{
  Data_kinds result;
  if(!comments.empty())
    result.insert(Data_kind::COMMENTS);
  if(!image_lines.empty())
    result.insert(Data_kind::IMAGES);
  static const std::vector<std::string_view> read_otherwise
    = {"x", "y", "z", "s", "t", "u", "v", "texture_u", "texture_v", "vertex_indices", "vertex_index", "texcoord"};
  for(const Element& element : elements)
    for(const Property& property : element.properties)
      if(element.number > 0
         && std::find(read_otherwise.begin(), read_otherwise.end(), property.name) == read_otherwise.end())
        result.insert(kind_of(property.name, element.has_points()));
  return result;
}

Ply_header read_ply_header(Text_scanner& scanner)
{
  if(const std::string_view word = scanner.word(); word != "ply")
    scanner.fail("ply", word);
  scanner.skip_line();
  Ply_header header;
  for(;;)
  {
    const std::string_view keyword = scanner.word();
    if(keyword == "format")
    {
      header.format = read_format(scanner);
      header.format_line = finish_line(keyword, scanner);
    }
    else if(keyword == "element")
    {
      const std::string name(scanner.word_in_line());
      header.elements.push_back({name, scanner.index_in_line(), {}});
      scanner.skip_line();
    }
    else if(keyword == "property" && !header.elements.empty())
    {
      Property property = read_property(scanner);
      property.line = finish_line(keyword, scanner);
      header.elements.back().properties.push_back(property);
    }
    else if(keyword == "end_header" && !header.format_line.empty())
    {
      scanner.skip_line();
      return header;
    }
    else if(keyword == "comment" || keyword == "obj_info" || is_unmarked_comment(keyword, header))
      read_comment(keyword, scanner, header);
    else
      scanner.fail("a line of a PLY header", keyword);
  }
}
