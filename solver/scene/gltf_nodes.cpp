#include "scene/gltf_nodes.h"

#include <cmath>
#include <fmt/format.h>

namespace penumbra {

namespace {

template <std::size_t N>
std::optional<Eigen::Matrix<double, N, 1>> numbers(const JsonValue &node, const char *key) {
    const auto list = node.find(key);
    if (!list)
        return std::nullopt;
    if (list->size() != N)
        list->fail(fmt::format("has {} numbers; give {}", list->size(), N));
    Eigen::Matrix<double, N, 1> out;
    for (std::size_t i = 0; i < N; ++i)
        out[static_cast<Eigen::Index>(i)] = list->at(i).number();
    return out;
}

Eigen::Affine3d transform_of(const JsonValue &node) {
    Eigen::Affine3d out = Eigen::Affine3d::Identity();
    if (const auto matrix = numbers<16>(node, "matrix")) {
        out.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix->data()); // both by columns
        if (out.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
            node["matrix"].fail("is not affine; its last row has to be 0 0 0 1");
        return out;
    }
    if (const auto t = numbers<3>(node, "translation"))
        out.translate(*t);
    if (const auto r = numbers<4>(node, "rotation")) {
        const double length = r->stableNorm();
        if (!(length > 0 && std::isfinite(length)))
            node["rotation"].fail("is a quaternion of length 0; give one of length 1, say 0 0 0 1");
        const Vec3 axis = r->head<3>() / length;
        out.rotate(Eigen::Quaterniond((*r)[3] / length, axis.x(), axis.y(), axis.z()));
    }
    if (const auto s = numbers<3>(node, "scale"))
        out.scale(*s);
    return out;
}

/// Indices of the nodes without a parent.
std::vector<std::size_t> tree_roots(const JsonValue &nodes) {
    std::vector<bool> has_parent(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const JsonValue children = nodes.at(i).list("children");
        for (std::size_t c = 0; c < children.size(); ++c)
            has_parent[children.at(c).index_into(nodes)] = true;
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!has_parent[i])
            roots.push_back(i);
    return roots;
}

} // namespace

std::vector<GltfNode> gltf_nodes(const JsonValue &root) {
    const JsonValue nodes = root.list("nodes"), scenes = root.list("scenes");
    struct Pending {
        std::size_t index;
        Eigen::Affine3d parent;
    };
    std::vector<Pending> stack; // the next one last
    std::vector<bool> is_reached(nodes.size());
    const auto push = [&](std::size_t index, const Eigen::Affine3d &parent) {
        if (is_reached[index])
            nodes.at(index).fail("is reached twice; a node has one parent");
        is_reached[index] = true;
        stack.push_back({index, parent});
    };
    const auto push_list = [&](const JsonValue &list, const Eigen::Affine3d &parent) {
        for (std::size_t i = list.size(); i-- > 0;)
            push(list.at(i).index_into(nodes), parent);
    };
    if (scenes.size() > 0) {
        const auto chosen = root.find("scene");
        push_list(scenes.at(chosen ? chosen->index_into(scenes) : 0).list("nodes"), Eigen::Affine3d::Identity());
    } else {
        const auto roots = tree_roots(nodes);
        for (std::size_t i = roots.size(); i-- > 0;)
            push(roots[i], Eigen::Affine3d::Identity());
    }
    std::vector<GltfNode> out;
    while (!stack.empty()) {
        const Pending at = stack.back();
        stack.pop_back();
        const JsonValue node = nodes.at(at.index);
        out.push_back({at.index, at.parent * transform_of(node)});
        push_list(node.list("children"), out.back().to_scene);
    }
    return out;
}

} // namespace penumbra
