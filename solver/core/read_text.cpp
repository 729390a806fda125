#include "core/read_text.h"

#include "core/error.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

namespace penumbra {

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view trimmed(std::string_view s) {
    const std::size_t first = s.find_first_not_of(blanks);
    return first == s.npos ? std::string_view{} : s.substr(first, s.find_last_not_of(blanks) - first + 1);
}

std::string_view without_comment(std::string_view line) {
    for (std::size_t i = line.find('#'); i != line.npos; i = line.find('#', i + 1))
        if (i == 0 || blanks.find(line[i - 1]) != blanks.npos)
            return line.substr(0, i);
    return line;
}

} // namespace

std::string read_bytes(const std::filesystem::path &file, std::size_t limit) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw BadInput(file.string() + ": is a folder; give a file");
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> in(std::fopen(file.c_str(), "rb"), std::fclose);
    if (!in)
        throw BadInput(file.string() + ": cannot be opened: " + std::strerror(errno));
    const auto too_long = [&] {
        throw BadInput(file.string() + ": is longer than the limit of " + std::to_string(limit >> 20) +
                       " MiB; split or simplify it");
    };
    if (std::filesystem::is_regular_file(file, ignored) && std::filesystem::file_size(file, ignored) > limit)
        too_long();
    std::string text;
    char buffer[1 << 16];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, in.get())) {
        if (text.size() + n > limit)
            too_long();
        text.append(buffer, n);
    }
    if (std::ferror(in.get()))
        throw BadInput(file.string() + ": cannot be read: " + std::strerror(errno));
    return text;
}

std::string read_text(const std::filesystem::path &file, std::size_t limit) {
    std::string text = read_bytes(file, limit);
    if (const std::size_t at = text.find('\0'); at != text.npos)
        throw BadInput(file.string() + ": is not a text file (byte " + std::to_string(at) +
                       " is zero); give an uncompressed text file");
    return text;
}

void for_each_line(std::string_view text, const std::function<void(const TextLine &)> &take) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    TextLine pending; // may be continued; number 0: none
    bool joined = false;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        std::string_view line = trimmed(without_comment(text.substr(0, end)));
        text.remove_prefix(end);
        if (text.starts_with("\r\n"))
            text.remove_prefix(2);
        else if (!text.empty())
            text.remove_prefix(1);
        const bool goes_on = line.ends_with('\\');
        if (goes_on)
            line = trimmed(line.substr(0, line.size() - 1));
        if (joined)
            pending.text.append(" ").append(line);
        else if (!line.empty())
            pending = {number, std::string(line)};
        joined = goes_on && (joined || !line.empty());
        if (!joined && pending.number > 0) {
            take(pending);
            pending.number = 0;
        }
    }
    if (pending.number > 0)
        take(pending);
}

std::vector<TextLine> lines_of(std::string_view text) {
    std::vector<TextLine> lines;
    for_each_line(text, [&](const TextLine &line) { lines.push_back(line); });
    return lines;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != line.npos; at = line.find_first_not_of(blanks, at)) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string out = "'";
    for (const char c : text.substr(0, longest))
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return out + (text.size() > longest ? "...'" : "'");
}

bool number_from(std::string_view word, double &value) {
    if (word.starts_with('+') && !word.starts_with("+-"))
        word.remove_prefix(1);
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size())
        return false;
    if (status == std::errc::result_out_of_range) {
        // from_chars leaves the value alone both above and below the range: the exponent's sign tells which.
        const std::size_t e = word.find_first_of("eE");
        const bool tiny = e != word.npos ? word.substr(e + 1).starts_with('-') : word.find('.') < 3;
        value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
        return true;
    }
    return status == std::errc{};
}

} // namespace penumbra
