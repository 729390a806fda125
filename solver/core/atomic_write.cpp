#include "core/atomic_write.h"

#include "core/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <string>
#include <unistd.h>

namespace penumbra {

namespace {

/// Nothing can be renamed onto a device or a pipe: /dev/stdout, a process substitution.
bool takes_bytes_only(const std::filesystem::path &path) {
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    return std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status);
}

void write_straight(const std::filesystem::path &path, std::string_view bytes) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> out(std::fopen(path.c_str(), "wb"), std::fclose);
    if (!out || std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size() || std::fflush(out.get()) != 0)
        throw Unavailable("cannot write " + path.string() + ": " + std::strerror(errno));
}

} // namespace

void write_atomically(const std::filesystem::path &asked, std::string_view bytes) {
    if (takes_bytes_only(asked))
        return write_straight(asked, bytes);
    std::error_code none;
    // A link stays, and what it leads to is replaced.
    const bool is_link = std::filesystem::is_symlink(asked, none) && std::filesystem::exists(asked, none);
    const std::filesystem::path path = is_link ? std::filesystem::canonical(asked) : asked;
    const std::string temporary = path.string() + ".part-" + std::to_string(::getpid());
    const auto fail = [&](const char *verb) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        throw Unavailable("cannot " + std::string(verb) + " " + path.string() + ": " + std::strerror(reason));
    };
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        fail("create");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::write(file, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0) {
            const int reason = errno;
            ::close(file);
            errno = reason;
            fail("write");
        }
        done += static_cast<std::size_t>(n);
    }
    if (::fsync(file) != 0 || ::close(file) != 0)
        fail("write");
    if (::rename(temporary.c_str(), path.c_str()) != 0)
        fail("write");
}

} // namespace penumbra
