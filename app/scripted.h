// All that the lines of a script can set: what a record of a session tells from one moment to the next.
#pragma once

#include "app_state.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

/// A surface and a point of it that was picked for an inspector.
using Picked = std::optional<SurfacePoint>;

struct Scripted {
    Parameters set; ///< its camera only while it is the user's
    Place place;
    bool playing = false;
    double speed = 0;
    std::string caption;
    Inspector inspector{};
    Picked element, split;        ///< of the inspector, and of the microscope
    int outward = 0, piece = 0;   ///< of the microscope
    std::optional<int> source;    ///< whose links are X-rayed
    XrayLine xray{};
    int object = -1;              ///< in hand
    CostMeasure cost{};
    std::optional<glm::dvec3> pivot;
    PictureSettings pictures;
    bool picture_settings = false, help = false, panels_hidden = false, animates_splits = true;
    std::vector<std::string> bookmarks; ///< their captions
    int bookmark = -1;
};

Scripted scripted(const AppState &state);

/// In `known`, what stood as in `before` becomes as in `after`: changes that nobody has made by hand. Not whether it plays,
/// from which it is known how a place was reached.
void follow(Scripted &known, const Scripted &before, const Scripted &after);

} // namespace penumbra
