// Radiosity along a line, as a figure: the truth and the solutions over each other, below them where their elements
// end, and their slopes.
#pragma once

#include "core/options.h"
#include "iteration/profile.h"
#include "plot/axes.h"
#include "plot/canvas.h"

#include <optional>
#include <string>
#include <vector>

namespace penumbra {

/// One solution along the line.
struct ProfileCurve {
    Strategy strategy{};
    int order = 4;
    std::vector<ProfilePiece> pieces;
    bool reconstructed = false; ///< constants, drawn as quadratics
};

/// Where a discontinuity curve crosses it.
struct ProfileCrossing {
    double at = 0;           ///< place on the line
    int kind = 0, order = 2; ///< as CurveKind
};

struct ProfileData {
    std::string scene, surface;      ///< names
    double length = 0;               ///< of the line
    std::vector<ProfilePoint> exact; ///< empty: not known yet
    double truth_error = 0;          ///< of `exact`, relative; 0: exact
    std::vector<ProfileCurve> curves;
    std::vector<ProfileCrossing> crossings;
};

/// Mean of the channels.
double channel_mean(const Rgb &value);
/// What a solution has at a place; on a border what lies before it. Nothing where it has no piece.
std::optional<ProfilePoint> point_at(const ProfileCurve &curve, double at);
/// The truth there, straight between its points.
std::optional<ProfilePoint> point_at(const std::vector<ProfilePoint> &points, double at);

/// Where the two plots lie.
struct ProfilePlaces {
    PlotBox values, slopes; ///< between the axes
    double length = 0;

    /// The place on the line below a point of the page; none beside the plots.
    std::optional<double> place(glm::vec2 at) const;
};

/// Fills `box`. With a cursor a rule stands at that place of the line, and the figures there beside it.
ProfilePlaces draw_profile(Canvas &canvas, const PlotBox &box, const ProfileData &data, const PlotLook &look,
                           std::optional<double> cursor = std::nullopt);

/// The same as a whole figure with a heading, and a note that says what was drawn and how slopes were taken.
void draw_profile_figure(Canvas &canvas, glm::vec2 size, const ProfileData &data, const PlotLook &look);

} // namespace penumbra
