#include "files/open_file.h"

#include "core/error.h"
#include "core/read_text.h"
#include "files/png_state.h"
#include "files/read_state.h"
#include "scene/bundled.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>

namespace penumbra {

namespace {

namespace fs = std::filesystem;

bool ends_in(const std::string &name, std::string_view end) {
    return name.size() >= end.size() && std::equal(end.rbegin(), end.rend(), name.rbegin(), [](char a, char b) {
               return a == std::tolower(static_cast<unsigned char>(b));
           });
}

/// Whether a file begins as a picture; asked of regular files only, as others can be read just once.
bool begins_as_png(const std::string &name) {
    std::error_code none;
    char head[8] = {};
    return fs::is_regular_file(name, none) && std::ifstream(name, std::ios::binary).read(head, sizeof head) &&
           is_png({head, sizeof head});
}

std::optional<SavedState> state_of(const std::string &name) {
    std::error_code none;
    if (!fs::exists(name, none))
        return std::nullopt;
    if (ends_in(name, ".png") || begins_as_png(name)) {
        const auto text = state_in_png(name, read_bytes(name, largest_png), largest_state);
        if (!text)
            throw BadInput(name +
                           ": holds no state; open a picture that Penumbra wrote (others may have lost the state on "
                           "their way), or the scene itself");
        return read_state(name, *text);
    }
    if (ends_in(name, ".json"))
        return read_state(name, read_bytes(name, largest_state));
    return std::nullopt;
}

Scene scene_of(const std::string &name, const SavedState &state, const std::optional<Vec3> &asked) {
    const std::optional<Vec3> up = asked || !state.up ? asked : std::optional(up_vector(*state.up));
    std::error_code none;
    const fs::path file = scene_file(state, name);
    const bool has_file = !state.file.empty() && fs::is_regular_file(file, none);
    // The first pictures named the files of bundled scenes, too, which are nowhere.
    if (!has_file && (state.file.empty() || state.file == state.scene + ".obj"))
        if (auto scene = open_bundled_scene(state.scene, up))
            return *std::move(scene);
    if (state.file.empty())
        throw BadInput(name + ": its scene " + in_quotes(state.scene) +
                       " is none of the bundled ones; 'penumbra scenes' lists them");
    if (!has_file)
        throw BadInput(name + ": its scene is not there (" + file.string() +
                       "); put it back, or open the scene itself");
    return open_scene(file.string(), up);
}

} // namespace

std::vector<std::string> OpenedFile::notes() const {
    std::vector<std::string> all = scene->notes;
    if (state)
        all.insert(all.end(), state->notes.begin(), state->notes.end());
    return all;
}

OpenedFile open_file(const std::string &name, const std::optional<Vec3> &up, const std::vector<ObjectMove> &moves) {
    OpenedFile opened;
    opened.state = state_of(name);
    opened.scene = std::make_shared<const Scene>(opened.state ? scene_of(name, *opened.state, up) : open_scene(name, up));
    opened.moves = moves.empty() && opened.state ? opened.state->moves : moves;
    if (const int source = opened.state ? opened.state->look.curve_filter.source : -1; source >= opened.scene->n_surfaces())
        throw BadInput(
            fmt::format("{}: curves.source is {}; the scene has {} surfaces, counted from 0: has it changed?", name,
                        source, opened.scene->n_surfaces()));
    if (!opened.moves.empty()) {
        opened.original = opened.scene;
        opened.scene = std::make_shared<const Scene>(with_moves(*opened.original, opened.moves));
    }
    return opened;
}

} // namespace penumbra
