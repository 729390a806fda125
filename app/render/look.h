// How the solution is shown: choices shared by all panes that are compared.
#pragma once

#include "iteration/snapshot.h"
#include "render/curve_filter.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string_view>

namespace penumbra {

/// What a fragment shows of its element: the polynomial itself, its mean, or Gouraud's interpolation of corner values
/// averaged over the patches of the surface that meet there; or how wrong the polynomial is.
enum class Shading { polynomial, flat, linear, error };
/// `polynomial`, `flat`, `linear`, `error`; the public names.
std::string_view name(Shading shading);
std::optional<Shading> shading_from_name(std::string_view name);

/// Of error pictures; see error_scale.h. Signed: B_h - B, the mean of the channels. Relative: its root mean square over the
/// channels as a share of the largest B - E; not of B itself, which is 0 in full shadow. Patch: the L2 error of each patch as
/// a share of ||B - E||. Estimate: that error over what the oracle saw there.
enum class ErrorKind { signed_error, relative, patch, estimate };
inline constexpr ErrorKind all_error_kinds[] = {ErrorKind::signed_error, ErrorKind::relative, ErrorKind::patch,
                                                ErrorKind::estimate};
/// `signed`, `relative`, `patch`, `estimate`; the public names.
std::string_view name(ErrorKind kind);
std::optional<ErrorKind> error_kind_from_name(std::string_view name);

struct Layers {
    bool mesh = true;   ///< sides of the patches
    bool curves = true; ///< discontinuity curves, coloured by kind
    bool links = false; ///< from receiver to source centres
    bool operator==(const Layers &) const = default;
};

/// Radiosities that are told apart [W/m2], or errors in the unit of their kind.
struct Range {
    double low = 0, high = 1;
    bool operator==(const Range &) const = default;
};

enum class Theme { dark, light };
glm::vec4 background_colour(Theme theme); ///< sRGB

/// The curve that stands out among the others.
struct Spotlight {
    int curve = -1;      ///< of snapshot.curves; -1: none
    bool surface = true; ///< with the surface of lines of sight that throws it
    bool operator==(const Spotlight &) const = default;
};

/// Of two strategies' solutions at one step, the second minus the first.
struct Difference {
    Strategy first{}, second{};
    bool operator==(const Difference &) const = default;
};

struct Look {
    Shading shading = Shading::polynomial;
    Layers layers;
    double exposure_ev = 0;     ///< radiosity is multiplied by 2^EV before it is shown
    std::optional<Range> range; ///< none: each pane takes common_range() of its own snapshot
    bool false_colour = false;  ///< cividis over the range, in place of true colour
    bool emphasise_fresh = true; ///< patches made in this iteration are outlined brighter
    ErrorKind error = ErrorKind::signed_error; ///< that Shading::error shows
    std::optional<EffectChange> change; ///< errors are from a solution with this effect switched otherwise; none: from the truth
    std::optional<Difference> difference; ///< signed errors are this, with the first in place of the truth; none: they are not
    std::optional<Range> error_range; ///< of that kind; none: whoever draws takes error_range() of all panes
    CurveFilter curve_filter;
    Spotlight spotlight;
    Theme theme = Theme::dark;
    bool transparent = false; ///< pictures alone: nothing is drawn where there is no surface
    bool operator==(const Look &) const = default;
};

/// How bright a pane is and over which ranges, where panes have their own; see Look.
struct Tone {
    double exposure_ev = 0;
    std::optional<Range> range, error_range;
    bool range_chosen = false, error_range_locked = false; ///< else they follow what is shown
    bool operator==(const Tone &) const = default;
};

/// The same, so bright and over these ranges.
Look with_tone(Look look, const Tone &tone);

/// The same, but that difference in place of light or errors.
Look look_at(const Difference &difference, Look look);

/// 0 to the largest reflected radiosity of all snapshots, rounded up to two significant digits, so that panes that are
/// compared can share it; before anything is lit, to the largest exitance; where every surface that reflects also emits,
/// to the sum of both.
Range common_range(std::span<const Snapshot *const> snapshots);

/// Pixels to a "pixel" of line widths and dashes: 1 on an ordinary screen, more on a dense one or in a large picture.
struct PixelScale {
    double factor = 1;
};

} // namespace penumbra
