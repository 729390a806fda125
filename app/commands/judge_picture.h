// What pictures of errors and profiles are held against.
#pragma once

#include "commands/profile_along.h"
#include "commands/solving_options.h"
#include "core/cancel.h"
#include "render/picture.h"

#include <memory>
#include <optional>

namespace penumbra {

/// Gives every pane its map of errors, where they are shown, and makes the profile along the line, if there is one. Solves a
/// reference first where light is reflected again. Cancellable.
std::optional<ProfileData> judge(const std::shared_ptr<const Scene> &scene, PictureSpec &spec, const Cancel &cancel,
                                 const CommonOptions &common);

} // namespace penumbra
