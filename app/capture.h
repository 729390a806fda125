// Pictures: reading them from the framebuffer, and PNG files that carry the state they were made from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb; ///< 3 bytes a pixel, rows from the top, sRGB; not multiplied by alpha
    std::vector<std::uint8_t> alpha{}; ///< a byte a pixel, 255 where nothing shines through; empty: nowhere does it
};

/// Pixels of the current read framebuffer; x, y count from its lower left corner, as GL does.
Image read_pixels(int x, int y, int width, int height);

/// Writes a PNG, atomically, with `state` (UTF-8 JSON text) in an iTXt chunk named `penumbra`; none when empty.
/// With alpha it is RGBA. Throws Unavailable when the file cannot be written.
void write_png(const std::filesystem::path &path, const Image &image, const std::string &state = "");
/// Throws BadInput, one line, when it is no readable PNG. Greys and palettes become RGB.
Image read_png(const std::filesystem::path &path);
/// The text of the chunk `penumbra`, or nothing when the file has none. Throws BadInput when it is no readable PNG.
std::optional<std::string> read_png_state(const std::filesystem::path &path);

/// folder/stem-1.png, -2, ...: the first name that does not exist. The folder is made when it is missing.
std::filesystem::path numbered_name(const std::filesystem::path &folder, const std::string &stem,
                                    const std::string &extension = ".png");

} // namespace penumbra
