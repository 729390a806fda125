#include "files/autosave.h"

#include "core/read_text.h"
#include "files/own_folders.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace penumbra {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view before = "autosave-", after = ".penumbra.json";

fs::path file_of(pid_t process) {
    return state_folder() / (std::string(before) + std::to_string(process) + std::string(after));
}

std::optional<pid_t> process_of(const std::string &name) {
    if (!name.starts_with(before) || !name.ends_with(after) || name.size() <= before.size() + after.size())
        return std::nullopt;
    const std::string number = name.substr(before.size(), name.size() - before.size() - after.size());
    const bool digits = std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
    return digits && number.size() < 10 ? std::optional<pid_t>(std::atoi(number.c_str())) : std::nullopt;
}

bool exists(pid_t process) { return process > 0 && (::kill(process, 0) == 0 || errno == EPERM); }

} // namespace

fs::path autosave_file() { return file_of(::getpid()); }

std::vector<fs::path> orphaned_autosaves() {
    std::error_code none;
    if (fs::exists(autosave_file(), none))
        fs::rename(autosave_file(), file_of(0), none);
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    for (fs::directory_iterator i(state_folder(), none), end; !none && i != end; i.increment(none))
        if (const auto process = process_of(i->path().filename().string()); process && !exists(*process)) {
            std::error_code gone;
            if (const auto time = i->last_write_time(gone); !gone)
                found.emplace_back(time, i->path());
        }
    std::ranges::sort(found, std::greater{});
    std::vector<fs::path> files;
    for (auto &[time, file] : found)
        files.push_back(std::move(file));
    return files;
}

} // namespace penumbra
