#include "scene/bundled.h"

#include "core/error.h"
#include "scene/obj_header.h"
#include "scene/read_gltf.h"
#include "scene/read_obj.h"

#include <algorithm>
#include <cctype>

namespace penumbra {

std::string BundledScene::description() const { return read_obj_header(obj).description; }

namespace {

bool is_gltf(const std::filesystem::path &file) {
    std::string suffix = file.extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix == ".gltf" || suffix == ".glb";
}

} // namespace

std::optional<Scene> open_bundled_scene(const std::string &name, const std::optional<Vec3> &up) {
    const auto found = std::ranges::find(bundled_scenes(), name, &BundledScene::name);
    if (found == bundled_scenes().end())
        return std::nullopt;
    Scene scene = read_obj_text(
        name + ".obj", found->obj, [&](const std::string &) { return std::string(found->mtl); },
        up.value_or(Vec3::UnitZ()));
    scene.file.clear();
    return scene;
}

Scene open_scene(const std::string &name, const std::optional<Vec3> &up) {
    std::error_code none;
    if (std::filesystem::is_directory(name, none))
        if (auto scene = open_bundled_scene(name, up))
            return *std::move(scene);
    if (std::filesystem::exists(name, none))
        return is_gltf(name) ? read_gltf(name, up.value_or(Vec3::UnitY())) : read_obj(name, up.value_or(Vec3::UnitZ()));
    if (auto scene = open_bundled_scene(name, up))
        return *std::move(scene);
    std::string known;
    for (const BundledScene &scene : bundled_scenes())
        known += (known.empty() ? "" : ", ") + std::string(scene.name);
    throw BadInput(name + ": there is no such file; the bundled scenes are " + known);
}

} // namespace penumbra
