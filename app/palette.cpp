#include "palette.h"

#include "action.h"
#include "files/recent_files.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace penumbra {

namespace {

std::string lower(std::string_view text) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

constexpr int not_there = 100;

/// How far from the beginning of the title a word is found.
int rank(const std::string &word, const std::string &title, const std::string &rest) {
    if (title.starts_with(word))
        return 0;
    for (std::size_t at = title.find(word); at != std::string::npos; at = title.find(word, at + 1))
        if (std::isalnum(static_cast<unsigned char>(title[at - 1])) == 0)
            return 1;
    if (title.find(word) != std::string::npos)
        return 2;
    return rest.find(word) != std::string::npos ? 3 : not_there;
}

std::vector<PaletteEntry> all_entries(const AppState &state) {
    std::vector<PaletteEntry> all;
    for (const Action &a : actions())
        if (is_offered(a, state))
            all.push_back({std::string(a.title), std::string(a.help), a.keys.empty() ? "" : std::string(a.keys.front()), &a,
                           {}, is_enabled(a, state)});
    for (const std::string &file : that_exist(state.recent_files)) {
        const std::filesystem::path path(file);
        all.push_back({"Open " + path.filename().string(), path.parent_path().string(), {}, nullptr, file});
    }
    for (const std::string &name : state.bundled_scenes)
        all.push_back({"Open " + name, "A bundled scene.", {}, nullptr, name});
    return all;
}

} // namespace

std::vector<PaletteEntry> palette_entries(const AppState &state, std::string_view typed) {
    std::vector<std::string> words;
    std::istringstream in(lower(typed));
    for (std::string word; in >> word;)
        words.push_back(word);
    struct Ranked {
        PaletteEntry entry;
        int rank = 0;
    };
    std::vector<Ranked> found;
    for (PaletteEntry &entry : all_entries(state)) {
        const std::string title = lower(entry.title),
                          rest = lower(entry.help) + (entry.action ? " " + std::string(entry.action->id) : "");
        int sum = 0;
        for (const std::string &word : words)
            sum += rank(word, title, rest);
        if (sum < not_there)
            found.push_back({std::move(entry), sum});
    }
    std::ranges::stable_sort(found, {}, &Ranked::rank);
    std::vector<PaletteEntry> out;
    for (Ranked &f : found)
        out.push_back(std::move(f.entry));
    return out;
}

void choose(AppState &state, const PaletteEntry &entry) {
    state.palette = {};
    if (entry.action)
        choose(*entry.action, state);
    else
        state.open_request = entry.file;
}

} // namespace penumbra
