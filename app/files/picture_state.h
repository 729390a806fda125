// What a picture was made from, to be carried by its file.
#pragma once

#include "files/saved_state.h"
#include "render/picture.h"

#include <filesystem>

namespace penumbra {

/// For a picture in that folder. Opening it draws the same picture again, but for times, which are measured anew. `own_steps`:
/// panes were sent to steps of their own; else they stand at one, or where a course ends sooner.
SavedState picture_state(const PictureSpec &spec, const Scene &scene, const std::filesystem::path &folder, bool own_steps = false);
/// How it was drawn.
SavedPicture saved_picture(const PictureSpec &spec);

} // namespace penumbra
