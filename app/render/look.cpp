#include "render/look.h"

#include "render/surface_role.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

std::string_view name(Shading shading) {
    switch (shading) {
    case Shading::polynomial:
        return "polynomial";
    case Shading::flat:
        return "flat";
    case Shading::linear:
        return "linear";
    case Shading::error:
        return "error";
    }
    return "";
}

std::optional<Shading> shading_from_name(std::string_view text) {
    for (const Shading shading : {Shading::polynomial, Shading::flat, Shading::linear, Shading::error})
        if (name(shading) == text)
            return shading;
    return std::nullopt;
}

std::string_view name(ErrorKind kind) {
    constexpr std::string_view names[] = {"signed", "relative", "patch", "estimate"};
    return names[static_cast<std::size_t>(kind)];
}

std::optional<ErrorKind> error_kind_from_name(std::string_view text) {
    for (const ErrorKind kind : all_error_kinds)
        if (name(kind) == text)
            return kind;
    return std::nullopt;
}

glm::vec4 background_colour(Theme theme) {
    return theme == Theme::dark ? glm::vec4(0.105, 0.115, 0.13, 1) : glm::vec4(1, 1, 1, 1);
}

Look with_tone(Look look, const Tone &tone) {
    look.exposure_ev = tone.exposure_ev;
    look.range = tone.range;
    look.error_range = tone.error_range;
    return look;
}

Look look_at(const Difference &difference, Look look) {
    look.shading = Shading::error;
    look.error = ErrorKind::signed_error;
    look.change.reset();
    look.difference = difference;
    return look;
}

Range common_range(std::span<const Snapshot *const> snapshots) {
    double peak = 0, exitance = 0;
    bool reflector = false;
    for (const Snapshot *snapshot : snapshots) {
        peak = std::max(peak, snapshot->peak);
        for (const SnapshotSurface &s : snapshot->surfaces) {
            exitance = std::max(exitance, s.exitance.maxCoeff());
            reflector |= role(s) == SurfaceRole::reflector;
        }
    }
    if (!(peak > 0))
        peak = exitance > 0 ? exitance : 1;
    else if (!reflector) // a furnace: all that there is to see glows as well
        peak += exitance;
    const double unit = std::pow(10.0, std::floor(std::log10(peak)) - 1);
    return {0, std::ceil(peak / unit - 1e-9) * unit};
}

} // namespace penumbra
