#include "discontinuity/sees_source.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

/// Twice the area of a planar convex polygon.
double doubled_area(const std::vector<Vec3> &polygon) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return sum.norm();
}

/// Pieces of the convex polygon outside the facet's cone of sight lines from x.
void subtract_cone(const std::vector<Vec3> &piece, const Facet &facet, const Vec3 &x,
                   std::vector<std::vector<Vec3>> &pieces) {
    const double distance = (facet.corners[0] - x).dot(facet.frame.normal);
    if (std::abs(distance) <= coincidence) { // seen edge-on
        pieces.push_back(piece);
        return;
    }
    std::vector<Vec3> inside = piece;
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n && !inside.empty(); ++i) {
        const Vec3 outward =
            ((facet.corners[(i + 1) % n] - x).cross(facet.corners[i] - x) * (distance > 0 ? 1.0 : -1.0));
        if (outward.norm() == 0)
            continue;
        if (std::vector<Vec3> outside = clip_to_front(inside, x, outward.normalized()); !outside.empty())
            pieces.push_back(std::move(outside));
        inside = clip_to_front(std::move(inside), x, -outward.normalized());
    }
}

} // namespace

bool sees_source(const SourceView &view, const Vec3 &x, std::span<const Vec3> half_spaces,
                 std::span<const std::size_t> facets, std::span<const std::size_t> ignored) {
    std::vector<std::vector<Vec3>> pieces;
    for (const Facet &part : view.source_parts) {
        std::vector<Vec3> corners = part.corners;
        for (const Vec3 &normal : half_spaces)
            if (!corners.empty())
                corners = clip_to_front(std::move(corners), x, normal);
        if (!corners.empty())
            pieces.push_back(std::move(corners));
    }
    for (const std::size_t f : facets) {
        if (pieces.empty())
            return false;
        if (std::ranges::binary_search(ignored, f))
            continue;
        std::vector<std::vector<Vec3>> left;
        for (const std::vector<Vec3> &piece : pieces)
            subtract_cone(piece, view.facets[f], x, left);
        std::erase_if(left, [](const std::vector<Vec3> &p) { return doubled_area(p) < coincidence * coincidence; });
        pieces = std::move(left);
    }
    return !pieces.empty();
}

} // namespace penumbra
