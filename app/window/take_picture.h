// Pictures taken in the window, as numbered files in the desktop's Pictures folder.
#pragma once

#include "app_state.h"
#include "window/picture_shot.h"

#include <filesystem>
#include <optional>

namespace penumbra {

/// Takes pictures one after another; large ones a tile at a time, so that the window goes on.
class Photographer {
public:
    /// Of the panes alone, drawn anew as the settings ask; of the window as it stands in the back buffer, of this size
    /// [pixels]; or the command that draws the first, put into the clipboard. Says in the message which file it became, or
    /// why there is none.
    void take(AppState &state, PictureRequest request, int width, int height);

    /// Draws more of the picture in hand, or begins the first of those that wait, if it is ready; the others keep their turn.
    /// Returns whether there was something to do.
    bool go_on(AppState &state, int width, int height);

private:
    struct InHand {
        InHand(PictureShot shot, std::filesystem::path file, bool waited);
        PictureDrawing drawing;
        std::filesystem::path file;
        SavedState saved;
        bool waited; ///< it is the first of those that wait
    };

    void draw(AppState &state);

    std::optional<InHand> in_hand_;
};

} // namespace penumbra
