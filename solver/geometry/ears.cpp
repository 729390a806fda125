#include "geometry/ears.h"

#include <algorithm>

namespace penumbra {

namespace {

/// Twice the area over the longest side squared: the smallest angle, as far as order goes; not positive for no ear.
double quality(const Vec2 &a, const Vec2 &b, const Vec2 &c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return cross(b - a, c - a) / longest;
}

bool holds_corner(const Polygon &polygon, const std::vector<int> &rest, int a, int b, int c) {
    const auto at = [&](int i) -> const Vec2 & { return polygon[static_cast<std::size_t>(i)]; };
    return std::ranges::any_of(rest, [&](int i) {
        return i != a && i != b && i != c && cross(at(b) - at(a), at(i) - at(a)) >= 0 &&
               cross(at(c) - at(b), at(i) - at(b)) >= 0 && cross(at(a) - at(c), at(i) - at(c)) >= 0;
    });
}

} // namespace

std::vector<std::array<int, 3>> cut_ears(const Polygon &polygon) {
    std::vector<int> rest(polygon.size());
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = static_cast<int>(i);
    const auto at = [&](int i) -> const Vec2 & { return polygon[static_cast<std::size_t>(i)]; };
    std::vector<std::array<int, 3>> triangles;
    while (rest.size() > 2) {
        const std::size_t n = rest.size();
        std::size_t best = 0;
        double most = -1;
        for (std::size_t i = 0; i < n; ++i) {
            const int a = rest[(i + n - 1) % n], b = rest[i], c = rest[(i + 1) % n];
            const double q = quality(at(a), at(b), at(c));
            if (q > most && (n == 3 || (q > 0 && !holds_corner(polygon, rest, a, b, c)))) {
                most = q;
                best = i;
            }
        }
        // Without an ear (rounding has made the rest flat) any corner will do: its triangle has no area to speak of.
        triangles.push_back({rest[(best + n - 1) % n], rest[best], rest[(best + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

} // namespace penumbra
