// Pictures as the window knows them: how they are to be drawn, and which are still to be taken.
#pragma once

#include "core/options.h"
#include "layout.h"

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

/// Sizes offered; `panes`: the window's own, enlarged to a slide's width.
enum class PictureSize { panes, full_hd, ultra_hd, eight_k };
struct PixelSize {
    int width = 0, height = 0;
};
/// None for the window's own.
constexpr PixelSize pixels_of(PictureSize size) {
    constexpr PixelSize sizes[] = {{0, 0}, {1920, 1080}, {3840, 2160}, {7680, 4320}};
    return sizes[static_cast<std::size_t>(size)];
}

struct PictureSettings {
    PictureSize size = PictureSize::panes;
    int supersample = 1; ///< 1 to 4
    bool transparent = false, labels = true;
    bool operator==(const PictureSettings &) const = default;
};

/// A picture that is taken as soon as all that it shows is known.
struct PendingPicture {
    std::uint64_t run = 0; ///< that it is of
    std::vector<Strategy> strategies;
    std::vector<bool> reconstructed; ///< by pane
    Layout layout{};                 ///< that has so many panes
    std::vector<int> positions;      ///< by pane
    std::filesystem::path file; ///< empty: the next numbered name
    std::string title;          ///< "Picture 3 of 12"
};

struct PictureMode {
    PictureSettings settings;
    bool settings_open = false;
    std::deque<PendingPicture> pending; ///< in their order
    std::optional<double> drawn; ///< share of the picture that is being drawn, the first of them or another; none: none is
    std::string command;                ///< copied last
};

} // namespace penumbra
