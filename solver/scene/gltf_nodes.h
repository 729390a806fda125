// The tree of a glTF scene: where its meshes and cameras stand.
#pragma once

#include "core/vec.h"
#include "scene/json_value.h"

#include <vector>

namespace penumbra {

struct GltfNode {
    std::size_t index = 0; ///< in the file's list of nodes
    Eigen::Affine3d to_scene = Eigen::Affine3d::Identity();
};

/// The nodes of the default scene, of the only or first one where no default is named, or of all trees where there is
/// no scene; parents before their children, in file order. Throws BadInput for an index out of range, a node that is
/// reached twice (so there are no cycles), and a transform that is none (not affine, a rotation of length 0).
std::vector<GltfNode> gltf_nodes(const JsonValue &root);

} // namespace penumbra
