#include "scene/skipped.h"

#include "core/read_text.h"

namespace penumbra {

void Skipped::add(std::string_view keyword, int n) {
    keyword = keyword.substr(0, 64); // more than is shown
    if (const auto found = counts_.find(keyword); found != counts_.end())
        found->second += n;
    else if (counts_.size() < most_kinds)
        counts_.emplace(keyword, n);
    else
        has_others_ = true;
}

void Skipped::append_to(std::vector<std::string> &notes, const std::string &file) const {
    if (counts_.empty())
        return;
    std::string note = file + ": skipped, as they mean nothing here:";
    constexpr std::size_t most = 20;
    std::size_t n = 0;
    for (auto it = counts_.begin(); it != counts_.end() && n < most; ++it, ++n)
        note += (n ? ", " : " ") + in_quotes(it->first) + " " + std::to_string(it->second) + "x";
    notes.push_back(note + (counts_.size() > most || has_others_ ? " and other keywords" : ""));
}

} // namespace penumbra
