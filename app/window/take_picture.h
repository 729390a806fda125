// Pictures taken in the window, as numbered files in the desktop's Pictures folder.
#pragma once

#include "app_state.h"

namespace penumbra {

/// Of the panes alone, drawn anew as the settings ask; of the window as it stands in the back buffer, of this size
/// [pixels]; or the command that draws the first, put into the clipboard. Says in the message which file it became, or
/// why there is none.
void take_picture(AppState &state, PictureRequest request, int width, int height);

/// The first of those that wait, if it is ready; the others keep their turn. Returns whether one was taken or given up.
bool take_pending_picture(AppState &state, int width, int height);

} // namespace penumbra
