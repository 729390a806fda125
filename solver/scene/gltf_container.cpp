#include "scene/gltf_container.h"

#include "core/error.h"

#include <cstdint>
#include <fmt/format.h>

namespace penumbra {

namespace {

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

int digit(char c) {
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

} // namespace

GltfContainer split_container(const std::string &file, std::string_view bytes) {
    if (!bytes.starts_with("glTF"))
        return {bytes.substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0), std::nullopt};
    constexpr std::size_t header = 12, chunk_header = 8;
    constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
    if (bytes.size() < header + chunk_header)
        throw BadInput(fmt::format("{}: a .glb of {} bytes ends in its header; export it again", file, bytes.size()));
    if (const auto version = word_at(bytes, 4); version != 2)
        throw BadInput(fmt::format("{}: is glTF version {}; export it as glTF 2.0", file, version));
    if (const auto length = word_at(bytes, 8); length > bytes.size())
        throw BadInput(
            fmt::format("{}: says that it is {} bytes long but has {}; it was cut off, export or copy it again", file,
                        length, bytes.size()));
    GltfContainer out;
    for (std::size_t at = header, n = 0; at + chunk_header <= bytes.size() && n < 2; ++n) {
        const std::size_t length = word_at(bytes, at);
        const std::uint32_t kind = word_at(bytes, at + 4);
        at += chunk_header;
        if (length > bytes.size() - at)
            throw BadInput(fmt::format("{}: chunk {} says that it is {} bytes long but {} are left; export it again",
                                       file, n, length, bytes.size() - at));
        const std::string_view chunk = bytes.substr(at, length);
        at += length;
        if (n == 0 && kind != json_chunk)
            throw BadInput(fmt::format("{}: its first chunk is of kind {:#x}, not JSON; export it again", file, kind));
        if (n == 0)
            out.json = chunk;
        else if (kind == binary_chunk)
            out.binary = chunk;
    }
    return out;
}

std::optional<std::string> decode_base64(std::string_view text) {
    for (int i = 0; i < 2 && text.ends_with('='); ++i)
        text.remove_suffix(1);
    if (text.size() % 4 == 1)
        return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    for (std::size_t i = 0, n_bits = 0; i < text.size(); ++i) {
        const int d = digit(text[i]);
        if (d < 0)
            return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(d);
        if ((n_bits += 6) >= 8)
            bytes += static_cast<char>(bits >> (n_bits -= 8) & 0xff);
    }
    return bytes;
}

} // namespace penumbra
