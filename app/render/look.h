// How the solution is shown: choices shared by all panes that are compared.
#pragma once

#include "iteration/snapshot.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string_view>

namespace penumbra {

/// What a fragment shows of its element: the polynomial itself, its mean, or Gouraud's interpolation of corner values
/// averaged over the patches of the surface that meet there.
enum class Shading { polynomial, flat, linear };
/// `polynomial`, `flat`, `linear`; the public names.
std::string_view name(Shading shading);
std::optional<Shading> shading_from_name(std::string_view name);

struct Layers {
    bool mesh = true;   ///< sides of the patches
    bool curves = true; ///< discontinuity curves, coloured by kind
    bool links = false; ///< from receiver to source centres
};

/// Radiosities that are told apart [W/m2].
struct Range {
    double low = 0, high = 1;
    bool operator==(const Range &) const = default;
};

enum class Theme { dark, light };
glm::vec4 background_colour(Theme theme); ///< sRGB

struct Look {
    Shading shading = Shading::polynomial;
    Layers layers;
    double exposure_ev = 0;     ///< radiosity is multiplied by 2^EV before it is shown
    std::optional<Range> range; ///< none: each pane takes common_range() of its own snapshot
    bool false_colour = false;  ///< cividis over the range, in place of true colour
    bool emphasise_fresh = true; ///< patches made in this iteration are outlined brighter
    Theme theme = Theme::dark;
};

/// 0 to the largest reflected radiosity of all snapshots, rounded up to two significant digits, so that panes that are
/// compared can share it; before anything is lit, to the largest exitance; where every surface that reflects also emits,
/// to the sum of both.
Range common_range(std::span<const Snapshot *const> snapshots);

/// Pixels to a "pixel" of line widths and dashes: 1 on an ordinary screen, more on a dense one or in a large picture.
struct PixelScale {
    double factor = 1;
};

} // namespace penumbra
