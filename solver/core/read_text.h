// Text files, whole and bounded.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// The file's bytes. Throws BadInput: not there, a folder, unreadable, longer than `limit` bytes, or with NUL bytes in
/// it (then it is no text).
std::string read_text(const std::filesystem::path &file, std::size_t limit);

/// A logical line: without its end, comment and outer blanks; lines that end in a backslash are joined.
struct TextLine {
    int number = 0; ///< of its first physical line, from 1
    std::string text;
};

/// Lines that hold something, whatever ends them (LF, CR LF, CR); a byte order mark is skipped. A comment starts at a
/// `#` that opens a line or follows a blank.
std::vector<TextLine> lines_of(std::string_view text);

/// Words between blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// For messages: in quotes, one line, at most 40 characters, control characters as `?`.
std::string in_quotes(std::string_view text);

/// The whole of `word` as a number, correctly rounded; false when it is none (a finite one or not: `inf`, `nan` and what
/// overflows come back as infinities or nan).
bool number_from(std::string_view word, double &value);

} // namespace penumbra
