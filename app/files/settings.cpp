#include "files/settings.h"

#include "core/error.h"
#include "core/read_text.h"
#include "files/kept_file.h"
#include "files/own_folders.h"
#include "scene/json_value.h"

#include <fmt/format.h>

namespace penumbra {

namespace {

constexpr JsonLimits limits{.bytes = std::size_t{1} << 16, .depth = 8, .values = 1000};

void read_number(const JsonValue &value, double low, double high, double &number) {
    const double x = value.number();
    if (!(x >= low && x <= high))
        value.fail(fmt::format("is {:g}; it can be {:g} to {:g}", x, low, high));
    number = x;
}

void read_theme(const JsonValue &value, Theme &theme) {
    const std::string text = value.text();
    if (text != "dark" && text != "light")
        value.fail("is " + in_quotes(text) + "; it can be dark or light");
    theme = text == "dark" ? Theme::dark : Theme::light;
}

} // namespace

std::filesystem::path settings_file() { return config_folder() / "settings.json"; }

Settings read_settings(const std::string &file, std::string_view text, std::vector<std::string> &notes) {
    Settings settings;
    const auto passing_over = [&](const auto &read) {
        try {
            read();
        } catch (const BadInput &e) {
            notes.push_back(std::string(e.what()) + "; passed over");
        }
    };
    passing_over([&] {
        const nlohmann::json json = parse_json(file, text, limits);
        const JsonValue root(json, file);
        const auto field = [&](const char *name, const auto &read) {
            passing_over([&] {
                if (const auto value = root.known(name))
                    read(*value);
            });
        };
        if (!json.is_object())
            root.fail("is no object");
        field("ui_scale", [&](const JsonValue &v) { read_number(v, smallest_ui_scale, largest_ui_scale, settings.ui_scale); });
        field("theme", [&](const JsonValue &v) { read_theme(v, settings.theme); });
        field("phases_per_second",
              [&](const JsonValue &v) { read_number(v, slowest_play, fastest_play, settings.phases_per_second); });
        field("tour_seen", [&](const JsonValue &v) { settings.tour_seen = v.boolean(); });
    });
    return settings;
}

Settings read_settings(std::vector<std::string> &notes) {
    const std::filesystem::path file = settings_file();
    std::error_code none;
    if (!std::filesystem::exists(file, none))
        return {};
    try {
        return read_settings(file.string(), read_bytes(file, limits.bytes), notes);
    } catch (const BadInput &e) {
        notes.push_back(std::string(e.what()) + "; passed over");
        return {};
    }
}

std::string settings_text(const Settings &s) {
    const nlohmann::ordered_json json{{"ui_scale", s.ui_scale},
                                      {"theme", s.theme == Theme::dark ? "dark" : "light"},
                                      {"phases_per_second", s.phases_per_second},
                                      {"tour_seen", s.tour_seen}};
    return json.dump(1) + "\n";
}

void write_settings(const Settings &settings) { write_kept_file(settings_file(), settings_text(settings)); }

} // namespace penumbra
