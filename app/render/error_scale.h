// What an error picture shows, and on which scale: the same in shaders/error.frag (tests/golden holds them together).
#pragma once

#include "iteration/snapshot.h"
#include "render/look.h"

#include <glm/glm.hpp>

#include <span>
#include <string>

namespace penumbra {

struct ErrorMap; // iteration/error_map.h

/// The number that the patch as a whole is shown with, where the kind has one: its L2 error as a share of ||B - E||, or
/// that error over what the oracle's test points say of it. Not positive where it is not known, or has no size.
double patch_value(ErrorKind kind, const Snapshot &snapshot, const ErrorMap &map, std::size_t patch);
/// What is shown at a point of a patch where the solution misses that much [W/m2 or a share].
double point_value(ErrorKind kind, const Rgb &missed, double peak);

/// A solution with its map; the map may be null.
struct Judged {
    const Snapshot *snapshot = nullptr;
    const ErrorMap *errors = nullptr;
};
/// One range for solutions that are compared, by what their maps hold: as much below 0 as above it (signed), powers of
/// ten (relative, patch; four decades at most), as many decades below 1 as above it (estimate). A few points in a
/// thousand may lie outside.
Range error_range(ErrorKind kind, std::span<const Judged> judged);

constexpr bool is_logarithmic(ErrorKind kind) { return kind != ErrorKind::signed_error; }
constexpr bool is_diverging(ErrorKind kind) { return kind == ErrorKind::signed_error || kind == ErrorKind::estimate; }
/// 0 at the range's low end, 1 at the high one.
double place(ErrorKind kind, const Range &range, double value);
/// sRGB.
glm::dvec3 error_colour(ErrorKind kind, const Range &range, double value);
/// Above the scale, with the unit.
std::string error_heading(const Look &look);
/// In a sentence, for tooltips and help.
std::string_view error_sentence(ErrorKind kind);

} // namespace penumbra
