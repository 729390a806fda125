#include "core/read_text.h"

#include "core/error.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <memory>
#include <sys/stat.h>

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

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

/// From where the file stands to its end.
std::string read_rest(std::FILE *in, const std::filesystem::path &file, std::size_t limit) {
    std::string text;
    char buffer[1 << 16];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, in)) {
        if (text.size() + n > limit)
            throw BadInput(file.string() + ": is longer than the limit of " + std::to_string(limit >> 20) +
                           " MiB; split or simplify it");
        text.append(buffer, n);
    }
    if (std::ferror(in))
        throw BadInput(file.string() + ": cannot be read: " + std::strerror(errno));
    return text;
}

/// Whether it may have been written to since `before`, while `text` was read. Times of writing have the resolution of
/// the system's clock tick: a file as young as that is read again.
bool has_changed(std::FILE *in, const struct stat &before, const std::string &text, const std::filesystem::path &file,
                 std::size_t limit) {
    struct stat now {};
    if (::fstat(::fileno(in), &now) != 0 || now.st_size != before.st_size ||
        now.st_mtim.tv_sec != before.st_mtim.tv_sec || now.st_mtim.tv_nsec != before.st_mtim.tv_nsec)
        return true;
    if (now.st_size > 0 && static_cast<std::size_t>(now.st_size) != text.size()) // those of /proc have size 0
        return true;
    timespec clock{};
    ::clock_gettime(CLOCK_REALTIME, &clock);
    if (std::llabs(static_cast<long long>(clock.tv_sec) - now.st_mtim.tv_sec) > 1)
        return false;
    std::rewind(in);
    return read_rest(in, file, limit) != text;
}

} // namespace

std::string read_bytes(const std::filesystem::path &file, std::size_t limit) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw BadInput(file.string() + ": is a folder; give a file");
    errno = 0;
    const File in(std::fopen(file.c_str(), "rb"), std::fclose);
    if (!in)
        throw BadInput(file.string() + ": cannot be opened: " + std::strerror(errno));
    struct stat before {};
    const bool is_regular = ::fstat(::fileno(in.get()), &before) == 0 && S_ISREG(before.st_mode);
    if (is_regular && static_cast<std::size_t>(before.st_size) > limit)
        throw BadInput(file.string() + ": is longer than the limit of " + std::to_string(limit >> 20) +
                       " MiB; split or simplify it");
    std::string text = read_rest(in.get(), file, limit);
    if (is_regular && has_changed(in.get(), before, text, file, limit))
        throw BadInput(file.string() + ": was written to while it was read; open it again when that is over");
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
