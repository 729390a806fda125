#include "files/recent_files.h"

#include "core/error.h"
#include "core/read_text.h"
#include "files/kept_file.h"
#include "files/own_folders.h"
#include "scene/json_value.h"

#include <algorithm>

namespace penumbra {

namespace {

namespace fs = std::filesystem;

constexpr JsonLimits limits{.bytes = std::size_t{1} << 18, .depth = 4, .values = 1000};

bool is_file(const std::string &name) {
    std::error_code none;
    return fs::is_regular_file(name, none);
}

} // namespace

fs::path recent_files_file() { return state_folder() / "recent.json"; }

RecentFiles read_recent_files(const std::string &file, std::string_view text) {
    const nlohmann::json json = parse_json(file, text, limits);
    const JsonValue list = JsonValue(json, file)["files"];
    RecentFiles files;
    for (std::size_t i = 0; i < list.size() && files.size() < most_recent_files; ++i) {
        const std::string path = list.at(i).text();
        if (fs::path(path).is_absolute() && std::ranges::find(files, path) == files.end())
            files.push_back(path);
    }
    return files;
}

RecentFiles read_recent_files() {
    const fs::path file = recent_files_file();
    try {
        return is_file(file.string()) ? read_recent_files(file.string(), read_bytes(file, limits.bytes)) : RecentFiles{};
    } catch (const BadInput &) {
        return {};
    }
}

std::string recent_files_text(const RecentFiles &files) {
    return nlohmann::json{{"files", files}}.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

RecentFiles with_latest(RecentFiles files, const std::string &file) {
    std::erase(files, file);
    files.insert(files.begin(), file);
    files.resize(std::min(files.size(), most_recent_files));
    return files;
}

RecentFiles that_exist(const RecentFiles &files) {
    RecentFiles there;
    std::ranges::copy_if(files, std::back_inserter(there), is_file);
    return there;
}

RecentFiles note_recent_file(const std::string &name) {
    RecentFiles files = read_recent_files();
    if (!is_file(name))
        return files;
    std::error_code failure;
    const fs::path path = fs::absolute(name, failure);
    if (failure)
        return files;
    files = with_latest(std::move(files), path.lexically_normal().string());
    write_kept_file(recent_files_file(), recent_files_text(files));
    return files;
}

} // namespace penumbra
