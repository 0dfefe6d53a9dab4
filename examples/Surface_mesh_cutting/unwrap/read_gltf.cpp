#include "read_gltf.h"

#include "Gltf_elements.h"
#include "Gltf_source.h"
#include "file_bytes.h"
#include "gltf_kinds.h"
#include "gltf_scene.h"
#include "gltf_uri.h"
#include "outcome.h"
#include "stop_request.h"
#include "triangle_strip.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

namespace {

using gltf::Elements;
using gltf::Instance;
using gltf::Json;
using gltf::fail;

enum Mode { TRIANGLES = 4, TRIANGLE_STRIP, TRIANGLE_FAN };

// Three corners of each triangle of a primitive, whose vertices are given one after the other.
std::vector<int> triangle_corners(std::vector<int> vertices, std::size_t mode)
{
  if(mode == TRIANGLES)
    vertices.resize(vertices.size() / 3 * 3);
  if(mode == TRIANGLES)
    return vertices;
  if(mode == TRIANGLE_STRIP)
    return triangles_of_strip(vertices);
  std::vector<int> corners;
  for(std::size_t i = 2; i < vertices.size(); ++i)
    corners.insert(corners.end(), {vertices[0], vertices[i - 1], vertices[i]});
  return corners;
}

// As words of a line of OBJ, in which # begins a comment and a backslash goes on with the next line.
std::string name_or(std::string name, const std::string& other)
{
  std::replace_if(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127 || c == '#' || c == '\\'; }, '_');
  return name.find_first_not_of(' ') == std::string::npos ? other : name;
}

// At which a mesh is measured: as the scene shows it, but not from inside, and not where that leaves no surface.
Eigen::Matrix4d measuring(Eigen::Matrix4d transformation)
{
  const double determinant = transformation.topLeftCorner<3, 3>().determinant();
  if(determinant < 0)
    transformation.row(0) *= -1;
  return transformation.allFinite() && determinant != 0 ? transformation : Eigen::Matrix4d::Identity();
}

class Scene_reader
{
public:
  Scene_reader(std::shared_ptr<Gltf_source> source, Attributes attributes)
    : m_source(std::move(source)), m_document(m_source->document), m_attributes(attributes)
  {}

  Polygon_soup run()
  {
    if(m_attributes.has_gltf_source)
      m_document.read_all();
    for(const Instance& instance : wanted_instances())
      add_mesh(instance);
    if(!m_soup.colors.empty())
      m_soup.colors.resize(m_soup.points.size(), white);
    if(m_soup.normals.empty())
      m_soup.corner_normals.clear();
    m_soup.kinds = gltf::kinds_of(m_document);
    if(m_attributes.has_gltf_source)
      m_soup.gltf_source = m_source;
    return std::move(m_soup);
  }

private:
  static constexpr std::array<double, 3> white = {{1, 1, 1}};
  using Place = std::array<double, 6>; // a point and its color

  // The attributes of the vertices of a primitive, at their place.
  struct Vertices
  {
    Elements points;
    std::optional<Elements> colors, uvs, normals;
    Eigen::Matrix4d transformation;
    Eigen::Matrix3d turn; // of normals
  };

  // What the soup has of a vertex.
  struct Numbers
  {
    int point = -1, normal = -1;
  };

  std::vector<Instance> wanted_instances() const
  {
    std::vector<Instance> instances = gltf::find_instances(m_document);
    if(!m_attributes.has_gltf_source)
      return instances;
    std::vector<char> is_met(gltf::list(m_document.description(), "meshes").size(), 0);
    const auto is_repeated = [&](const Instance& instance) { return std::exchange(is_met[instance.mesh], char(1)) != 0; };
    instances.erase(std::remove_if(instances.begin(), instances.end(), is_repeated), instances.end());
    for(Instance& instance : instances)
      instance.transformation = measuring(instance.transformation);
    return instances;
  }

  void add_mesh(const Instance& instance)
  {
    const Json& mesh = gltf::item(m_document.description(), "meshes", instance.mesh);
    std::string name = name_or(gltf::text_of(mesh, "name"), "mesh_" + std::to_string(instance.mesh));
    if(instance.node)
      name = name_or(gltf::text_of(gltf::item(m_document.description(), "nodes", *instance.node), "name"), name);
    say("o " + name);
    ++m_part;
    m_originals.clear();
    m_numbers.clear();
    const std::size_t number_of_primitives = gltf::list(mesh, "primitives").size();
    for(std::size_t i = 0; i < number_of_primitives; ++i)
      add_primitive(instance, i, gltf::item(mesh, "primitives", i));
  }

  void say(const std::string& line)
  {
    if(m_attributes.has_looks)
      m_soup.obj_statements.lines.push_back({m_soup.number_of_polygons(), line});
  }

  // Only if it has so many components for each of so many vertices.
  std::optional<Elements> find_attribute(const Json& primitive, const char* name, int components,
                                         std::optional<std::size_t> number = std::nullopt) const
  {
    const Json* const attributes = gltf::find(primitive, "attributes");
    const std::optional<std::size_t> accessor = attributes == nullptr ? std::nullopt : gltf::find_number(*attributes, name);
    if(!accessor)
      return std::nullopt;
    Elements elements(m_document, *accessor);
    return elements.number_of_components() >= components && (!number || *number == elements.number())
             ? std::make_optional(std::move(elements)) : std::nullopt;
  }

  std::optional<Elements> find_uvs(const Json& primitive, std::size_t number) const
  {
    std::optional<Elements> uvs = find_attribute(primitive, gltf::name_of_uvs(m_attributes.uv_set).c_str(), 2, number);
    return uvs ? uvs : find_attribute(primitive, gltf::name_of_uvs(0).c_str(), 2, number);
  }

  void add_primitive(const Instance& instance, std::size_t index, const Json& primitive)
  {
    end_if_stop_is_requested();
    const std::size_t mode = gltf::number_or(primitive, "mode", TRIANGLES);
    std::optional<Elements> points;
    if(mode == TRIANGLES || mode == TRIANGLE_STRIP || mode == TRIANGLE_FAN)
      points = find_attribute(primitive, "POSITION", 3);
    if(!points)
      return; // points and lines, or an extension brings it
    check_is_not_compressed(primitive);
    say_material(primitive);
    const std::size_t number = points->number(), first_corner = m_soup.corners.size();
    const Eigen::Matrix3d linear = instance.transformation.topLeftCorner<3, 3>();
    const bool has_normals = m_attributes.has_looks && !m_attributes.has_gltf_source && linear.determinant() != 0;
    const Vertices vertices = {*points,
                               m_attributes.has_looks ? find_attribute(primitive, "COLOR_0", 3, number) : std::nullopt,
                               m_attributes.has_uvs ? find_uvs(primitive, number) : std::nullopt,
                               has_normals ? find_attribute(primitive, "NORMAL", 3, number) : std::nullopt,
                               instance.transformation,
                               has_normals ? Eigen::Matrix3d(linear.inverse().transpose()) : linear};
    const std::vector<int> corners = triangle_corners(vertices_of(primitive, number), mode);
    const bool is_mirrored = linear.determinant() < 0;
    std::unordered_map<int, Numbers> numbers; // of the vertices that triangles use: others may be many
    for(std::size_t c = 0; c + 2 < corners.size(); c += 3)
    {
      if(c % 3072 == 0)
        end_if_stop_is_requested();
      add_corner(vertices, corners[c], numbers[corners[c]]);
      add_corner(vertices, corners[c + (is_mirrored ? 2 : 1)], numbers[corners[c + (is_mirrored ? 2 : 1)]]);
      add_corner(vertices, corners[c + (is_mirrored ? 1 : 2)], numbers[corners[c + (is_mirrored ? 1 : 2)]]);
      m_soup.close_polygon();
    }
    if(m_attributes.has_gltf_source)
    {
      check_attributes(primitive, number);
      m_source->primitives.push_back({instance.mesh, index, number, first_corner, corners});
    }
  }

  // Else the accessors of its attributes have no data, and would count as zero.
  void check_is_not_compressed(const Json& primitive) const
  {
    constexpr const char* compression = "KHR_draco_mesh_compression";
    const Json* const extensions = gltf::find(primitive, "extensions");
    const Json& points = gltf::item(m_document.description(), "accessors", gltf::number_or(primitive["attributes"], "POSITION", 0));
    if(extensions != nullptr && gltf::find(*extensions, compression) != nullptr && gltf::find(points, "bufferView") == nullptr)
      gltf::fail_about_compression("a mesh of the file", compression);
  }

  // All of them have as many elements as there are vertices.
  void check_attributes(const Json& primitive, std::size_t number) const
  {
    std::vector<const Json*> objects = {gltf::find(primitive, "attributes")};
    for(const Json& target : gltf::list(primitive, "targets"))
      objects.push_back(&target);
    for(const Json* object : objects)
      for(const auto& attribute : object->items())
        if(Elements(m_document, gltf::find_number(*object, attribute.key().c_str()).value_or(SIZE_MAX)).number() != number)
          fail("damaged glTF: an attribute " + gltf::quoted(attribute.key()) + " does not have " + std::to_string(number)
               + " elements, like the points");
  }

  void say_material(const Json& primitive)
  {
    const std::optional<std::size_t> material = gltf::find_number(primitive, "material");
    if(material)
      say("usemtl " + name_or(gltf::text_of(gltf::item(m_document.description(), "materials", *material), "name"),
                              "material_" + std::to_string(*material)));
    else if(m_has_material)
      say("usemtl no_material"); // or it would have the one before
    m_has_material = material.has_value();
  }

  std::vector<int> vertices_of(const Json& primitive, std::size_t number_of_points) const
  {
    std::vector<int> vertices;
    const std::optional<std::size_t> accessor = gltf::find_number(primitive, "indices");
    if(!accessor)
      for(std::size_t i = 0; i < number_of_points; ++i)
        vertices.push_back(int(i));
    if(!accessor)
      return vertices;
    const Elements indices(m_document, *accessor);
    if(!indices.has_indices())
      fail("damaged glTF: indices of triangles are not whole numbers without a sign");
    vertices.reserve(indices.number());
    for(std::size_t i = 0; i < indices.number(); ++i)
    {
      if(indices.index(i) >= number_of_points)
        fail("face " + std::to_string(m_soup.number_of_polygons() + int(i / 3)) + " refers to vertex "
             + std::to_string(indices.index(i)) + ", but its mesh has only " + std::to_string(number_of_points));
      vertices.push_back(int(indices.index(i)));
    }
    return vertices;
  }

  void add_corner(const Vertices& vertices, int vertex, Numbers& numbers)
  {
    const std::size_t i = std::size_t(vertex);
    if(numbers.point < 0)
      numbers.point = number_of_point(vertices, i);
    if(numbers.normal < 0 && vertices.normals)
    {
      numbers.normal = int(m_soup.normals.size());
      const Eigen::Vector3d normal = (vertices.turn * vertices.normals->vector<3>(i)).normalized();
      m_soup.normals.push_back({{normal.x(), normal.y(), normal.z()}});
    }
    m_soup.corners.push_back(numbers.point);
    m_soup.corner_normals.push_back(numbers.normal);
    if(m_attributes.has_uvs)
      m_soup.corner_uvs.push_back(vertices.uvs ? uv_of(vertices.uvs->vector<2>(i)) : std::nullopt);
  }

  static std::optional<Polygon_soup::Texture_point> uv_of(const Eigen::Vector2d& uv) { return {{{uv.x(), 1 - uv.y()}}}; }

  // That of a former one of the mesh at the same point with the same color; in a file that is edited, colors stay anyway.
  int number_of_point(const Vertices& vertices, std::size_t i)
  {
    const Eigen::Vector3d p = (vertices.transformation * vertices.points.vector<3>(i).homogeneous()).head<3>();
    const Polygon_soup::Point point = {{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}}; // -0 becomes 0
    std::array<double, 3> color = white;
    if(vertices.colors)
      Eigen::Map<Eigen::Vector3d>(color.data()) = vertices.colors->vector<3>(i);
    const int next = m_soup.number_of_points();
    int original = next;
    if(m_attributes.has_merged_points)
    {
      original = m_originals.emplace(point, next).first->second;
      if(m_attributes.has_gltf_source && original != next)
        return original;
      const Place place = {{point[0], point[1], point[2], color[0], color[1], color[2]}};
      if(const auto inserted = m_numbers.emplace(place, next); !inserted.second)
        return inserted.first->second;
    }
    m_soup.points.push_back(point);
    m_soup.point_parts.push_back(m_part);
    m_soup.originals.push_back(original);
    if(vertices.colors)
    {
      m_soup.colors.resize(m_soup.points.size() - 1, white);
      m_soup.colors.push_back(color);
    }
    return next;
  }

  const std::shared_ptr<Gltf_source> m_source;
  const gltf::Document& m_document;
  const Attributes m_attributes;
  Polygon_soup m_soup;
  int m_part = -1; // the instance
  std::unordered_map<Polygon_soup::Point, int, boost::hash<Polygon_soup::Point> > m_originals; // of its points
  std::unordered_map<Place, int, boost::hash<Place> > m_numbers;
  bool m_has_material = false;
};

Polygon_soup read(gltf::Document document, Attributes attributes)
{
  return Scene_reader(std::make_shared<Gltf_source>(Gltf_source{std::move(document), {}}), attributes).run();
}

} // namespace

Polygon_soup read_gltf(const std::string& path, Attributes attributes)
{
  return read(gltf::read_document(path), attributes);
}

Polygon_soup read_glb(std::string_view bytes, Attributes attributes)
{
  return read(gltf::Document(std::string(bytes), ""), attributes);
}

std::vector<std::string> files_of_gltf(const std::string& path)
{
  std::vector<std::string> files;
  try
  {
    const gltf::Json description = gltf::read_description(read_bytes(path));
    gltf::for_each_member(description, [&](const std::string& key, const Json& value)
    {
      const std::string uri = key == "uri" && value.is_string() ? value.get<std::string>() : "";
      if(!uri.empty() && !gltf::is_data(uri))
        for(const std::filesystem::path& file : {gltf::path_of(uri), std::filesystem::path(uri)})
          files.push_back((std::filesystem::path(path).parent_path() / file).string());
    });
  }
  catch(const Failure&)
  {
    // The reader will say why.
  }
  return files;
}
