#include "files/saved_state.h"

namespace penumbra {

namespace {

namespace fs = std::filesystem;

/// Without links and dots, as far as the path is there.
fs::path resolved(const fs::path &path) {
    std::error_code failure;
    const fs::path found = fs::weakly_canonical(path.empty() ? "." : path, failure);
    return failure || found.is_relative() ? fs::absolute(path, failure).lexically_normal() : found;
}

} // namespace

std::string place_of(const Scene &scene, const fs::path &folder) {
    if (scene.file.empty())
        return "";
    const fs::path file = resolved(scene.file), base = resolved(folder);
    const auto first_name = [](const fs::path &path) { return *path.relative_path().begin(); };
    if (file.relative_path().empty() || base.relative_path().empty() || first_name(file) != first_name(base))
        return file.generic_string();
    return file.lexically_relative(base).generic_string();
}

fs::path scene_file(const SavedState &state, const fs::path &state_file) {
    return (state_file.parent_path() / state.file).lexically_normal();
}

char up_axis(const Scene &scene) { return scene.up.x() > 0.5 ? 'x' : scene.up.y() > 0.5 ? 'y' : 'z'; }

Vec3 up_vector(char axis) { return axis == 'x' ? Vec3::UnitX() : axis == 'y' ? Vec3::UnitY() : Vec3::UnitZ(); }

} // namespace penumbra
