#include "gui/screen.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace penumbra::gui {

namespace {

template <class Body>
void for_each(const Box &box, Body body) {
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            body(x, y);
}

double share(double n, const Box &box) { return n / (static_cast<double>(box.width) * box.height); }

bool near(const Colour &a, const Colour &b, int slack) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i])) > slack)
            return false;
    return true;
}

/// Field of an XWD header (X11's XWDFile.h): 32 bits, most significant byte first.
std::uint32_t field(const std::string &bytes, int index) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(4 * index + i)]);
    return value;
}

} // namespace

double brightness(const Screenshot &shot, const Box &box) {
    double sum = 0;
    for_each(box, [&](int x, int y) {
        for (const std::uint8_t c : shot.at(x, y))
            sum += c / 3.0;
    });
    return share(sum, box);
}

double changed_share(const Screenshot &before, const Screenshot &after, const Box &box) {
    double n = 0;
    for_each(box, [&](int x, int y) { n += near(before.at(x, y), after.at(x, y), 8) ? 0 : 1; });
    return share(n, box);
}

double share_of(const Screenshot &shot, const Box &box, const Colour &colour, int slack) {
    double n = 0;
    for_each(box, [&](int x, int y) { n += near(shot.at(x, y), colour, slack) ? 1 : 0; });
    return share(n, box);
}

Screen::Screen(int width, int height) {
    char name[] = "/tmp/penumbra-screen-XXXXXX";
    if (!::mkdtemp(name))
        throw std::runtime_error("cannot make a temporary folder");
    folder_ = name;
    // The server itself finds a free number and writes it to the descriptor that it inherits.
    const std::filesystem::path number = folder_ / "display";
    const int file = ::open(number.c_str(), O_RDWR | O_CREAT, 0600);
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    server_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(file), "-screen", "0", size, "-fbdir",
                                 folder_.string(), "-nolisten", "tcp", "-noreset"},
        Environment{}, "", (folder_ / "log").string());
    ::close(file);
    for (int i = 0; i < 1000 && display_.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        std::ifstream in(number);
        std::string text;
        if (std::getline(in, text) && !in.eof())
            display_ = ":" + text;
        if (!server_->running())
            throw std::runtime_error("Xvfb did not start (is it installed?)");
    }
    if (display_.empty())
        throw std::runtime_error("Xvfb gave no display");
}

Screen::~Screen() {
    server_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

Screenshot Screen::shot() const {
    std::ifstream in(folder_ / "Xvfb_screen0", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    if (bytes.size() < 100)
        throw std::runtime_error("no screen to read");
    const std::size_t header = field(bytes, 0), n_colours = field(bytes, 19);
    Screenshot shot;
    shot.width = static_cast<int>(field(bytes, 4));
    shot.height = static_cast<int>(field(bytes, 5));
    const std::size_t row = field(bytes, 12), start = header + 12 * n_colours;
    shot.pixels.reserve(static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(shot.height); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(shot.width); ++x) {
            const std::size_t p = start + y * row + 4 * x; // blue, green, red, unused
            const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes.at(p + i)); };
            shot.pixels.push_back({byte(2), byte(1), byte(0)});
        }
    return shot;
}

} // namespace penumbra::gui
