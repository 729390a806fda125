#include "files/kept_file.h"

#include "core/atomic_write.h"
#include "core/error.h"

namespace penumbra {

void write_kept_file(const std::filesystem::path &file, std::string_view bytes) {
    std::error_code failure;
    std::filesystem::create_directories(file.parent_path(), failure);
    if (failure)
        throw Unavailable("cannot make the folder " + file.parent_path().string() + ": " + failure.message());
    write_atomically(file, bytes);
}

} // namespace penumbra
