// The picture of what one point sees of the emitters, and where that point is, on any ImGui draw list.
#pragma once

#include "iteration/snapshot.h"
#include "measure/keyhole.h"
#include "render/camera.h"
#include "render/labels.h"

namespace penumbra {

/// Emitters that have a picture; of the others only the number is told.
inline constexpr std::size_t most_keyhole_pictures = 4;

/// The size of the inset [pixels].
ImVec2 keyhole_inset_size(const Fonts &fonts, const Keyhole &keyhole);
/// With its upper left corner at `corner`: a heading, and for each emitter, the brightest first, its picture with its
/// name, the share that is visible, and the irradiance from it.
void draw_keyhole_inset(ImDrawList &list, const Fonts &fonts, ImVec2 corner, const Keyhole &keyhole,
                        const Snapshot &snapshot, Theme theme);

/// In the rectangle of a pane: a ring about the point, and fine lines to the corners of the visible parts.
void draw_keyhole_point(ImDrawList &list, const Fonts &fonts, ImVec2 low, ImVec2 high, const Camera &camera,
                        const Keyhole &keyhole);

} // namespace penumbra
