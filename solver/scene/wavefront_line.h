// The lines of OBJ and MTL files.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// A logical line in words, the keyword first; there is one.
struct WavefrontLine {
    const std::string &file; ///< as messages call it
    int number = 0;          ///< from 1
    const std::string &text;
    std::vector<std::string_view> words;

    /// All that stands behind the keyword: names may hold blanks. Throws BadInput beyond `longest_name`.
    std::string name() const;
    /// Throws BadInput, "file.obj:12: what".
    [[noreturn]] void fail(const std::string &what) const;
};

/// Longest logical line [bytes]: a face of `most_corners` takes a quarter of it.
inline constexpr std::size_t longest_line = std::size_t{1} << 20;

/// Calls `take` with each line that holds a keyword. Throws BadInput for a line longer than `longest_line`.
void for_each_wavefront_line(const std::string &file, std::string_view text,
                             const std::function<void(const WavefrontLine &)> &take);

} // namespace penumbra
