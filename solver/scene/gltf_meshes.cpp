#include "scene/gltf_meshes.h"

#include "scene/merge_triangles.h"

#include <fmt/format.h>
#include <unordered_map>

namespace penumbra {

namespace {

/// Exporters repeat a position for every normal and texture coordinate; equal positions are one point again.
struct SamePosition {
    std::size_t operator()(const Vec3 &x) const {
        std::size_t h = 0;
        for (const double c : x)
            h = h * 0x9E3779B97F4A7C15U + std::hash<double>()(c);
        return h ^ h >> 32;
    }
    bool operator()(const Vec3 &a, const Vec3 &b) const { return a == b; }
};

constexpr int triangle_list = 4, triangle_fan = 6; // 5: strip

/// Numbers of the vertices of the t-th triangle.
std::array<std::size_t, 3> vertices_of(int mode, std::size_t t) {
    if (mode == triangle_list)
        return {3 * t, 3 * t + 1, 3 * t + 2};
    if (mode == triangle_fan)
        return {t + 1, t + 2, 0};
    return {t, t + 1 + t % 2, t + 2 - t % 2}; // every other one of a strip turns the other way
}

} // namespace

struct GltfMeshes::Triangles {
    std::vector<Vec3> points;
    std::unordered_map<Vec3, int, SamePosition, SamePosition> numbers;
    std::vector<MeshTriangle> triangles;

    int number(const Vec3 &x) {
        const auto [at, is_new] = numbers.emplace(x, static_cast<int>(points.size()));
        if (is_new)
            points.push_back(x);
        return at->second;
    }
};

void GltfMeshes::read_primitive(const JsonValue &primitive, Triangles &out, Skipped &skipped) {
    const auto mode_value = primitive.find("mode");
    const int mode = static_cast<int>(mode_value ? mode_value->integer(0, 6) : triangle_list);
    if (mode < triangle_list) {
        skipped.add("points and lines");
        return;
    }
    if (primitive.find("targets"))
        skipped.add("morph targets");
    if (const auto extensions = primitive.find("extensions");
        extensions && extensions->find("KHR_draco_mesh_compression"))
        primitive.fail("is compressed (KHR_draco_mesh_compression), which is not read; export it without compression");
    const JsonValue materials = root_.list("materials");
    const auto material_value = primitive.find("material");
    const std::size_t material = material_value ? material_value->index_into(materials) : materials.size();
    const GltfAccessor positions = buffers_.positions(primitive["attributes"]["POSITION"]);
    const auto indices_value = primitive.find("indices");
    const auto indices = indices_value ? std::optional(buffers_.indices(*indices_value)) : std::nullopt;
    const std::size_t n_vertices = indices ? indices->count : positions.count;
    if (mode == triangle_list && n_vertices % 3 != 0)
        primitive.fail(fmt::format("has {} vertices, not three for each triangle; export it again", n_vertices));
    const std::size_t n = mode == triangle_list ? n_vertices / 3 : n_vertices < 3 ? 0 : n_vertices - 2;
    n_triangles_ += n;
    if (n_triangles_ > most_triangles)
        primitive.fail(fmt::format("makes it more than {} triangles; simplify the scene", most_triangles));
    for (std::size_t t = 0; t < n; ++t) {
        MeshTriangle &triangle = out.triangles.emplace_back();
        triangle.material = static_cast<int>(material);
        const auto vertices = vertices_of(mode, t);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t v = indices ? indices->index(vertices[i]) : vertices[i];
            if (v >= positions.count)
                primitive.fail(
                    fmt::format("has vertex index {}, out of range; there are {} positions", v, positions.count));
            const Vec3 x = positions.vec3(v);
            if (!x.allFinite())
                primitive.fail(fmt::format("has a position ({}, {}, {}) that is not finite; give finite coordinates",
                                           x.x(), x.y(), x.z()));
            triangle.corners[i] = out.number(x);
        }
    }
}

const std::vector<GltfFace> &GltfMeshes::faces(const JsonValue &mesh, Skipped &skipped) {
    const JsonValue meshes = root_.list("meshes");
    const std::size_t index = mesh.index_into(meshes);
    const auto [at, is_new] = read_.try_emplace(index);
    if (!is_new)
        return at->second;
    const JsonValue primitives = meshes.at(index).list("primitives");
    Triangles read;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        read_primitive(primitives.at(i), read, skipped);
    for (const MergedFace &merged : merge_triangles(read.points, read.triangles)) {
        GltfFace &face = at->second.emplace_back();
        for (const int c : merged.corners)
            face.corners.push_back(read.points[static_cast<std::size_t>(c)]);
        face.material = static_cast<std::size_t>(merged.material);
        face.where = fmt::format("meshes[{}] triangle {}", index, merged.first);
    }
    return at->second;
}

} // namespace penumbra
