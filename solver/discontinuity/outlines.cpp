#include "discontinuity/outlines.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace penumbra {

namespace {

/// Where two segments come within `reach` of each other; none for parallel ones.
std::optional<Vec3> crossing(const OutlineEdge &e, const OutlineEdge &f, double reach) {
    const Vec3 d = e.b - e.a, g = f.b - f.a, across = d.cross(g), between = f.a - e.a;
    const double size2 = across.squaredNorm(), off = across.dot(between);
    if (size2 <= 1e-18 * d.squaredNorm() * g.squaredNorm() || off * off > reach * reach * size2)
        return std::nullopt;
    const double s = between.cross(g).dot(across) / size2, t = between.cross(d).dot(across) / size2;
    if (s < 0 || s > 1 || t < 0 || t > 1)
        return std::nullopt;
    return e.a + s * d;
}

} // namespace

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

void Outlines::add_crossings(double reach) {
    std::vector<std::pair<std::size_t, std::size_t>> by_x(edges_.begin(), edges_.end());
    const auto low_x = [&](const auto &e) { return std::min(corners_[e.first].x(), corners_[e.second].x()); };
    const auto high_x = [&](const auto &e) { return std::max(corners_[e.first].x(), corners_[e.second].x()); };
    std::ranges::sort(by_x, {}, low_x);
    std::vector<Vec3> found;
    for (auto e = by_x.begin(); e != by_x.end(); ++e)
        for (auto f = e + 1; f != by_x.end() && low_x(*f) <= high_x(*e) + reach; ++f)
            if (e->first != f->first && e->first != f->second && e->second != f->first && e->second != f->second)
                if (const auto at = crossing({corners_[e->first], corners_[e->second]},
                                             {corners_[f->first], corners_[f->second]}, reach))
                    found.push_back(*at);
    for (const Vec3 &corner : found)
        id_of(corner);
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
