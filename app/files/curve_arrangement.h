// The regions into which curves divide a surface, as data.
#pragma once

#include "discontinuity/arrangement.h"
#include "iteration/snapshot.h"

#include <string>
#include <utility>
#include <vector>

namespace penumbra {

/// Curves of one receiver and their arrangement, in its plane [the scene's own length unit].
struct ReceiverCurves {
    std::int32_t receiver = 0;
    std::vector<std::size_t> curves; ///< indices into the snapshot's curves; the arrangement's lines, in order
    std::vector<std::vector<Vec2>> lines;
    Arrangement arrangement;
};

/// Of every surface that receives curves.
std::vector<ReceiverCurves> arrange_receivers(const Snapshot &snapshot);

/// File name and JSON text: `scene`, `receiver`, `name`; `vertices`: [x, y, z] in the scene's own frame; `edges`:
/// `from` and `to` (vertices), `left` and `right` (faces; -1 outside), `border`, `curves` (numbers as in the curves'
/// CSV); `faces`: `area`, `outline` (vertices, counter-clockwise seen from the front) and `holes`.
std::pair<std::string, std::string> arrangement_json(const Snapshot &snapshot, const ReceiverCurves &curves);

} // namespace penumbra
