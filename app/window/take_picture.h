// Pictures taken in the window, as numbered files in the desktop's Pictures folder.
#pragma once

#include "app_state.h"

namespace penumbra {

/// Of the panes alone, drawn anew at a size fit for a slide; or of the window as it stands in the back buffer, of this
/// size [pixels]. Says in the message which file it became, or why there is none.
void take_picture(AppState &state, PictureRequest request, int width, int height);

} // namespace penumbra
