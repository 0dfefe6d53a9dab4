#include "read_gltf.h"

#include "file_extension.h"

#include "outcome.h"

#include <algorithm>
#include <filesystem>

bool is_gltf(const std::string& path)
{
  const std::string extension = extension_of(path);
  return extension == ".gltf" || extension == ".glb";
}

#ifndef UNWRAP_WITH_GLTF

Polygon_soup read_gltf(const std::string&, Attributes)
{
  throw Failure(Exit_code::UNREADABLE, "this program was built without tinygltf, which reads glTF");
}

#else

#include "Point_merger.h"
#include "byte_order.h"
#include "file_bytes.h"

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

  Eigen::Vector3d point(std::size_t i) const
  {
    const std::string_view bytes = m_bytes.substr(i * m_stride);
    return Eigen::Vector3d(load<float>(bytes, false), load<float>(bytes.substr(4), false),
                           load<float>(bytes.substr(8), false));
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

class Scene_reader
{
public:
  Scene_reader(const tinygltf::Model& model, bool does_merge) : m_model(model), m_merger(m_soup, does_merge) {}

  Polygon_soup run()
  {
    if(m_model.scenes.empty())
      fail("the file has no scene");
    for(int node : at(m_model.scenes, (std::max)(m_model.defaultScene, 0), "scene").nodes)
      add_node(node, Eigen::Matrix4d::Identity(), 0);
    return std::move(m_soup);
  }

private:
  void add_node(int index, const Eigen::Matrix4d& outer, std::size_t depth)
  {
    if(depth > m_model.nodes.size() || ++m_number_of_visits > m_model.nodes.size())
      fail("nodes of the scene are not a tree");
    const tinygltf::Node& node = at(m_model.nodes, index, "node");
    const Eigen::Matrix4d transformation = outer * transformation_of(node);
    if(node.mesh >= 0)
      for(const tinygltf::Primitive& primitive : at(m_model.meshes, node.mesh, "mesh").primitives)
        add_primitive(primitive, transformation);
    for(int child : node.children)
      add_node(child, transformation, depth + 1);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Eigen::Matrix4d& transformation)
  {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if(mode == TINYGLTF_MODE_POINTS || mode == TINYGLTF_MODE_LINE || mode == TINYGLTF_MODE_LINE_LOOP ||
       mode == TINYGLTF_MODE_LINE_STRIP)
      return;
    if(mode != TINYGLTF_MODE_TRIANGLES)
      fail("strips and fans of triangles are not supported");
    const auto position = primitive.attributes.find("POSITION");
    if(position == primitive.attributes.end())
      return; // an extension brings it
    const Elements points(m_model, position->second);
    if(!points.is(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3))
      fail("the points are not given by three numbers of single precision");
    std::vector<int> corners;
    if(primitive.indices >= 0)
    {
      const Elements indices(m_model, primitive.indices);
      for(std::size_t i = 0; i < indices.number(); ++i)
        corners.push_back(indices.index(i));
    }
    else
      for(std::size_t i = 0; i < points.number(); ++i)
        corners.push_back(int(i));
    const bool is_mirrored = transformation.topLeftCorner<3, 3>().determinant() < 0;
    for(std::size_t c = 0; c + 2 < corners.size(); c += 3)
      add_triangle(points, {{corners[c], corners[c + (is_mirrored ? 2 : 1)], corners[c + (is_mirrored ? 1 : 2)]}},
                   transformation);
  }

  void add_triangle(const Elements& points, const std::array<int, 3>& corners, const Eigen::Matrix4d& transformation)
  {
    for(int corner : corners)
    {
      if(corner < 0 || std::size_t(corner) >= points.number())
        fail("face " + std::to_string(m_soup.number_of_polygons()) + " refers to a vertex that its mesh does not have");
      const Eigen::Vector3d p = (transformation * points.point(std::size_t(corner)).homogeneous()).head<3>();
      m_merger.add_corner(p.x(), p.y(), p.z());
    }
    m_soup.close_polygon();
  }

  const tinygltf::Model& m_model;
  Polygon_soup m_soup;
  Point_merger m_merger;
  std::size_t m_number_of_visits = 0;
};

} // namespace

Polygon_soup read_gltf(const std::string& path, Attributes attributes)
{
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; }, nullptr); // images do not matter
  tinygltf::Model model;
  std::string error, warning;
  const std::string bytes = read_bytes(path), folder = std::filesystem::path(path).parent_path().string();
  if(bytes.size() > UINT32_MAX)
    fail("the file is too large");
  const bool is_read = is_glb(path)
    ? loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                  unsigned(bytes.size()), folder)
    : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), unsigned(bytes.size()), folder);
  if(!is_read)
    fail("damaged glTF: " + error.substr(0, error.find('\n')));
  return Scene_reader(model, attributes.has_merged_points).run();
}

#endif // UNWRAP_WITH_GLTF
