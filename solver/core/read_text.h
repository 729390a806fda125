// Files, whole and bounded.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// The file's bytes. Throws BadInput: not there, a folder, unreadable, or longer than `limit` bytes.
std::string read_bytes(const std::filesystem::path &file, std::size_t limit);

/// The same of a text file: BadInput also for NUL bytes in it.
std::string read_text(const std::filesystem::path &file, std::size_t limit);

/// A logical line: without its end, comment and outer blanks; lines that end in a backslash are joined.
struct TextLine {
    int number = 0; ///< of its first physical line, from 1
    std::string text;
};

/// Calls `take` with each line that holds something, whatever ends it (LF, CR LF, CR); a byte order mark is skipped. A
/// comment starts at a `#` that opens a line or follows a blank.
void for_each_line(std::string_view text, const std::function<void(const TextLine &)> &take);

/// All of them.
std::vector<TextLine> lines_of(std::string_view text);

/// Words between blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// For messages: in quotes, one line, at most 40 characters, control characters as `?`.
std::string in_quotes(std::string_view text);

/// The whole of `word` as a number, correctly rounded; false when it is none (a finite one or not: `inf`, `nan` and
/// what overflows come back as infinities or nan).
bool number_from(std::string_view word, double &value);

} // namespace penumbra
