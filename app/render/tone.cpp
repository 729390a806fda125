#include "render/tone.h"

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

double tone(double x) {
    constexpr double shoulder = 0.8;
    return x < shoulder ? std::max(x, 0.0) : 1 - (1 - shoulder) * std::exp((shoulder - x) / (1 - shoulder));
}

} // namespace

double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

double linear_of_srgb(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

glm::dvec3 cividis(double t) {
    t = std::clamp(t, 0.0, 1.0);
    const glm::dvec3 c(-4.54 - t * (35.34 - t * (2381.73 - t * (6402.7 - t * (7024.72 - t * 2710.57)))),
                       32.49 + t * (170.73 + t * (52.82 - t * (131.46 - t * (176.58 - t * 67.37)))),
                       81.24 + t * (442.36 - t * (2482.43 - t * (6167.24 - t * (6614.94 - t * 2475.67)))));
    return glm::clamp(c / 255.0, 0.0, 1.0);
}

glm::dvec3 shown(const Look &look, const Range &range, double radiosity) {
    const double x = std::exp2(look.exposure_ev) * (radiosity - range.low) / (range.high - range.low);
    return look.false_colour ? cividis(x) : glm::dvec3(srgb(tone(x)));
}

} // namespace penumbra
