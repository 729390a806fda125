// The line of a profile in the scene, on any ImGui draw list.
#pragma once

#include "iteration/profile.h"
#include "render/camera.h"
#include "render/labels.h"

#include <optional>

namespace penumbra {

/// In the rectangle of a pane: the line from A to B (or what two letters its ends have), and a ring about the place that
/// is looked at, if any.
void draw_profile_mark(ImDrawList &list, const Fonts &fonts, ImVec2 low, ImVec2 high, const Camera &camera,
                       const ProfileLine &line, std::optional<double> at = std::nullopt, const char *letters = "AB");

} // namespace penumbra
