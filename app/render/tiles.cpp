#include "render/tiles.h"

#include "gl/framebuffer.h"
#include "render/tone.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace penumbra {

namespace {

std::array<float, 256> decoded() {
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = static_cast<float>(linear_of_srgb(static_cast<double>(i) / 255));
    return light;
}

/// Bytes of RGBA, rows from the bottom, of the bound framebuffer.
std::vector<std::uint8_t> read_rgba(const PixelRect &tile) {
    std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

std::uint8_t to_byte(double x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 255.0))); }

struct Pixel {
    std::array<std::uint8_t, 3> rgb{};
    std::uint8_t alpha = 0;
};

/// The same without its alpha multiplied into it.
Pixel freed(const std::uint8_t *rgba) {
    Pixel p{{}, rgba[3]};
    for (std::size_t c = 0; c < 3; ++c)
        p.rgb[c] = p.alpha == 0 ? std::uint8_t{0} : to_byte(255.0 * rgba[c] / p.alpha);
    return p;
}

/// Of a square of n x n samples from `first` on, in rows that are `row` bytes apart.
Pixel average(const std::uint8_t *first, int n, std::size_t row, bool transparent, const std::array<float, 256> &light) {
    if (n == 1)
        return transparent ? freed(first) : Pixel{{first[0], first[1], first[2]}, 255};
    std::array<double, 3> sum{};
    double weight = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const std::uint8_t *sample = first + static_cast<std::size_t>(y) * row + 4 * static_cast<std::size_t>(x);
            const Pixel p = transparent ? freed(sample) : Pixel{{sample[0], sample[1], sample[2]}, 255};
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += static_cast<double>(p.alpha) * static_cast<double>(light[p.rgb[c]]);
            weight += p.alpha;
        }
    Pixel mean{{}, to_byte(weight / (n * n))};
    for (std::size_t c = 0; c < 3; ++c)
        mean.rgb[c] = weight > 0 ? to_byte(255 * srgb(sum[c] / weight)) : std::uint8_t{0};
    return mean;
}

/// Puts a tile's samples into their place in the image.
void put(Image &image, const Tiling &tiling, const PixelRect &tile, const std::vector<std::uint8_t> &rgba) {
    static const std::array<float, 256> light = decoded();
    const int n = tiling.supersample;
    const std::size_t row = 4 * static_cast<std::size_t>(tile.width);
    for (int y = 0; y < tile.height / n; ++y) {
        const int from_bottom = tile.height - (y + 1) * n;
        for (int x = 0; x < tile.width / n; ++x) {
            const std::size_t to = static_cast<std::size_t>(tile.y / n + y) * static_cast<std::size_t>(image.width) +
                                   static_cast<std::size_t>(tile.x / n + x);
            const Pixel p = average(rgba.data() + static_cast<std::size_t>(from_bottom) * row +
                                        4 * static_cast<std::size_t>(n) * static_cast<std::size_t>(x),
                                    n, row, tiling.transparent, light);
            std::copy(p.rgb.begin(), p.rgb.end(), image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * to));
            if (tiling.transparent)
                image.alpha[to] = p.alpha;
        }
    }
}

/// Samples to a tile's side: whole pixels, and an even number.
int side_of(const Tiling &tiling) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    const int unit = 2 * tiling.supersample;
    return std::max(unit, std::min(tiling.largest, static_cast<int>(most)) / unit * unit);
}

} // namespace

struct TiledDrawing::Parts {
    Tiling tiling;
    int width, height, side; ///< [samples]
    gl::Framebuffer canvas, flat;
    Image image;
    int next = 0; ///< tile

    explicit Parts(const Tiling &t)
        : tiling(t), width(t.width * t.supersample), height(t.height * t.supersample), side(side_of(t)),
          canvas(std::min(side, width), std::min(side, height), gl::Framebuffer::Colour::srgb8, 4),
          flat(std::min(side, width), std::min(side, height), gl::Framebuffer::Colour::srgb8, 1) {
        const auto n_pixels = static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height);
        image = {t.width, t.height, std::vector<std::uint8_t>(3 * n_pixels), std::vector<std::uint8_t>(t.transparent ? n_pixels : 0)};
    }
    int columns() const { return (width + side - 1) / side; }
    int n_tiles() const { return columns() * ((height + side - 1) / side); }
};

TiledDrawing::TiledDrawing(const Tiling &tiling) : parts_(std::make_unique<Parts>(tiling)) {}
TiledDrawing::~TiledDrawing() = default;

bool TiledDrawing::draw_tile(const std::function<void(const PixelRect &)> &draw_smooth,
                             const std::function<void(const PixelRect &)> &draw_over) {
    Parts &p = *parts_;
    if (p.next == p.n_tiles())
        return false;
    const int left = p.next % p.columns() * p.side, bottom = p.next / p.columns() * p.side;
    const int high = std::min(p.side, p.height - bottom);
    const PixelRect tile{left, p.height - bottom - high, std::min(p.side, p.width - left), high};
    const glm::vec4 &background = p.tiling.background;
    p.canvas.bind();
    glDisable(GL_SCISSOR_TEST);
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_smooth(tile);
    p.flat.resolve(p.canvas, 0, 0, tile.width, tile.height);
    draw_over(tile);
    p.flat.bind();
    put(p.image, p.tiling, tile, read_rgba(tile));
    ++p.next;
    return true;
}

double TiledDrawing::share() const { return static_cast<double>(parts_->next) / parts_->n_tiles(); }

Image TiledDrawing::take() && { return std::move(parts_->image); }

} // namespace penumbra
