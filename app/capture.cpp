#include "capture.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/read_text.h"
#include "files/png_state.h"
#include "files/read_state.h"

#include <epoxy/gl.h>
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

namespace penumbra {
namespace {

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    // libpng's callers are left by an exception: everything they own is freed by destructors.
    const auto *path = static_cast<const std::string *>(png_get_error_ptr(png));
    throw BadInput(*path + ": no readable PNG (" + message + "); save it anew");
}
void on_warning(png_structp, png_const_charp) {}

struct Reader {
    std::string path;
    std::unique_ptr<std::FILE, int (*)(std::FILE *)> file{nullptr, std::fclose};
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit Reader(const std::filesystem::path &p) : path(p.string()), file(std::fopen(path.c_str(), "rb"), std::fclose) {
        unsigned char head[8] = {};
        if (!file)
            throw BadInput(path + ": cannot be read: " + std::strerror(errno));
        if (std::fread(head, 1, 8, file.get()) != 8 || png_sig_cmp(head, 0, 8) != 0)
            throw BadInput(path + ": is no PNG; name a PNG file");
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &path, on_error, on_warning);
        info = png_create_info_struct(png);
        png_init_io(png, file.get());
        png_set_sig_bytes(png, 8);
        png_set_user_limits(png, 32768, 32768);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;
};

/// A row as the file has it; `mixed` is room for it.
const std::uint8_t *row_of(const Image &image, std::size_t y, std::vector<std::uint8_t> &mixed) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::uint8_t *rgb = image.rgb.data() + y * width * 3;
    if (image.alpha.empty())
        return rgb;
    mixed.resize(4 * width);
    for (std::size_t x = 0; x < width; ++x) {
        std::copy_n(rgb + 3 * x, 3, mixed.data() + 4 * x);
        mixed[4 * x + 3] = image.alpha[y * width + x];
    }
    return mixed.data();
}

/// Of pixels that were read as RGBA.
void split_alpha(Image &image) {
    const std::size_t n = image.rgb.size() / 4;
    image.alpha.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        image.alpha[i] = image.rgb[4 * i + 3];
        std::copy_n(image.rgb.data() + 4 * i, 3, image.rgb.data() + 3 * i);
    }
    image.rgb.resize(3 * n);
}

} // namespace

Image read_pixels(int x, int y, int width, int height) {
    Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
    std::vector<std::uint8_t> upside_down(image.rgb.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
    const std::size_t row = static_cast<std::size_t>(width) * 3;
    for (std::size_t i = 0; i < static_cast<std::size_t>(height); ++i)
        std::memcpy(image.rgb.data() + i * row, upside_down.data() + (static_cast<std::size_t>(height) - 1 - i) * row, row);
    return image;
}

void write_png(const std::filesystem::path &path, const Image &image, const std::string &state) {
    std::string bytes, name = path.string();
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &name, on_error, on_warning);
    png_infop info = png_create_info_struct(png);
    const struct Guard {
        png_structp *png;
        png_infop *info;
        ~Guard() { png_destroy_write_struct(png, info); }
    } guard{&png, &info};
    png_set_write_fn(
        png, &bytes,
        [](png_structp p, png_bytep data, std::size_t n) {
            static_cast<std::string *>(png_get_io_ptr(p))->append(reinterpret_cast<const char *>(data), n);
        },
        nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 image.alpha.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    std::string key = png_state_key, text = state, nothing;
    png_text chunk{};
    chunk.compression = PNG_ITXT_COMPRESSION_zTXt;
    chunk.key = key.data();
    chunk.text = text.data();
    chunk.itxt_length = text.size();
    chunk.lang = nothing.data();
    chunk.lang_key = nothing.data();
    if (!state.empty())
        png_set_text(png, info, &chunk, 1);
    png_write_info(png, info);
    std::vector<std::uint8_t> mixed;
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
        png_write_row(png, row_of(image, y, mixed));
    png_write_end(png, info);
    write_atomically(path, bytes);
}

Image read_png(const std::filesystem::path &path) {
    Reader reader(path);
    png_read_info(reader.png, reader.info);
    png_set_expand(reader.png);
    png_set_strip_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    const int passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    Image image;
    image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    const bool with_alpha = png_get_channels(reader.png, reader.info) == 4;
    const std::size_t row = static_cast<std::size_t>(image.width) * (with_alpha ? 4 : 3);
    image.rgb.resize(row * static_cast<std::size_t>(image.height));
    for (int pass = 0; pass < passes; ++pass)
        for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
            png_read_row(reader.png, image.rgb.data() + y * row, nullptr);
    if (with_alpha)
        split_alpha(image);
    return image;
}

std::optional<std::string> read_png_state(const std::filesystem::path &path) {
    return state_in_png(path.string(), read_bytes(path, largest_png), largest_state);
}

std::filesystem::path numbered_name(const std::filesystem::path &folder, const std::string &stem,
                                    const std::string &extension) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Unavailable("cannot make the folder " + folder.string() + ": " + error.message());
    for (int i = 1;; ++i) {
        const std::filesystem::path path = folder / (stem + "-" + std::to_string(i) + extension);
        if (!std::filesystem::exists(std::filesystem::symlink_status(path)))
            return path;
    }
}

} // namespace penumbra
