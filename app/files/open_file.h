// What the viewer and `render` open: a scene, a saved state, or a picture that Penumbra wrote.
#pragma once

#include "files/saved_state.h"
#include "scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct OpenedFile {
    std::shared_ptr<const Scene> scene;
    std::optional<SavedState> state; ///< none: a scene was opened
    std::vector<ObjectMove> moves = {};              ///< of objects, that led to the scene
    std::shared_ptr<const Scene> original = nullptr; ///< before them; null: nothing is moved

    /// What there is to say, a line each.
    std::vector<std::string> notes() const;
};

/// Opens the file of that name, else the bundled scene. A state is told by its name's end, .json; a picture by that,
/// .png, or by its first bytes; all else is a scene. `up` takes the place of the scene's, or the state's, own. Throws
/// BadInput, one line: what the readers refuse, a picture without a state, a state whose scene is not there, or has no
/// surface of a number that the state or a move names. `moves` take the place of the state's.
OpenedFile open_file(const std::string &name, const std::optional<Vec3> &up = std::nullopt,
                     const std::vector<ObjectMove> &moves = {});

} // namespace penumbra
