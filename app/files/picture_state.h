// What a picture was made from, as the JSON that its file carries.
#pragma once

#include "render/picture.h"

#include <filesystem>
#include <string>

namespace penumbra {

/// Scene, options, step, strategies, camera, layers and range, under the names that the window's saved states have.
std::string picture_state(const PictureSpec &spec, const std::filesystem::path &scene_file);

} // namespace penumbra
