// Views that are come back to: a lecture's course, with a caption each.
#pragma once

#include "app_state.h"

namespace penumbra {

/// Keeps what is shown, after the one that was gone to last; its caption is the present one, or says what is shown.
void add_bookmark(AppState &state);
/// Shows it again; another scene is opened first. Nothing happens where there is none of that number.
void go_to_bookmark(AppState &state, int number);
void remove_bookmark(AppState &state, int number);
/// The camera as text, "ex ey ez tx ty tz fov", as the option --view has it.
std::string view_text(const Camera &camera);
/// The reverse; what is none is told.
void use_view_text(AppState &state, const std::string &text);

} // namespace penumbra
