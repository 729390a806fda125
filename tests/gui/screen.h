// A virtual display, and what is on it, read from the server's own memory: what the user would see, whatever the
// program believes.
#pragma once

#include "gui/process.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace penumbra::gui {

using Colour = std::array<std::uint8_t, 3>;

struct Screenshot {
    int width = 0, height = 0;
    std::vector<Colour> pixels; ///< rows from the top
    const Colour &at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

struct Box {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Mean of all channels over the box, 0 to 255.
double brightness(const Screenshot &shot, const Box &box);
/// Share of the box' pixels that differ by more than 8 in some channel.
double changed_share(const Screenshot &before, const Screenshot &after, const Box &box);
/// Share of the box' pixels within `slack` of the colour in every channel.
double share_of(const Screenshot &shot, const Box &box, const Colour &colour, int slack);

class Screen {
public:
    /// Starts Xvfb on a display number that is free.
    Screen(int width, int height);
    ~Screen();
    Screen(const Screen &) = delete;
    Screen &operator=(const Screen &) = delete;

    const std::string &display() const { return display_; } ///< ":7"
    Screenshot shot() const;

private:
    std::filesystem::path folder_;
    std::unique_ptr<Process> server_;
    std::string display_;
};

} // namespace penumbra::gui
