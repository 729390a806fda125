// The scenes of assets/scenes, held in the program itself: an installed or a moved program finds them.
#pragma once

#include "scene/scene.h"

#include <span>
#include <string_view>

namespace penumbra {

struct BundledScene {
    std::string_view name; ///< as commands take it: `figure-4`
    std::string_view obj, mtl;

    std::string description() const;
};

std::span<const BundledScene> bundled_scenes();

/// Its `file` is empty. Nothing when there is none of that name.
std::optional<Scene> open_bundled_scene(const std::string &name, const std::optional<Vec3> &up = std::nullopt);

/// What `name` stands for in every command: the file of that name where there is one, else the bundled scene. Throws
/// BadInput as read_obj and read_gltf do, and names the bundled scenes when there is neither.
/// Which reader a file asks for its name's end says: .gltf and .glb, else OBJ. `up`: the format's own (OBJ z, glTF y)
/// unless given.
Scene open_scene(const std::string &name, const std::optional<Vec3> &up = std::nullopt);

} // namespace penumbra
