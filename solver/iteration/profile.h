// Radiosity along a straight line over one surface: the solution's, piece by piece, and the true one.
#pragma once

#include "core/cancel.h"
#include "iteration/truth.h"

#include <optional>
#include <span>
#include <vector>

namespace penumbra {

/// From one point of a surface to another (scene's own frame). Places along it are counted from `from` [length].
struct ProfileLine {
    int surface = 0; ///< of snapshot.surfaces
    Vec3 from, to;

    double length() const { return (to - from).norm(); }
    Vec3 at(double place) const { return from + place / length() * (to - from); }
};

/// The line between two points where one reflecting surface holds both to within `slack` [length], the one whose plane
/// is nearest; none where there is no such surface, or no way between them.
std::optional<ProfileLine> line_over(const Snapshot &snapshot, const Vec3 &from, const Vec3 &to, double slack);

/// Points that a plot of ordinary width needs.
inline constexpr int n_profile_points = 500;

struct ProfilePoint {
    double at = 0; ///< place on the line
    Rgb radiosity; ///< [W/m2]
    Rgb slope;     ///< along the line [W/m2 per length]
};

/// What one patch has of the line: its polynomial from border to border, both included.
struct ProfilePiece {
    int patch = 0; ///< of snapshot.patches
    double low = 0, high = 0;
    std::vector<ProfilePoint> points;
};

/// In the order of the line; under covers the line is dark and there may be no piece. Each piece has points no farther
/// apart than the line's length / n. Slopes are the polynomials' own.
std::vector<ProfilePiece> profile(const Snapshot &snapshot, const ProfileLine &line, int n);

/// The truth at n + 1 places and just before and after each of `breaks`, in order. Slopes are differences
/// (B(s + h) - B(s - h)) / 2h, one-sided within h of the line's ends, with h = difference_step() of the length. On all
/// threads. Throws Cancelled.
std::vector<ProfilePoint> true_profile(const Truth &truth, const SnapshotSurface &surface, const ProfileLine &line,
                                       int n, std::span<const double> breaks, const Cancel *cancel = nullptr);
constexpr double difference_step() { return 1e-3; }

} // namespace penumbra
