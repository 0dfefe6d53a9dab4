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

[[noreturn]] void fail(const std::string& reason) { throw Failure(Exit_code::UNREADABLE, reason); }

template <typename Item>
const Item& at(const std::vector<Item>& items, int index, const char* what)
{
  if(index < 0 || index >= int(items.size()))
    fail(std::string("the file refers to a ") + what + " that it does not have");
  return items[std::size_t(index)];
}

// The elements of an accessor, one after the other.
class Elements
{
public:
  Elements(const tinygltf::Model& model, int accessor)
    : m_accessor(at(model.accessors, accessor, "accessor"))
  {
    if(m_accessor.sparse.isSparse)
      fail("sparse accessors are not supported");
    const tinygltf::BufferView& view = at(model.bufferViews, m_accessor.bufferView, "view of a buffer");
    const std::vector<unsigned char>& data = at(model.buffers, view.buffer, "buffer").data;
    const int stride = m_accessor.ByteStride(view);
    const int size = tinygltf::GetComponentSizeInBytes(std::uint32_t(m_accessor.componentType))
                     * tinygltf::GetNumComponentsInType(std::uint32_t(m_accessor.type));
    if(size <= 0 || stride < size)
      fail("an accessor has no valid type");
    m_stride = std::size_t(stride);
    const std::size_t first = view.byteOffset + m_accessor.byteOffset;
    if(first > data.size() || (m_accessor.count > 0 && (data.size() - first < std::size_t(size) ||
                               (data.size() - first - std::size_t(size)) / m_stride < m_accessor.count - 1)))
      fail("the file ends before the last element of an accessor");
    m_bytes = std::string_view(reinterpret_cast<const char*>(data.data()), data.size()).substr(first);
  }

  std::size_t number() const { return m_accessor.count; }
  bool is(int component_type, int type) const
  {
    return m_accessor.componentType == component_type && m_accessor.type == type;
  }

  // Of one of the component types that may stand for fractions.
  bool has_fractions(int type) const
  {
    return is(TINYGLTF_COMPONENT_TYPE_FLOAT, type) || is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, type)
           || is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, type);
  }

  int index(std::size_t i) const
  {
    const std::string_view bytes = m_bytes.substr(i * m_stride);
    if(is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR))
      return int((std::min)(load<std::uint32_t>(bytes, false), std::uint32_t(INT32_MAX)));
    if(is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR))
      return load<std::uint16_t>(bytes, false);
    if(is(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_TYPE_SCALAR))
      return load<std::uint8_t>(bytes, false);
    fail("indices of triangles are not numbers without a sign");
  }

  // The first numbers of an element; whole ones are fractions of the largest.
  template <int number>
  Eigen::Matrix<double, number, 1> vector(std::size_t i) const
  {
    const std::string_view bytes = m_bytes.substr(i * m_stride);
    Eigen::Matrix<double, number, 1> result;
    for(int k = 0; k < number; ++k)
      result[k] = m_accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT ? load<float>(bytes.substr(4 * k), false)
                : m_accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                    ? load<std::uint16_t>(bytes.substr(2 * k), false) / 65535.
                    : load<std::uint8_t>(bytes.substr(k), false) / 255.;
    return result;
  }

private:
  const tinygltf::Accessor& m_accessor;
  std::size_t m_stride = 0;
  std::string_view m_bytes;
};

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
    if(m_model.scenes.empty())
      fail("the file has no scene");
    for(int node : at(m_model.scenes, (std::max)(m_model.defaultScene, 0), "scene").nodes)
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

Polygon_soup read(std::string_view bytes, Load load, const std::string& folder, Attributes attributes)
{
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; }, nullptr); // images do not matter
  tinygltf::Model model;
  std::string error;
  if(bytes.size() > UINT32_MAX)
    fail("the file is too large");
  if(!load(loader, model, error, bytes, folder))
  {
    error = error.substr(0, error.find('\n'));
    std::replace_if(error.begin(), error.end(), [](char c) { return c < 32 || c > 126; }, '?'); // quotes the file
    fail("damaged glTF: " + error);
  }
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
