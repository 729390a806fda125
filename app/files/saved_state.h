// What is kept of a view, to see the same again: in a file NAME.penumbra.json, and in every picture.
#pragma once

#include "core/options.h"
#include "layout.h"
#include "render/camera.h"
#include "render/look.h"
#include "scene/move_object.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

/// Grows when fields change their meaning; new ones alone do not change it.
inline constexpr int state_format = 1;

/// What a picture of the panes was drawn with, beside what the window has.
struct SavedPicture {
    int width = 1280, height = 960; ///< pixels
    bool lettered = false;          ///< panes are tagged (a) to (d)
    bool priced = false;            ///< with the sentence on what two panes took
    bool labels = true;             ///< over the panes
    int supersample = 1;            ///< drawn so many times larger and averaged
    bool operator==(const SavedPicture &) const = default;
};

struct SavedState {
    std::string scene = {};      ///< name of a bundled scene, or the file's stem
    std::string file = {};       ///< relative to the state's folder, or absolute; empty: a bundled scene
    std::optional<char> up = {}; ///< the scene's up axis: x, y, z; none: the format's own
    std::vector<ObjectMove> moves = {}; ///< of objects, from where the file has them
    Options options = {};        ///< the strategy is the active pane's; threads are not kept
    std::vector<Strategy> strategies = {Strategy::discontinuity_wavelet}; ///< of the panes, row by row
    std::optional<Layout> layout = {}; ///< of two strategies in one place; none: all side by side
    double wipe = 0.5;                 ///< divider of layout wipe, from the left, 0 to 1
    std::vector<bool> reconstructed = {}; ///< by pane: constants are drawn as quadratics; empty: none is
    int active = 0;                                                       ///< pane
    int position = 0;                                                     ///< see timeline.h
    std::vector<int> positions = {}; ///< by pane, where they are not linked; empty: all stand at the one
    std::optional<int> split = {}; ///< splits of the refinement there that are shown; none: all
    std::optional<int> linking = {}; ///< pairs that it linked, of which so many are shown after all splits; none: all
    bool converged = false;                                               ///< every pane stands at its fixed point
    std::optional<Camera> camera = {};                                    ///< none: the scene's first view
    std::vector<Camera> cameras = {}; ///< by pane, where they are not linked; empty: all have the one
    std::vector<Tone> tones = {};     ///< by pane, where they are not linked; empty: all are as the look has it
    Look look = {};
    bool range_chosen = false; ///< look.range was asked for; else it is what the values shown came to
    bool error_range_locked = false; ///< look.error_range stays whatever is shown; else it follows the values
    bool legend = true;
    std::optional<Vec3> keyhole = {};         ///< scene's own frame
    std::optional<std::pair<Vec3, Vec3>> profile = {}; ///< ends of its line, scene's own frame
    std::optional<SavedPicture> picture = {}; ///< none: no picture of the panes
    std::string caption = {};                 ///< below the panes; empty: none
    std::vector<SavedState> bookmarks = {};   ///< without bookmarks of their own; the lecture that goes with a state
    std::vector<std::string> notes = {};      ///< what was to be said while reading, a line each; not written
};

/// How a state in `folder` names the file of the scene: relative to it where both lie below one folder other than `/`,
/// else absolute; empty for a bundled scene.
std::string place_of(const Scene &scene, const std::filesystem::path &folder);
/// The reverse, for a state that was read from `state_file`.
std::filesystem::path scene_file(const SavedState &state, const std::filesystem::path &state_file);
/// As SavedState::up has it.
char up_axis(const Scene &scene);
Vec3 up_vector(char axis);

} // namespace penumbra
