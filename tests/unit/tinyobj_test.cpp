// Two independent readers must agree: tinyobjloader on the bundled scenes, from whose text it takes the same polygons.
#include "scene/read_obj.h"

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

namespace penumbra {
namespace {

TEST(TinyObj, AgreesOnTheBundledScenes) {
    int n_compared = 0;
    for (const auto &entry : std::filesystem::directory_iterator(PENUMBRA_SOURCE_DIR "/assets/scenes")) {
        if (entry.path().extension() != ".obj")
            continue;
        tinyobj::ObjReader other;
        tinyobj::ObjReaderConfig config;
        config.triangulate = false;
        ASSERT_TRUE(other.ParseFromFile(entry.path().string(), config)) << other.Error();
        const Scene scene = read_obj(entry.path());
        const auto &x = other.GetAttrib().vertices;
        int face = 0;
        for (const tinyobj::shape_t &shape : other.GetShapes()) {
            std::size_t at = 0;
            for (std::size_t f = 0; f < shape.mesh.num_face_vertices.size(); ++f, ++face) {
                const std::size_t n = shape.mesh.num_face_vertices[f];
                const auto &material = other.GetMaterials()[static_cast<std::size_t>(shape.mesh.material_ids[f])];
                for (const Surface &s : scene.surfaces) {
                    if (s.face != face || s.corners.size() != n) // a bent face is in pieces
                        continue;
                    ++n_compared;
                    EXPECT_EQ(s.name, shape.name);
                    for (std::size_t i = 0; i < n; ++i) {
                        const auto v = static_cast<std::size_t>(shape.mesh.indices[at + i].vertex_index);
                        const Vec3 theirs(x[3 * v], x[3 * v + 1], x[3 * v + 2]);
                        EXPECT_NEAR((scene.own.to_own(s.corners[i]) - theirs).norm() / scene.own.size, 0, 1e-14);
                    }
                    const Material &ours = scene.materials[static_cast<std::size_t>(s.material)];
                    for (int c = 0; c < 3; ++c) {
                        EXPECT_NEAR(ours.reflectance[c], material.diffuse[c], 1e-15);
                        EXPECT_NEAR(ours.exitance[c], material.emission[c], 1e-14);
                    }
                }
                at += n;
            }
        }
    }
    EXPECT_EQ(n_compared, 3 + 3 + 15 + 6 + 4 + 8 + 15 + 14 + 32 + 15 + 8 + 5 + 310 + 10 + 5 + 5 + 3 + 5 + 2 + 4 + 5);
}

} // namespace
} // namespace penumbra
