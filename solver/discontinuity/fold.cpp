#include "discontinuity/fold.h"

namespace penumbra {

std::optional<Fold> Fold::make(const SightEdge &edge, std::span<const Facet> facets) {
    if (edge.facets.size() != 2)
        return std::nullopt;
    Fold fold;
    fold.at_ = edge.a;
    const Vec3 along = (edge.b - edge.a).normalized();
    for (std::size_t k = 0; k < 2; ++k) {
        const Facet &facet = facets[edge.facets[k]];
        Vec3 middle = Vec3::Zero();
        for (const Vec3 &c : facet.corners)
            middle += c / static_cast<double>(facet.corners.size());
        const Vec3 inwards = (middle - edge.a) - (middle - edge.a).dot(along) * along;
        fold.normals_[k] = along.cross(inwards).normalized();
    }
    return fold;
}

bool Fold::hides_from(std::span<const Vec3> points) const {
    constexpr double clear = 2 * weld;
    std::array<int, 2> side{};
    for (std::size_t k = 0; k < 2; ++k)
        for (const Vec3 &p : points) {
            const double height = (p - at_).dot(normals_[k]);
            const int here = height > clear ? 1 : height < -clear ? -1 : 0;
            if (here == 0 || here == -side[k])
                return false;
            side[k] = here;
        }
    return side[0] != side[1];
}

} // namespace penumbra
