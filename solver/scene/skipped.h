// What a file holds that means nothing here: counted, and said once.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// How often each keyword stood in a file. A file that is no scene at all has endless ones: those beyond `most_kinds`
/// count as one.
class Skipped {
public:
    static constexpr std::size_t most_kinds = 1000;

    void add(std::string_view keyword, int n = 1);
    /// One note, if anything was skipped: the first 20 keywords in alphabetical order.
    void append_to(std::vector<std::string> &notes, const std::string &file) const;

private:
    std::map<std::string, int, std::less<>> counts_;
    bool has_others_ = false;
};

} // namespace penumbra
