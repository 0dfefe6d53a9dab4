// Where the scene of a glTF file shows its meshes.

#ifndef UNWRAP_GLTF_SCENE_H
#define UNWRAP_GLTF_SCENE_H

#include "Gltf_document.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace gltf {

struct Instance
{
  std::size_t mesh;
  std::optional<std::size_t> node; // none for a mesh that no node shows
  Eigen::Matrix4d transformation;
};

// Everything that the file has: what the nodes of its scene show, then what other nodes do, then other meshes, untransformed.
// Nodes that place their mesh several times are as many instances; those with a skin do not transform it, as the standard
// says. Fails unless the nodes are trees.
std::vector<Instance> find_instances(const Document& document);

} // namespace gltf

#endif // UNWRAP_GLTF_SCENE_H
