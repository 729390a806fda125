#include "unit/gltf_draft.h"

#include <bit>

namespace penumbra {

namespace {

void put(std::string &bytes, std::uint32_t value, int n_bytes) {
    for (int i = 0; i < n_bytes; ++i)
        bytes += static_cast<char>(value >> 8 * i & 0xff);
}

void put(std::string &bytes, double value) { put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); }

std::string base64(const std::string &bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return out;
}

} // namespace

int GltfDraft::accessor(std::size_t first, std::size_t count, const char *type, int component) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", first}, {"byteLength", bytes.size() - first}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfDraft::vec3(const std::vector<Vec3> &values) {
    const std::size_t first = bytes.size();
    for (const Vec3 &x : values)
        for (const double c : x)
            put(bytes, c);
    return accessor(first, values.size(), "VEC3", 5126);
}

int GltfDraft::vec2(std::size_t n_zeros) {
    const std::size_t first = bytes.size();
    bytes.append(8 * n_zeros, '\0');
    return accessor(first, n_zeros, "VEC2", 5126);
}

int GltfDraft::shorts(const std::vector<int> &values) {
    const std::size_t first = bytes.size();
    for (const int v : values)
        put(bytes, static_cast<std::uint32_t>(v), 2);
    return accessor(first, values.size(), "SCALAR", 5123);
}

int GltfDraft::material(const std::string &name, const Rgb &reflectance, const Rgb &exitance) {
    json["materials"].push_back(
        {{"name", name},
         {"pbrMetallicRoughness", {{"baseColorFactor", {reflectance[0], reflectance[1], reflectance[2], 1}}}}});
    if (const double strength = exitance.maxCoeff(); strength > 0) {
        nlohmann::json &m = json["materials"].back();
        m["emissiveFactor"] = {exitance[0] / strength, exitance[1] / strength, exitance[2] / strength};
        m["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
    }
    return static_cast<int>(json["materials"].size()) - 1;
}

int GltfDraft::mesh(const std::vector<Vec3> &positions, const std::vector<int> &indices, int material) {
    const int p = vec3(positions), i = shorts(indices);
    json["meshes"].push_back(
        {{"primitives", {{{"attributes", {{"POSITION", p}}}, {"indices", i}, {"material", material}}}}});
    return static_cast<int>(json["meshes"].size()) - 1;
}

int GltfDraft::node(const std::string &name, int mesh) {
    json["nodes"].push_back({{"name", name}, {"mesh", mesh}});
    return static_cast<int>(json["nodes"].size()) - 1;
}

std::string GltfDraft::gltf() const { return gltf_beside("data:application/octet-stream;base64," + base64(bytes)); }

std::string GltfDraft::gltf_beside(const std::string &buffer) const {
    nlohmann::json out = json;
    out["buffers"] = {{{"byteLength", bytes.size()}, {"uri", buffer}}};
    return out.dump(1);
}

std::string GltfDraft::glb() const {
    nlohmann::json out = json;
    out["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string text = out.dump(), file = "glTF";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto u32 = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
    put(file, 2, 4);
    put(file, u32(12 + 8 + text.size() + 8 + bytes.size()), 4);
    put(file, u32(text.size()), 4);
    file += "JSON" + text;
    put(file, u32(bytes.size()), 4);
    return file + std::string("BIN\0", 4) + bytes;
}

BoxMesh box_mesh(const Vec3 &low, const Vec3 &high, bool inward) {
    BoxMesh box;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool is_high : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3, first = static_cast<int>(box.positions.size());
            for (const auto &[p, q] : {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
                Vec3 x;
                x[axis] = is_high ? high[axis] : low[axis];
                x[u] = p ? high[u] : low[u];
                x[v] = q ? high[v] : low[v];
                box.positions.push_back(x);
            }
            const bool keeps_order = is_high != inward;
            for (const int i : {0, 1, 2, 0, 2, 3})
                box.indices.push_back(first + (keeps_order ? i : 3 - i));
        }
    return box;
}

Scene scene_of(const GltfDraft &draft) {
    return read_gltf_bytes("t.gltf", draft.gltf(), [](const std::string &) { return std::nullopt; });
}

} // namespace penumbra
