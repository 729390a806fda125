// What a user has chosen for good, in $XDG_CONFIG_HOME/penumbra/settings.json. Checked by tests/unit/settings_test.cpp.
#pragma once

#include "render/look.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

inline constexpr double smallest_ui_scale = 0.5, largest_ui_scale = 4;
inline constexpr double slowest_play = 0.25, fastest_play = 60; ///< [steps/s]

struct Settings {
    double ui_scale = 1;          ///< of the whole interface
    Theme theme = Theme::dark;    ///< of whatever has none of its own
    double phases_per_second = 2; ///< of playing
    bool tour_seen = false;       ///< the tour was shown at the first start
    bool operator==(const Settings &) const = default;
};

std::filesystem::path settings_file();

/// Readable JSON. What is missing has its default, and so has a value of the wrong kind or out of range and a text that is no
/// JSON, each with a line in `notes` that begins with `file`; names that are not known are passed over. Never throws.
Settings read_settings(const std::string &file, std::string_view text, std::vector<std::string> &notes);
/// The same of settings_file(); no file is no note.
Settings read_settings(std::vector<std::string> &notes);

std::string settings_text(const Settings &settings);
/// Atomically, into a folder that is made where it is missing. Throws Unavailable.
void write_settings(const Settings &settings);

} // namespace penumbra
