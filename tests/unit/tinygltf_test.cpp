// Two independent readers must agree: tinygltf on a file with instances, interleaved values and short indices.
#include "gltf_draft.h"

#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <tiny_gltf.h>

namespace penumbra {
namespace {

template <class T>
T value_at(const tinygltf::Model &model, const tinygltf::Accessor &a, std::size_t i, std::size_t n_bytes) {
    const tinygltf::BufferView &view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
    T value;
    std::memcpy(&value,
                model.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset + a.byteOffset +
                    i * static_cast<std::size_t>(a.ByteStride(view)) + n_bytes,
                sizeof value);
    return value;
}

/// Area of each material's triangles where the nodes put them; nodes without parents, scaled and moved.
std::map<std::string, double> areas_of(const tinygltf::Model &model) {
    std::map<std::string, double> areas;
    for (const tinygltf::Node &node : model.nodes) {
        const Vec3 scale = node.scale.empty() ? Vec3(1, 1, 1) : Vec3(node.scale[0], node.scale[1], node.scale[2]);
        for (const tinygltf::Primitive &p : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
            const auto &positions = model.accessors[static_cast<std::size_t>(p.attributes.at("POSITION"))];
            const auto &indices = model.accessors[static_cast<std::size_t>(p.indices)];
            for (std::size_t t = 0; t + 2 < indices.count; t += 3) {
                Vec3 x[3];
                for (std::size_t i = 0; i < 3; ++i)
                    for (std::size_t c = 0; c < 3; ++c) {
                        const auto v = value_at<std::uint16_t>(model, indices, t + i, 0);
                        x[i][static_cast<Eigen::Index>(c)] =
                            scale[static_cast<Eigen::Index>(c)] *
                            static_cast<double>(value_at<float>(model, positions, v, 4 * c));
                    }
                areas[model.materials[static_cast<std::size_t>(p.material)].name] +=
                    (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
            }
        }
    }
    return areas;
}

TEST(TinyGltf, AgreesOnTextAndBinary) {
    GltfDraft draft;
    const int a = draft.material("a", {0.1, 0.2, 0.3}), b = draft.material("b", {0.7, 0.6, 0.5}, {3, 2, 1});
    const BoxMesh room = box_mesh({-1.7, -2.3, 0.1}, {3.3, 2.9, 4.7}, true),
                  box = box_mesh({0.1, 0.2, 0.3}, {0.7, 1.1, 1.3});
    draft.node("room", draft.mesh(room.positions, room.indices, a));
    const int mesh = draft.mesh(box.positions, box.indices, b);
    draft.json["nodes"].push_back({{"name", "one"}, {"mesh", mesh}, {"translation", {0.5, -1, 0.25}}});
    draft.json["nodes"].push_back({{"name", "two"}, {"mesh", mesh}, {"scale", {1.5, 0.5, -2}}});
    for (const bool is_binary : {false, true}) {
        tinygltf::Model model;
        tinygltf::TinyGLTF loader;
        std::string error, warning;
        const std::string file = is_binary ? draft.glb() : draft.gltf();
        const auto n = static_cast<unsigned>(file.size());
        ASSERT_TRUE(is_binary ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                            reinterpret_cast<const unsigned char *>(file.data()), n)
                              : loader.LoadASCIIFromString(&model, &error, &warning, file.data(), n, "."))
            << error;
        const Scene scene = read_gltf_bytes("t.gltf", file, [](const std::string &) { return std::nullopt; });
        EXPECT_EQ(scene.n_surfaces(), 18);
        std::map<std::string, double> ours;
        for (const Surface &s : scene.surfaces)
            ours[scene.materials[static_cast<std::size_t>(s.material)].name] +=
                s.area * scene.own.size * scene.own.size;
        const auto theirs = areas_of(model);
        ASSERT_EQ(ours.size(), theirs.size());
        for (const auto &[name, area] : theirs)
            EXPECT_NEAR(ours[name] / area, 1, 1e-12) << name;
        for (std::size_t m = 0; m < model.materials.size(); ++m)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(scene.materials[m].reflectance[c],
                          model.materials[m].pbrMetallicRoughness.baseColorFactor[static_cast<std::size_t>(c)]);
    }
}

} // namespace
} // namespace penumbra
