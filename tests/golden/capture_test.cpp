#include "capture.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <fstream>

namespace penumbra {
namespace {

std::filesystem::path folder() {
    const auto path = std::filesystem::path(testing::TempDir()) /
                      (std::string("capture-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

Image gradient() {
    Image image{37, 21, {}};
    for (int i = 0; i < 37 * 21 * 3; ++i)
        image.rgb.push_back(static_cast<std::uint8_t>(i * 7));
    return image;
}

TEST(Capture, PngBringsBackPixelsAndState) {
    const auto path = folder() / "a.png";
    const std::string state = "{\"scene\": \"figure-4\", \"unit\": \"W/m\u00b2\"}";
    write_png(path, gradient(), state);
    const Image back = read_png(path);
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 21);
    EXPECT_EQ(back.rgb, gradient().rgb);
    EXPECT_EQ(read_png_state(path), state);
    write_png(path, gradient());
    EXPECT_EQ(read_png_state(path), std::nullopt);
}

TEST(Capture, AlphaComesBack) {
    const auto path = folder() / "a.png";
    Image image = gradient();
    for (int i = 0; i < 37 * 21; ++i)
        image.alpha.push_back(static_cast<std::uint8_t>(i));
    write_png(path, image);
    const Image back = read_png(path);
    EXPECT_EQ(back.rgb, image.rgb);
    EXPECT_EQ(back.alpha, image.alpha);
    write_png(path, gradient());
    EXPECT_TRUE(read_png(path).alpha.empty());
}

TEST(Capture, WhatIsNoPngIsBadInput) {
    const auto path = folder() / "a.png";
    EXPECT_THROW(read_png(path), BadInput) << "missing";
    EXPECT_THROW(read_png(path.parent_path()), BadInput) << "a folder";
    std::ofstream(path) << "P6 2 2 255";
    EXPECT_THROW(read_png(path), BadInput) << "another format";
    EXPECT_THROW(read_png_state(path), BadInput);
    write_png(path, gradient(), "{}");
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    EXPECT_THROW(read_png(path), BadInput) << "half of one";
}

TEST(Capture, NumbersNeverRepeat) {
    const auto where = folder() / "new";
    const auto first = numbered_name(where, "penumbra");
    EXPECT_EQ(first.filename(), "penumbra-1.png");
    write_png(first, gradient());
    EXPECT_EQ(numbered_name(where, "penumbra").filename(), "penumbra-2.png");
    std::filesystem::create_symlink("nowhere", where / "penumbra-2.png");
    EXPECT_EQ(numbered_name(where, "penumbra").filename(), "penumbra-3.png") << "a dangling link is a file, too";
}

TEST(Capture, AFolderThatIsNotThereIsSaid) { EXPECT_THROW(write_png(folder() / "no/a.png", gradient()), Unavailable); }

} // namespace
} // namespace penumbra
