// The options that say how a picture looks.
#pragma once

#include "render/look.h"
#include "scene/scene.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <utility>

namespace penumbra {

struct LookOptions {
    int width = 1280, height = 960; ///< pixels
    Look look;
    std::optional<View> view; ///< none: the scene's own
    std::string curve_source; ///< name or number of a surface; empty: all
    std::optional<std::pair<Vec3, Vec3>> profile; ///< ends of a line; none: no profile
    std::optional<Vec3> keyhole; ///< to look at the emitters from; none: nowhere
};

/// --size, --layers, --curve-kinds, --curve-orders, --curve-source, --curve, --keyhole, --profile, --shading, --error,
/// --error-range, --view,
/// --exposure, --range, --false-colour, --background.
void add_look_options(CLI::App &parser, LookOptions &options);

} // namespace penumbra
