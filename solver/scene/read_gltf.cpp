#include "scene/read_gltf.h"

#include "core/beside.h"
#include "core/read_text.h"
#include "scene/build_scene.h"
#include "scene/gltf_container.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_meshes.h"
#include "scene/gltf_nodes.h"
#include "scene/mend.h"
#include "scene/validate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace penumbra {

namespace {

/// Extensions that change nothing that is read here, and those that are read.
bool is_harmless(std::string_view extension) {
    constexpr std::array known{"KHR_mesh_quantization", "KHR_texture_transform", "KHR_texture_basisu",
                               "EXT_texture_webp",      "EXT_texture_avif",      "KHR_lights_punctual"};
    return extension.starts_with("KHR_materials_") || std::ranges::find(known, extension) != known.end();
}

void check_asset(const JsonValue &root) {
    if (const JsonValue version = root["asset"]["version"]; !version.text().starts_with("2."))
        version.fail("is " + in_quotes(version.text()) + "; export it as glTF 2.0");
    const JsonValue required = root.list("extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i)
        if (const std::string name = required.at(i).text(); !is_harmless(name))
            required.at(i).fail("is " + in_quotes(name) + ", which is not read; export it without");
}

void count_skipped(const JsonValue &root, Skipped &skipped) {
    for (const char *key : {"animations", "skins"})
        if (const auto n = static_cast<int>(root.list(key).size()))
            skipped.add(key, n);
    if (const auto extensions = root.find("extensions"))
        if (const auto lights = extensions->find("KHR_lights_punctual"))
            skipped.add("lights (only surfaces emit)", static_cast<int>(lights->list("lights").size()));
}

void add_faces(RawScene &raw, const std::vector<GltfFace> &faces, const GltfNode &node, const std::string &object,
               const GltfMaterials &materials, FaceCount &count) {
    const bool is_mirrored = node.to_scene.linear().determinant() < 0;
    for (const GltfFace &face : faces) {
        count.add(raw.file.string(), face.corners.size());
        RawFace &out = raw.faces.emplace_back();
        out.object = object;
        out.where = fmt::format("{}: nodes[{}] {}", raw.file.string(), node.index, face.where);
        out.material = static_cast<int>(face.material);
        out.double_sided = materials.double_sided[face.material];
        for (const Vec3 &x : face.corners)
            out.corners.push_back(node.to_scene * x);
        if (is_mirrored)
            std::ranges::reverse(out.corners);
    }
}

/// glTF's cameras look along their -z; the view's target is the point before it that is nearest to the scene's centre.
std::optional<View> view_of(const JsonValue &camera, const GltfNode &node, const OwnFrame &own) {
    const auto perspective = camera.find("perspective");
    if (!perspective)
        return std::nullopt;
    const JsonValue angle = (*perspective)["yfov"];
    const double fov = angle.number() * 180 / std::numbers::pi;
    if (!(fov > 0 && fov < 180))
        angle.fail(fmt::format("is {:g}; give an angle between 0 and pi", angle.number()));
    const Vec3 eye = node.to_scene.translation();
    const Vec3 forward = (node.to_scene.linear() * -Vec3::UnitZ()).stableNormalized();
    const double ahead = forward.dot(own.centre - eye);
    const Vec3 target = eye + (ahead > 0 ? ahead : own.size) * forward;
    if (!eye.allFinite() || !target.allFinite() || eye == target)
        return std::nullopt; // a node of scale 0
    return View{eye, target, fov};
}

std::optional<View> first_view(const JsonValue &root, const std::vector<GltfNode> &nodes, const OwnFrame &own) {
    const JsonValue list = root.list("nodes"), cameras = root.list("cameras");
    for (const GltfNode &node : nodes)
        if (const auto camera = list.at(node.index).find("camera"))
            if (const auto view = view_of(cameras.at(camera->index_into(cameras)), node, own))
                return view;
    return std::nullopt;
}

std::string name_of(const JsonValue &node, const JsonValue &mesh) {
    for (const JsonValue &named : {node, mesh})
        if (const auto name = named.find("name"))
            return name->text(longest_name);
    return "";
}

void note_grey(RawScene &raw, const GltfMaterials &materials) {
    std::vector<int> n_faces(raw.materials.size());
    for (const RawFace &face : raw.faces)
        ++n_faces[static_cast<std::size_t>(face.material)];
    Notes notes;
    for (std::size_t m = 0; m < n_faces.size(); ++m)
        if (n_faces[m] > 0 && materials.is_grey[m])
            notes.add("materials without a baseColorFactor",
                      fmt::format("{}: {} {}: grey 0.5 is taken", raw.file.string(), n_faces[m],
                                  (n_faces[m] == 1 ? "face " : "faces ") +
                                      (m + 1 == n_faces.size() ? std::string("without a material")
                                                               : "of material " + in_quotes(raw.materials[m].name) +
                                                                     " without a baseColorFactor")));
    notes.append_to(raw.notes);
}

} // namespace

Scene read_gltf_bytes(const std::filesystem::path &file, std::string_view bytes, const OpenBuffer &open,
                      const Vec3 &up) {
    const std::string name = file.string();
    const GltfContainer container = split_container(name, bytes);
    const nlohmann::json json = parse_json(name, container.json);
    const JsonValue root(json, name);
    check_asset(root);
    RawScene raw;
    raw.name = file.stem().string();
    raw.file = file;
    raw.up = up;
    raw.reflectance_key = "baseColorFactor";
    raw.exitance_key = "emissiveFactor";
    Skipped skipped;
    const GltfMaterials materials = read_gltf_materials(root, skipped);
    raw.materials = materials.materials;
    count_skipped(root, skipped);
    GltfMeshes meshes(root, GltfBuffers(root, container.binary, open));
    const std::vector<GltfNode> nodes = gltf_nodes(root);
    const JsonValue node_list = root.list("nodes"), mesh_list = root.list("meshes");
    FaceCount count;
    for (const GltfNode &node : nodes) {
        const JsonValue place = node_list.at(node.index);
        if (const auto mesh = place.find("mesh"))
            add_faces(raw, meshes.faces(*mesh, skipped), node,
                      name_of(place, mesh_list.at(mesh->index_into(mesh_list))), materials, count);
    }
    note_grey(raw, materials);
    skipped.append_to(raw.notes, name);
    Scene scene = build_scene(std::move(raw));
    scene.view = first_view(root, nodes, scene.own);
    return scene;
}

Scene read_gltf(const std::filesystem::path &file, const Vec3 &up) {
    const std::string bytes = read_bytes(file, largest_gltf);
    const auto open = [&](const std::string &name) -> std::optional<std::string> {
        const auto found = beside(file, name);
        return found ? std::optional(read_bytes(*found, largest_buffers)) : std::nullopt;
    };
    return read_gltf_bytes(file, bytes, open, up);
}

} // namespace penumbra
