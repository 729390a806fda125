// The chunk `penumbra` of pictures, as Penumbra writes it and as others may leave it.
#include "files/png_state.h"

#include "capture.h"
#include "core/error.h"
#include "core/read_text.h"

#include <zlib.h>

#include <filesystem>
#include <gmock/gmock.h>
#include <unistd.h>

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::Optional;

constexpr std::size_t longest = 1 << 16;

std::string big_endian(std::size_t value) {
    std::string four(4, '\0');
    for (std::size_t i = 0; i < 4; ++i)
        four[i] = static_cast<char>(value >> (24 - 8 * i) & 0xff);
    return four;
}

std::string chunk(const std::string &type_and_data) {
    return big_endian(type_and_data.size() - 4) + type_and_data +
           big_endian(crc32(0, reinterpret_cast<const Bytef *>(type_and_data.data()),
                            static_cast<uInt>(type_and_data.size())));
}

const std::string zero(1, '\0');
const std::string head = "\x89PNG\r\n\x1a\n" + chunk("IHDR" + std::string(13, '\1')), end = chunk("IEND");

std::string itxt(const std::string &key, const std::string &flags, const std::string &text) {
    return chunk("iTXt" + key + zero + flags + zero + zero + text);
}
const std::string plain = zero + zero, compressed = "\1" + zero;

std::string deflated(const std::string &text) {
    uLongf n = compressBound(text.size());
    std::string out(n, '\0');
    compress(reinterpret_cast<Bytef *>(out.data()), &n, reinterpret_cast<const Bytef *>(text.data()), text.size());
    out.resize(n);
    return out;
}

TEST(PngState, WhatAPictureIsGivenIsFound) {
    const auto file =
        std::filesystem::temp_directory_path() / ("penumbra-state-" + std::to_string(::getpid()) + ".png");
    const std::string text = "{\"scene\": \"\u00e9\u03b1\"}\n" + std::string(5000, 'x');
    write_png(file, {2, 1, {1, 2, 3, 4, 5, 6}}, text);
    EXPECT_THAT(state_in_png("a.png", read_bytes(file, largest_png), longest), Optional(text));
    write_png(file, {2, 1, {1, 2, 3, 4, 5, 6}});
    EXPECT_EQ(state_in_png("a.png", read_bytes(file, largest_png), longest), std::nullopt);
    std::filesystem::remove(file);
}

TEST(PngState, OtherProgramsMayMoveOrUnpackIt) {
    const auto found = [](const std::string &chunks) { return state_in_png("a.png", head + chunks, longest); };
    EXPECT_THAT(found(itxt("penumbra", plain, "text") + end), Optional(std::string("text")));
    EXPECT_THAT(found(itxt("penumbra", compressed, deflated("text")) + end), Optional(std::string("text")));
    EXPECT_THAT(found(chunk("IDATx") + itxt("penumbra", plain, "text") + end), Optional(std::string("text")));
    EXPECT_THAT(found(itxt("penumbra2", plain, "other") + itxt("penumbra", plain, "text") + end),
                Optional(std::string("text")));
    EXPECT_EQ(found(itxt("penumbr", plain, "other") + chunk("tEXtpenumbra" + zero + "old") + end), std::nullopt);
    EXPECT_EQ(found(end + itxt("penumbra", plain, "behind the end")), std::nullopt);
}

std::string refusal(const std::string &bytes) {
    try {
        state_in_png("dir/a.png", bytes, longest);
    } catch (const BadInput &e) {
        EXPECT_THAT(e.what(), testing::StartsWith("dir/a.png: "));
        EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
        return e.what();
    }
    ADD_FAILURE() << "was taken";
    return "";
}

TEST(PngState, DamageIsOneLine) {
    EXPECT_THAT(refusal(""), HasSubstr("is no PNG"));
    EXPECT_THAT(refusal("\xff\xd8\xff\xe0 JFIF"), HasSubstr("is no PNG"));
    EXPECT_THAT(refusal(head), HasSubstr("ends in the middle of a chunk, after 33 bytes; copy it again"));
    EXPECT_THAT(refusal(head + "\x7f\xff\xff\xffIDAT" + std::string(100, 'x')), HasSubstr("ends in the middle"));
    EXPECT_THAT(refusal(head + "\xff\xff\xff\xffIDAT" + std::string(100, 'x')), HasSubstr("ends in the middle"));

    std::string bad = itxt("penumbra", plain, "text");
    bad[bad.size() - 6] ^= 1;
    EXPECT_THAT(refusal(head + bad + end), HasSubstr("its chunk 'penumbra' is damaged (its CRC differs); take"));
    EXPECT_THAT(refusal(head + chunk("iTXtpenumbra" + zero) + end), HasSubstr("is cut short"));
    EXPECT_THAT(refusal(head + chunk("iTXtpenumbra" + zero + plain + "en") + end), HasSubstr("is cut short"));
    EXPECT_THAT(refusal(head + itxt("penumbra", "\2" + zero, "text") + end),
                HasSubstr("in a way that PNG does not have"));
    EXPECT_THAT(refusal(head + itxt("penumbra", "\1\1", deflated("text")) + end), HasSubstr("in a way that PNG"));
    EXPECT_THAT(refusal(head + itxt("penumbra", compressed, "text") + end), HasSubstr("does not decompress"));
    const std::string packed = deflated(std::string(1000, 'y') + "z");
    EXPECT_THAT(refusal(head + itxt("penumbra", compressed, packed.substr(0, packed.size() - 5)) + end),
                HasSubstr("does not decompress"));
}

TEST(PngState, LongTextsAreRefusedBeforeTheyAreMade) {
    const std::string at_limit(longest, 'x'), above(longest + 1, 'x');
    EXPECT_THAT(state_in_png("a", head + itxt("penumbra", plain, at_limit), longest), Optional(at_limit));
    EXPECT_THAT(state_in_png("a", head + itxt("penumbra", compressed, deflated(at_limit)), longest),
                Optional(at_limit));
    EXPECT_THAT(refusal(head + itxt("penumbra", plain, above) + end),
                HasSubstr("more than a saved state's limit of 64 KiB"));
    EXPECT_THAT(refusal(head + itxt("penumbra", compressed, deflated(above)) + end), HasSubstr("limit of 64 KiB"));
    // 64 MiB of one letter in 65 KiB.
    EXPECT_THAT(refusal(head + itxt("penumbra", compressed, deflated(std::string(std::size_t{64} << 20, 'x'))) + end),
                HasSubstr("limit of 64 KiB"));
}

} // namespace
} // namespace penumbra
