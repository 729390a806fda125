// What the window's pictures are drawn from, and the state that they carry.
#pragma once

#include "app_state.h"
#include "files/saved_state.h"
#include "render/picture.h"

#include <filesystem>
#include <string>

namespace penumbra {

struct PictureShot {
    PictureSpec spec;
    SavedState saved;
};

/// Of the panes of a window of this size [pixels], for a file in `folder`. What they show must be known.
PictureShot shot_of_panes(const AppState &state, const std::filesystem::path &folder, int width, int height);
/// The same for a pending picture that is ready. Other panes than the window's, or of another shape, keep all that its
/// panes show from side to side.
PictureShot shot_of(const AppState &state, const PendingPicture &picture, const std::filesystem::path &folder, int width,
                    int height);
/// The line that draws it; ranges that render finds by itself are left to it.
std::string command_of(const PictureShot &shot, const Scene &scene);

} // namespace penumbra
