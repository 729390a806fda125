#include "commands/terminal.h"

#include "core/atomic_write.h"
#include "core/error.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace penumbra {

namespace {

bool in_colour() {
    const char *no = std::getenv("NO_COLOR");
    return error_is_terminal() && !(no && *no);
}

bool is_standard_output(const std::string &file) { return file.empty() || file == "-"; }

} // namespace

bool error_is_terminal() { return ::isatty(STDERR_FILENO) == 1; }

void complain(const std::string &what) {
    std::fprintf(stderr, in_colour() ? "\033[1;31mpenumbra:\033[0m %s\n" : "penumbra: %s\n", what.c_str());
}

void say_notes(const std::vector<std::string> &notes) {
    for (const std::string &note : notes)
        std::fprintf(stderr, "note: %s\n", note.c_str());
}

void deliver(const std::string &file, std::string_view bytes) {
    if (!is_standard_output(file))
        return write_atomically(file, bytes);
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
        throw Unavailable(std::string("cannot write to standard output: ") + std::strerror(errno));
}

void check_deliverable(const std::string &file) {
    std::error_code none;
    const bool is_file = !std::filesystem::exists(file, none) || std::filesystem::is_regular_file(file, none);
    if (is_standard_output(file))
        return;
    if (std::filesystem::is_directory(file, none))
        throw Unavailable("cannot write " + file + ": it is a folder");
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (std::filesystem::exists(folder, none) && !std::filesystem::is_directory(folder, none))
        throw Unavailable("cannot write " + file + ": " + folder.string() + " is no folder");
    if (is_file && ::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
        throw Unavailable("cannot write " + file + ": " + std::strerror(errno));
}

} // namespace penumbra
