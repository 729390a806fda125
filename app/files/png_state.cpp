#include "files/png_state.h"

#include "core/error.h"

#include <zlib.h>

#include <fmt/format.h>

#include <cstdint>
#include <memory>

namespace penumbra {

namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t frame = 12; ///< length, type and CRC of a chunk

std::uint32_t big_endian(std::string_view four) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(four[i]);
    return value;
}

std::uint32_t crc_of(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef *>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// Takes what stands before the next zero byte, and the zero.
std::optional<std::string_view> take_word(std::string_view &data) {
    const std::size_t end = data.find('\0');
    if (end == data.npos)
        return std::nullopt;
    const std::string_view word = data.substr(0, end);
    data.remove_prefix(end + 1);
    return word;
}

class TextChunk {
public:
    TextChunk(const std::string &file, std::size_t longest) : file_(file), longest_(longest) {}

    /// `data` from behind the keyword.
    std::string text(std::string_view data) const {
        if (data.size() < 2)
            damaged("is cut short");
        const char compressed = data[0], method = data[1];
        data.remove_prefix(2);
        if (!take_word(data) || !take_word(data)) // language, translated keyword
            damaged("is cut short");
        if (compressed == 0 && data.size() <= longest_)
            return std::string(data);
        if (compressed == 0)
            too_long();
        if (compressed != 1 || method != 0)
            damaged("is compressed in a way that PNG does not have");
        return inflated(data);
    }

    [[noreturn]] void damaged(const char *how) const {
        throw BadInput(fmt::format("{}: its chunk '{}' {}; take an undamaged copy, or open the scene itself", file_,
                                   png_state_key, how));
    }

private:
    [[noreturn]] void too_long() const {
        throw BadInput(fmt::format("{}: its chunk '{}' holds more than a saved state's limit of {} KiB; open a picture "
                                   "that Penumbra wrote",
                                   file_, png_state_key, longest_ >> 10));
    }

    std::string inflated(std::string_view data) const {
        z_stream stream{};
        if (inflateInit(&stream) != Z_OK)
            throw std::bad_alloc();
        const std::unique_ptr<z_stream, int (*)(z_stream *)> end(&stream, inflateEnd);
        stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(data.data()));
        stream.avail_in = static_cast<uInt>(data.size());
        std::string text;
        char buffer[1 << 14];
        for (int status = Z_OK; status != Z_STREAM_END;) {
            stream.next_out = reinterpret_cast<Bytef *>(buffer);
            stream.avail_out = sizeof buffer;
            status = inflate(&stream, Z_NO_FLUSH);
            const std::size_t n = sizeof buffer - stream.avail_out;
            if (status != Z_STREAM_END && (status != Z_OK || n == 0))
                damaged("does not decompress");
            if (text.size() + n > longest_)
                too_long();
            text.append(buffer, n);
        }
        return text;
    }

    const std::string &file_;
    std::size_t longest_;
};

} // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with(signature); }

std::optional<std::string> state_in_png(const std::string &file, std::string_view bytes, std::size_t longest) {
    if (!is_png(bytes))
        throw BadInput(file + ": is no PNG; name a PNG file that Penumbra wrote");
    const std::string key(png_state_key, sizeof png_state_key); // with its zero
    const std::size_t n_bytes = bytes.size();
    bytes.remove_prefix(signature.size());
    for (std::string_view type; type != "IEND";) {
        const std::size_t length = bytes.size() < frame ? 0 : big_endian(bytes);
        if (bytes.size() < frame || length > bytes.size() - frame)
            throw BadInput(
                fmt::format("{}: ends in the middle of a chunk, after {} bytes; copy it again", file, n_bytes));
        type = bytes.substr(4, 4);
        const std::string_view data = bytes.substr(8, length);
        if (type == "iTXt" && data.starts_with(key)) {
            const TextChunk chunk(file, longest);
            if (crc_of(bytes.substr(4, 4 + length)) != big_endian(bytes.substr(8 + length)))
                chunk.damaged("is damaged (its CRC differs)");
            return chunk.text(data.substr(key.size()));
        }
        bytes.remove_prefix(frame + length);
    }
    return std::nullopt;
}

} // namespace penumbra
