#include "discontinuity/outlines.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

std::vector<Vec3> Outlines::add(std::span<const Vec3> outline) {
    std::vector<std::size_t> ids;
    std::vector<Vec3> welded;
    for (const Vec3 &c : outline) {
        ids.push_back(id_of(c));
        welded.push_back(corners_[ids.back()]);
    }
    for (std::size_t i = 0; i < ids.size(); ++i)
        join(ids[i], ids[(i + 1) % ids.size()]);
    return welded;
}

void Outlines::add_edge(const Vec3 &a, const Vec3 &b) {
    const std::size_t i = id_of(a);
    join(i, id_of(b));
}

void Outlines::join(std::size_t i, std::size_t j) {
    if (i != j)
        edges_.insert(std::minmax(i, j));
}

std::vector<OutlineEdge> Outlines::edges() const {
    std::vector<OutlineEdge> all;
    for (const auto &[a, b] : edges_)
        all.push_back({corners_[a], corners_[b]});
    return all;
}

std::size_t Outlines::id_of(const Vec3 &corner) {
    // A direction that no building is aligned with: hardly any two corners share a key unless they coincide.
    const double key = corner.dot(Vec3(0.5377, 0.2231, 0.8132));
    for (auto near = ids_.lower_bound(key - 2 * tolerance_); near != ids_.end() && near->first <= key + 2 * tolerance_;
         ++near)
        if ((corners_[near->second] - corner).norm() <= 2 * tolerance_)
            return near->second;
    Vec3 at = corner;
    for (const PlaneFrame &plane : planes_)
        if (std::abs(plane.height(at)) <= tolerance_)
            at -= plane.height(at) * plane.normal;
    ids_.emplace(key, corners_.size());
    corners_.push_back(at);
    return corners_.size() - 1;
}

} // namespace penumbra
