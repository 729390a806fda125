#include "window/save_state.h"

#include "capture.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "files/pictures_folder.h"
#include "files/own_folders.h"
#include "files/state_text.h"
#include "files/write_state.h"

#include <exception>

namespace penumbra {

namespace {

void write(const AppState &state, const std::filesystem::path &file) {
    write_atomically(file, state_text(saved_state(state, file.parent_path())));
}

} // namespace

void save_state(AppState &state) {
    try {
        const auto file = numbered_name(pictures_folder(), "penumbra", ".penumbra.json");
        write(state, file);
        state.last_state = file.string();
        state.message = {"Saved " + file.string(), false};
    } catch (const std::exception &e) {
        state.message = {e.what(), true};
    }
}

std::filesystem::path rescue_state(const AppState &state) {
    const auto file = state_folder() / "rescued.penumbra.json";
    std::error_code failure;
    std::filesystem::create_directories(file.parent_path(), failure);
    if (failure)
        throw Unavailable("cannot make the folder " + file.parent_path().string() + ": " + failure.message());
    write(state, file);
    return file;
}

} // namespace penumbra
