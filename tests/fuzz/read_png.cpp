// The state in a picture: any bytes as the file, and the same with the CRCs of all its chunks put right, as made-up
// bytes hardly ever have them.
#include "files/png_state.h"
#include "fuzz/sound.h"

#include <zlib.h>

namespace {

constexpr std::size_t longest = 1 << 16;

void mend_crcs(std::string &bytes) {
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
        if (length > bytes.size() - at - 12)
            return;
        const std::uint32_t crc = static_cast<std::uint32_t>(
            crc32(0, reinterpret_cast<const Bytef *>(bytes.data() + at + 4), static_cast<uInt>(4 + length)));
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 0xff);
        at += 12 + length;
    }
}

void read(const std::string &bytes) {
    using namespace penumbra;
    fuzz::expect_refusal_in_one_line([&] {
        const auto text = state_in_png("a.png", bytes, longest);
        fuzz::expect(!text || text->size() <= longest, "is too long", "");
    });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    std::string bytes(reinterpret_cast<const char *>(data), size);
    read(bytes);
    mend_crcs(bytes);
    read(bytes);
    return 0;
}
