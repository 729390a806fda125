// The box that says what happens at a curve, on any ImGui draw list.
#pragma once

#include "render/event_words.h"
#include "render/labels.h"

namespace penumbra {

/// With its lower left corner at `corner`, at most `width` wide; lines break between words. Measured alone when `list`
/// is null. Returns its size [pixels].
ImVec2 draw_event_note(ImDrawList *list, const Fonts &fonts, ImVec2 corner, float width, const EventWords &words,
                       ImVec4 colour, Theme theme);

} // namespace penumbra
