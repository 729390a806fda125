// The options that say how a picture looks.
#pragma once

#include "render/camera.h"
#include "render/look.h"
#include "scene/scene.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

struct LookOptions {
    int width = 1280, height = 960; ///< pixels
    int supersample = 1; ///< drawn so many times larger and averaged
    bool labels = true, legend = true;
    std::optional<bool> fresh; ///< new patches stand out; none: where steps are counted
    Look look;
    std::optional<View> view; ///< for pictures of 4:3 and wider; none: the scene's own
    std::vector<Camera> cameras;  ///< by pane, before all other views; empty: all panes have the one
    std::vector<double> exposures; ///< by pane; empty: all panes have the look's
    std::vector<std::optional<Range>> ranges, error_ranges; ///< by pane, none: its own; empty: all panes share one
    std::optional<Camera> camera; ///< whatever the picture's shape; the view goes before
    std::string caption; ///< below the panes; empty: none
    std::string curve_source; ///< name or number of a surface; empty: all
    std::optional<std::pair<Vec3, Vec3>> profile; ///< ends of a line; none: no profile
    std::optional<Vec3> keyhole; ///< to look at the emitters from; none: nowhere
};

/// --size, --supersample, --transparent, --labels, --legend, --layers, --fresh, --curve-kinds, --curve-orders,
/// --curve-source, --curve, --keyhole, --profile, --shading, --error, --error-range, --view, --camera, --pane-camera, --exposure,
/// --pane-exposure, --range, --pane-range, --pane-error-range, --false-colour, --background; most of the flags with a --no- of their own.
void add_look_options(CLI::App &parser, LookOptions &options);

} // namespace penumbra
