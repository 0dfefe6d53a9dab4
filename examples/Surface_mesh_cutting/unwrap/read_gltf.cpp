#include "read_gltf.h"

#include "file_extension.h"

#include "outcome.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

bool is_gltf(const std::string& path)
{
  const std::string extension = extension_of(path);
  return extension == ".gltf" || extension == ".glb";
}

#ifndef UNWRAP_WITH_GLTF

Polygon_soup read_gltf(const std::string&, Attributes attributes)
{
  return read_glb({}, attributes);
}

Polygon_soup read_glb(std::string_view, Attributes)
{
  throw Failure(Exit_code::UNREADABLE, "this program was built without tinygltf, which reads glTF");
}

#else

#include "Gltf_elements.h"
#include "Point_merger.h"
#include "byte_order.h"
#include "file_bytes.h"
#include "triangle_strip.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <string_view>
#include <vector>

namespace {

using gltf::Elements;
using gltf::at;
using gltf::fail;

Eigen::Matrix4d transformation_of(const tinygltf::Node& node)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if(node.matrix.size() == 16)
    return Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
  if(node.translation.size() == 3)
    result.translate(Eigen::Vector3d(node.translation[0], node.translation[1], node.translation[2]));
  if(node.rotation.size() == 4)
    result.rotate(Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
  if(node.scale.size() == 3)
    result.scale(Eigen::Vector3d(node.scale[0], node.scale[1], node.scale[2]));
  return result.matrix();
}

// Three corners of each triangle of a primitive, whose vertices are given one after the other.
std::vector<int> triangle_corners(const std::vector<int>& vertices, int mode)
{
  if(mode == TINYGLTF_MODE_TRIANGLES)
    return {vertices.begin(), vertices.end() - std::ptrdiff_t(vertices.size() % 3)};
  if(mode != TINYGLTF_MODE_TRIANGLE_FAN)
    return triangles_of_strip(vertices);
  std::vector<int> corners;
  for(std::size_t i = 2; i < vertices.size(); ++i)
    corners.insert(corners.end(), {vertices[0], vertices[i - 1], vertices[i]});
  return corners;
}

std::optional<Polygon_soup::Texture_point> to_uv(const Eigen::Vector2d& uv) { return {{{uv.x(), uv.y()}}}; }

// As a word of a line.
std::string name_or(std::string name, const std::string& other)
{
  std::replace_if(name.begin(), name.end(), [](unsigned char c) { return c < 32; }, ' ');
  return name.empty() ? other : name;
}

class Scene_reader
{
public:
  Scene_reader(const tinygltf::Model& model, Attributes attributes)
    : m_model(model), m_attributes(attributes), m_merger(m_soup, attributes.has_merged_points)
  {}

  Polygon_soup run()
  {
    for(int node : nodes_of_scene())
      add_node(node, Eigen::Matrix4d::Identity(), 0);
    if(!m_soup.colors.empty())
      m_soup.colors.resize(m_soup.points.size(), white);
    if(m_soup.normals.empty())
      m_soup.corner_normals.clear();
    return std::move(m_soup);
  }

private:
  static constexpr std::array<double, 3> white = {{1, 1, 1}};

  // The attributes of the vertices of a primitive, at their place.
  struct Vertices
  {
    Elements points;
    std::optional<Elements> colors, uvs;
    int first_normal; // -1 if there are none
    Eigen::Matrix4d transformation;
  };

  // Those that do not hang below others. A file without scenes is a collection of them.
  std::vector<int> nodes_of_scene() const
  {
    if(!m_model.scenes.empty())
      return at(m_model.scenes, (std::max)(m_model.defaultScene, 0), "scene").nodes;
    std::vector<char> is_below(m_model.nodes.size(), 0);
    for(const tinygltf::Node& node : m_model.nodes)
      for(int child : node.children)
        if(child >= 0 && child < int(is_below.size()))
          is_below[std::size_t(child)] = 1;
    std::vector<int> nodes;
    for(std::size_t i = 0; i < is_below.size(); ++i)
      if(!is_below[i])
        nodes.push_back(int(i));
    return nodes;
  }

  void add_node(int index, const Eigen::Matrix4d& outer, std::size_t depth)
  {
    if(depth > m_model.nodes.size() || ++m_number_of_visits > m_model.nodes.size())
      fail("nodes of the scene are not a tree");
    const tinygltf::Node& node = at(m_model.nodes, index, "node");
    const Eigen::Matrix4d transformation = outer * transformation_of(node);
    if(node.mesh >= 0)
    {
      const tinygltf::Mesh& mesh = at(m_model.meshes, node.mesh, "mesh");
      say("o " + name_or(node.name, name_or(mesh.name, "mesh_" + std::to_string(node.mesh))));
      for(const tinygltf::Primitive& primitive : mesh.primitives)
        add_primitive(primitive, transformation);
    }
    for(int child : node.children)
      add_node(child, transformation, depth + 1);
  }

  void say(const std::string& line)
  {
    if(m_attributes.has_looks)
      m_soup.obj_statements.lines.push_back({m_soup.number_of_polygons(), line});
  }

  std::optional<Elements> find_attribute(const tinygltf::Primitive& primitive, const char* name) const
  {
    const auto found = primitive.attributes.find(name);
    if(found == primitive.attributes.end())
      return std::nullopt;
    return Elements(m_model, found->second);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Eigen::Matrix4d& transformation)
  {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if(mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN)
      return; // points and lines
    const std::optional<Elements> points = find_attribute(primitive, "POSITION");
    if(!points)
      return; // an extension brings it
    if(!points->is(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3))
      fail("the points are not given by three numbers of single precision");
    if(primitive.material >= 0)
      say("usemtl " + name_or(at(m_model.materials, primitive.material, "material").name,
                              "material_" + std::to_string(primitive.material)));
    const Vertices vertices = {*points, find_colors(primitive, points->number()),
                               find_uvs(primitive, points->number()),
                               add_normals(primitive, points->number(), transformation), transformation};
    const bool is_mirrored = transformation.topLeftCorner<3, 3>().determinant() < 0;
    const std::vector<int> corners = triangle_corners(vertices_of(primitive, points->number()), mode);
    for(std::size_t c = 0; c + 2 < corners.size(); c += 3)
    {
      add_corner(vertices, corners[c]);
      add_corner(vertices, corners[c + (is_mirrored ? 2 : 1)]);
      add_corner(vertices, corners[c + (is_mirrored ? 1 : 2)]);
      m_soup.close_polygon();
    }
  }

  std::vector<int> vertices_of(const tinygltf::Primitive& primitive, std::size_t number_of_points) const
  {
    std::vector<int> vertices;
    if(primitive.indices >= 0)
    {
      const Elements indices(m_model, primitive.indices);
      for(std::size_t i = 0; i < indices.number(); ++i)
        vertices.push_back(indices.index(i));
    }
    else
      for(std::size_t i = 0; i < number_of_points; ++i)
        vertices.push_back(int(i));
    return vertices;
  }

  std::optional<Elements> find_colors(const tinygltf::Primitive& primitive, std::size_t number) const
  {
    const std::optional<Elements> colors = find_attribute(primitive, "COLOR_0");
    if(!m_attributes.has_looks || !colors || colors->number() != number)
      return std::nullopt;
    return colors->has_fractions(TINYGLTF_TYPE_VEC3) || colors->has_fractions(TINYGLTF_TYPE_VEC4) ? colors
                                                                                                   : std::nullopt;
  }

  std::optional<Elements> find_uvs(const tinygltf::Primitive& primitive, std::size_t number) const
  {
    const std::optional<Elements> uvs = find_attribute(primitive, "TEXCOORD_0");
    const bool is_usable = m_attributes.has_uvs && uvs && uvs->number() == number
                           && uvs->has_fractions(TINYGLTF_TYPE_VEC2);
    return is_usable ? uvs : std::nullopt;
  }

  // Returns where they begin.
  int add_normals(const tinygltf::Primitive& primitive, std::size_t number, const Eigen::Matrix4d& transformation)
  {
    const std::optional<Elements> normals = find_attribute(primitive, "NORMAL");
    if(!m_attributes.has_looks || !normals || normals->number() != number
       || !normals->is(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3))
      return -1;
    const int first = int(m_soup.normals.size());
    const Eigen::Matrix3d turn = transformation.topLeftCorner<3, 3>().inverse().transpose();
    for(std::size_t i = 0; i < number; ++i)
    {
      const Eigen::Vector3d normal = (turn * normals->vector<3>(i)).normalized();
      m_soup.normals.push_back({{normal.x(), normal.y(), normal.z()}});
    }
    return first;
  }

  void add_corner(const Vertices& vertices, int vertex)
  {
    const std::size_t i = std::size_t(vertex);
    if(vertex < 0 || i >= vertices.points.number())
      fail("face " + std::to_string(m_soup.number_of_polygons()) + " refers to a vertex that its mesh does not have");
    const Eigen::Vector3d p = (vertices.transformation * vertices.points.vector<3>(i).homogeneous()).head<3>();
    const std::size_t number_of_points = m_soup.points.size();
    m_merger.add_corner(p.x(), p.y(), p.z());
    if(vertices.colors && m_soup.points.size() > number_of_points)
    {
      const Eigen::Vector3d color = vertices.colors->vector<3>(i);
      m_soup.colors.resize(number_of_points, white);
      m_soup.colors.push_back({{color.x(), color.y(), color.z()}});
    }
    if(m_attributes.has_uvs)
      m_soup.corner_uvs.push_back(vertices.uvs ? to_uv(vertices.uvs->vector<2>(i)) : std::nullopt);
    m_soup.corner_normals.push_back(vertices.first_normal < 0 ? -1 : vertices.first_normal + vertex);
  }

  const tinygltf::Model& m_model;
  const Attributes m_attributes;
  Polygon_soup m_soup;
  Point_merger m_merger;
  std::size_t m_number_of_visits = 0;
};

using Load = bool (*)(tinygltf::TinyGLTF& loader, tinygltf::Model& model, std::string& error, std::string_view bytes,
                      const std::string& folder);

bool load_binary(tinygltf::TinyGLTF& loader, tinygltf::Model& model, std::string& error, std::string_view bytes,
                 const std::string& folder)
{
  std::string warning;
  return loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                     unsigned(bytes.size()), folder);
}

bool load_text(tinygltf::TinyGLTF& loader, tinygltf::Model& model, std::string& error, std::string_view bytes,
               const std::string& folder)
{
  std::string warning;
  return loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), unsigned(bytes.size()), folder);
}

// Where meshes of a sound file may be that are not where they are looked for.
constexpr std::array<const char*, 2> compressions = {{"KHR_draco_mesh_compression", "EXT_meshopt_compression"}};

// The loader may end before it knows what the file requires.
std::string hint_at_compression(std::string_view bytes)
{
  for(const char* extension : compressions)
    if(bytes.find(extension) != std::string_view::npos)
      return std::string("; the file uses ") + extension + ", which is not supported";
  return "";
}

void check_required(const tinygltf::Model& model)
{
  for(const std::string& extension : model.extensionsRequired)
    if(std::find(compressions.begin(), compressions.end(), extension) != compressions.end())
      fail("the file requires " + extension + ", which is not supported");
}

// Its files have names where those of version 2 have numbers.
bool is_version_1(const tinygltf::Model& model, std::string_view bytes)
{
  constexpr std::string_view magic = "glTF";
  const bool is_binary = bytes.size() >= 8 && bytes.substr(0, magic.size()) == magic;
  return is_binary ? load<std::uint32_t>(bytes.substr(magic.size()), false) == 1 : model.asset.version.substr(0, 2) == "1.";
}

Polygon_soup read(std::string_view bytes, Load load, const std::string& folder, Attributes attributes)
{
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; }, nullptr); // images do not matter
  tinygltf::Model model;
  std::string error;
  if(bytes.size() > UINT32_MAX)
    fail("the file is too large");
  const bool is_loaded = load(loader, model, error, bytes, folder);
  if(is_version_1(model, bytes))
    fail("glTF 1 is not supported, only version 2");
  if(!is_loaded)
  {
    error = error.substr(0, error.find('\n'));
    std::replace_if(error.begin(), error.end(), [](char c) { return c < 32 || c > 126; }, '?'); // quotes the file
    fail("damaged glTF: " + error + hint_at_compression(bytes));
  }
  check_required(model);
  return Scene_reader(model, attributes).run();
}

} // namespace

Polygon_soup read_gltf(const std::string& path, Attributes attributes)
{
  const std::string bytes = read_bytes(path), folder = std::filesystem::path(path).parent_path().string();
  return read(bytes, is_glb(path) ? load_binary : load_text, folder, attributes);
}

Polygon_soup read_glb(std::string_view bytes, Attributes attributes)
{
  return read(bytes, load_binary, "", attributes);
}

#endif // UNWRAP_WITH_GLTF
