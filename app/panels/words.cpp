#include "panels/words.h"

#include "timeline.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace penumbra {

namespace {
template <class... Args>
std::string print(const char *format, Args... args) {
    char text[64];
    std::snprintf(text, sizeof text, format, args...);
    return text;
}
} // namespace

std::string count_words(std::int64_t n) {
    if (n < 0)
        return "–";
    if (n >= 10'000'000)
        return print("%.1f M", 1e-6 * static_cast<double>(n));
    std::string digits = std::to_string(n);
    for (std::size_t i = digits.size(); i > 3; i -= 3)
        digits.insert(i - 3, "\u2009");
    return digits;
}

std::string number_words(double x) { return print("%.3g", x); }

std::string power_words(double x, int digits) {
    static constexpr const char *raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = print("%.*g", digits, x);
    if (!text.empty() && text[0] == '-')
        text.replace(0, 1, "\u2212");
    const std::size_t at = text.find('e');
    if (at == std::string::npos)
        return text;
    const int power = std::stoi(text.substr(at + 1));
    text.resize(at);
    text += "\u00b710";
    if (power < 0)
        text += "\u207b";
    for (const char digit : std::to_string(std::abs(power)))
        text += raised[digit - '0'];
    return text;
}

std::string rgb_words(const Rgb &c) {
    const std::string red = number_words(c[0]), green = number_words(c[1]), blue = number_words(c[2]);
    return red == green && green == blue ? red : red + " " + green + " " + blue;
}

std::string seconds_words(double s) {
    if (s < 0.0995)
        return print("%.2g ms", 1e3 * s);
    if (s < 99.95)
        return print("%.3g s", s);
    return print("%d min %d s", static_cast<int>(s / 60), static_cast<int>(std::fmod(s, 60)));
}

std::string memory_words(double bytes) {
    constexpr double kib = 1024, mib = kib * kib, gib = kib * mib;
    if (bytes < mib)
        return print("%.0f KiB", bytes / kib);
    return bytes < gib ? print("%.3g MiB", bytes / mib) : print("%.3g GiB", bytes / gib);
}

std::string phase_verb(int position) {
    switch (phase_of(position)) {
    case Phase::start:
        return "Prepare";
    case Phase::refined:
        return "Refine";
    case Phase::gathered:
        return "Gather";
    case Phase::pushed_pulled:
        return "Push and pull";
    }
    return {};
}

std::string position_words(int position) {
    if (position == 0)
        return "start";
    constexpr const char *done[] = {"start", "refined", "gathered", "complete"};
    return "iteration " + std::to_string(iteration_of(position)) + ", " +
           done[static_cast<std::size_t>(phase_of(position))];
}

} // namespace penumbra
