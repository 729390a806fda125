#include "render/diverging.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra {

glm::dvec3 diverging(double t) {
    static const std::array<glm::dvec3, 9> colours{{{0, 18, 97},
                                                    {3, 62, 125},
                                                    {30, 111, 157},
                                                    {133, 181, 205},
                                                    {236, 229, 224},
                                                    {221, 177, 149},
                                                    {194, 107, 59},
                                                    {139, 39, 6},
                                                    {89, 0, 7}}};
    const double at = std::clamp(4 * (t + 1), 0.0, 8.0), low = std::min(std::floor(at), 7.0);
    const auto i = static_cast<std::size_t>(low);
    return glm::mix(colours[i], colours[i + 1], at - low) / 255.0;
}

} // namespace penumbra
