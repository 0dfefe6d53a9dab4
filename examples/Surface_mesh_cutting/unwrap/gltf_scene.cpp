#include "gltf_scene.h"

#include "Gltf_elements.h"
#include "stop_request.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace gltf {

namespace {

Eigen::Matrix4d transformation_of(const Eigen::Vector3d& translation, const Eigen::Vector4d& rotation,
                                  const Eigen::Vector3d& scale)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.translate(translation);
  result.rotate(Eigen::Quaterniond(rotation[3], rotation[0], rotation[1], rotation[2]));
  result.scale(scale);
  return result.matrix();
}

template <int number>
Eigen::Matrix<double, number, 1> vector_of(const Json& object, const char* key, Eigen::Matrix<double, number, 1> other)
{
  const std::vector<double> numbers = numbers_of(object, key, number);
  if(!numbers.empty())
    std::copy(numbers.begin(), numbers.end(), other.data());
  return other;
}

Eigen::Matrix4d transformation_of(const Json& node)
{
  if(const std::vector<double> matrix = numbers_of(node, "matrix", 16); !matrix.empty())
    return Eigen::Map<const Eigen::Matrix4d>(matrix.data());
  return transformation_of(vector_of<3>(node, "translation", {0, 0, 0}), vector_of<4>(node, "rotation", {0, 0, 0, 1}),
                           vector_of<3>(node, "scale", {1, 1, 1}));
}

// Where EXT_mesh_gpu_instancing places the mesh of a node, relative to it.
class Places
{
public:
  Places(const Document& document, const Json& attributes)
  {
    const std::pair<const char*, std::optional<Elements>*> all_vectors[]
      = {{"TRANSLATION", &m_translations}, {"ROTATION", &m_rotations}, {"SCALE", &m_scales}};
    for(const auto& [key, vectors] : all_vectors)
    {
      const std::optional<std::size_t> accessor = find_number(attributes, key);
      if(!accessor)
        continue;
      vectors->emplace(document, *accessor);
      const int components = vectors == &m_rotations ? 4 : 3;
      if((*vectors)->number_of_components() != components || (m_number && *m_number != (*vectors)->number()))
        fail(std::string("damaged glTF: ") + key + " of EXT_mesh_gpu_instancing does not fit");
      m_number = (*vectors)->number();
    }
  }

  std::size_t number() const { return m_number.value_or(1); }

  Eigen::Matrix4d operator[](std::size_t i) const
  {
    return transformation_of(m_translations ? m_translations->vector<3>(i) : Eigen::Vector3d(0, 0, 0),
                             m_rotations ? m_rotations->vector<4>(i) : Eigen::Vector4d(0, 0, 0, 1),
                             m_scales ? m_scales->vector<3>(i) : Eigen::Vector3d(1, 1, 1));
  }

private:
  std::optional<Elements> m_translations, m_rotations, m_scales;
  std::optional<std::size_t> m_number;
};

class Scene_walk
{
public:
  explicit Scene_walk(const Document& document)
    : m_document(document), m_nodes(list(document.description(), "nodes")), m_has_parent(m_nodes.size(), 0),
      m_is_met(m_nodes.size(), 0), m_is_shown(list(document.description(), "meshes").size(), 0)
  {
    for(std::size_t node = 0; node < m_nodes.size(); ++node)
      for(const std::size_t child : indices_of(item(document.description(), "nodes", node), "children"))
        if(std::exchange(m_has_parent[child], char(1)))
          fail_about_trees();
  }

  std::vector<Instance> run()
  {
    const Json& description = m_document.description();
    if(!list(description, "scenes").empty())
      for(const std::size_t root : indices_of(item(description, "scenes", number_or(description, "scene", 0)), "nodes"))
        visit_tree(root);
    for(std::size_t node = 0; node < m_nodes.size(); ++node)
      visit_tree(node);
    if(std::find(m_is_met.begin(), m_is_met.end(), 0) != m_is_met.end())
      fail_about_trees();
    for(std::size_t mesh = 0; mesh < m_is_shown.size(); ++mesh)
      if(!m_is_shown[mesh])
        m_instances.push_back({mesh, std::nullopt, Eigen::Matrix4d::Identity()});
    return std::move(m_instances);
  }

private:
  [[noreturn]] static void fail_about_trees() { fail("damaged glTF: the nodes of its scenes are not trees"); }

  // Of nodes.
  std::vector<std::size_t> indices_of(const Json& object, const char* key) const
  {
    std::vector<std::size_t> indices;
    for(const Json& index : list(object, key))
    {
      if(!index.is_number_unsigned() || index.get<std::size_t>() >= m_nodes.size())
        fail("damaged glTF: it refers to a node that it does not have");
      indices.push_back(index.get<std::size_t>());
    }
    return indices;
  }

  // From a root, without recursion: a chain of nodes may be long.
  void visit_tree(std::size_t root)
  {
    if(m_has_parent[root] || m_is_met[root])
      return;
    std::vector<std::pair<std::size_t, Eigen::Matrix4d> > next = {{root, Eigen::Matrix4d::Identity()}};
    while(!next.empty())
    {
      end_if_stop_is_requested();
      const auto [node, outer] = next.back();
      next.pop_back();
      m_is_met[node] = 1;
      const Eigen::Matrix4d transformation = outer * transformation_of(m_nodes[node]);
      add_instances(node, transformation);
      const std::vector<std::size_t> children = indices_of(m_nodes[node], "children");
      for(auto child = children.rbegin(); child != children.rend(); ++child)
        next.emplace_back(*child, transformation);
    }
  }

  void add_instances(std::size_t index, const Eigen::Matrix4d& transformation)
  {
    const Json& node = m_nodes[index];
    const std::optional<std::size_t> mesh = find_number(node, "mesh");
    if(!mesh)
      return;
    item(m_document.description(), "meshes", *mesh);
    m_is_shown[*mesh] = 1;
    const Json* const extensions = find(node, "extensions");
    const Json* const instancing = extensions == nullptr ? nullptr : find(*extensions, "EXT_mesh_gpu_instancing");
    const Json* const attributes = instancing == nullptr ? nullptr : find(*instancing, "attributes");
    if(find(node, "skin") != nullptr)
      m_instances.push_back({*mesh, index, Eigen::Matrix4d::Identity()});
    else if(attributes == nullptr)
      m_instances.push_back({*mesh, index, transformation});
    else
    {
      const Places places(m_document, *attributes);
      for(std::size_t i = 0; i < places.number(); ++i)
        m_instances.push_back({*mesh, index, transformation * places[i]});
    }
  }

  const Document& m_document;
  const Json& m_nodes;
  std::vector<char> m_has_parent, m_is_met, m_is_shown;
  std::vector<Instance> m_instances;
};

} // namespace

std::vector<Instance> find_instances(const Document& document) { return Scene_walk(document).run(); }

} // namespace gltf
