#include "commands/progress.h"

#include "commands/terminal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace penumbra {

Progress::Progress(const Options &options, bool quiet, bool verbose)
    : threshold_(options.threshold), bar_(!quiet && !verbose && error_is_terminal()), lines_(!quiet && verbose) {}

Progress::~Progress() {
    if (bar_)
        std::fputs("\r\033[K", stderr);
}

/// The change falls by about the same factor in each iteration, down to a tenth of the threshold.
double Progress::fraction(double change) const {
    const double goal = 0.1 * threshold_;
    if (!(change > goal) || !(first_change_ > goal))
        return 1;
    return std::clamp(std::log(first_change_ / change) / std::log(first_change_ / goal), 0.0, 1.0);
}

void Progress::show(const Counters &c) {
    if (lines_)
        std::fprintf(stderr, "iteration %d: %d patches, %lld links, change %.3g, %.3g s\n", c.iteration, c.patches,
                     static_cast<long long>(c.links), c.change, c.seconds);
    if (!bar_)
        return;
    first_change_ = std::max(first_change_, c.change);
    constexpr int width = 30;
    std::string bar(width, '.');
    std::fill_n(bar.begin(), static_cast<int>(width * fraction(c.change)), '#');
    std::fprintf(stderr, "\r\033[K[%s] iteration %d, %d patches, change %.2g", bar.c_str(), c.iteration, c.patches,
                 c.change);
    std::fflush(stderr);
}

} // namespace penumbra
