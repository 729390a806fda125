#include "core/atomic_write.h"

#include "core/error.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace penumbra {

void write_atomically(const std::filesystem::path &path, std::string_view bytes) {
    const std::string temporary = path.string() + ".part-" + std::to_string(::getpid());
    const auto fail = [&](const char *verb) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        throw Unavailable("cannot " + std::string(verb) + " " + path.string() + ": " + std::strerror(reason));
    };
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
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
