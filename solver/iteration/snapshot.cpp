#include "iteration/snapshot.h"

#include "basis/element_basis.h"
#include "basis/legendre.h"

#include <algorithm>

namespace penumbra {

std::string_view name(Phase phase) {
    switch (phase) {
    case Phase::start:
        return "start";
    case Phase::refined:
        return "refine";
    case Phase::gathered:
        return "gather";
    case Phase::pushed_pulled:
        return "push-pull";
    }
    return "";
}

bool is_box(const SnapshotPatch &patch) {
    return std::ranges::any_of(
        patch.quad, [&](const Vec2 &q) { return std::ranges::find(patch.corners, q) == patch.corners.end(); });
}

std::vector<BilinearQuad> tiles(const SnapshotPatch &patch) {
    if (!is_box(patch))
        return {BilinearQuad{patch.quad}};
    std::vector<BilinearQuad> quads;
    for (const Polygon &piece : quads_and_triangles(patch.corners))
        quads.push_back(bilinear_quad(piece));
    return quads;
}

Vec2 to_plane(const SnapshotSurface &surface, const Vec3 &point) {
    return {(point - surface.origin).dot(surface.u), (point - surface.origin).dot(surface.v)};
}

bool holds(const SnapshotSurface &surface, const Vec2 &p) {
    const std::vector<Vec2> &outline = surface.outline;
    bool in = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vec2 &a = outline[i], &b = outline[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            in = !in;
    }
    return in;
}

bool is_covered(const SnapshotSurface &surface, const Vec2 &p) {
    return std::ranges::any_of(surface.covers, [&](const auto &cover) { return contains(cover, p); });
}

Rgb radiosity_at(const Snapshot &snapshot, const SnapshotPatch &patch, double u, double v) {
    const auto a = legendre(u), b = legendre(v);
    Rgb sum = Rgb::Zero();
    for (int i = 0, k = patch.first; i < patch.order; ++i)
        for (int j = 0; j < patch.order; ++j, ++k)
            sum += a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)] *
                   snapshot.coefficients[static_cast<std::size_t>(k)];
    return sum;
}

Rgb radiosity(const Snapshot &snapshot, const SnapshotPatch &patch, const Vec2 &p) {
    const BasisValues value = ElementBasis(patch.order, BilinearQuad{patch.quad}).evaluate(p);
    Rgb sum = Rgb::Zero();
    for (Eigen::Index k = 0; k < value.size(); ++k)
        sum += value[k] * snapshot.coefficients[static_cast<std::size_t>(patch.first + k)];
    return sum;
}

Rgb radiosity_slope(const Snapshot &snapshot, const SnapshotPatch &patch, const Vec2 &p, const Vec2 &direction) {
    const BilinearQuad quad{patch.quad};
    const auto &c = quad.corners;
    const Vec2 at = quad.inverse(p);
    const double u = at.x(), v = at.y();
    const Vec2 along_u = (1 - v) * (c[1] - c[0]) + v * (c[2] - c[3]),
               along_v = (1 - u) * (c[3] - c[0]) + u * (c[2] - c[1]);
    const double jacobian = cross(along_u, along_v);
    if (jacobian == 0)
        return Rgb::Zero();
    const double du = cross(direction, along_v) / jacobian, dv = cross(along_u, direction) / jacobian;
    const auto a = legendre(u), b = legendre(v), da = legendre_slopes(u), db = legendre_slopes(v);
    Rgb sum = Rgb::Zero();
    for (int i = 0, k = patch.first; i < patch.order; ++i)
        for (int j = 0; j < patch.order; ++j, ++k) {
            const auto m = static_cast<std::size_t>(i), n = static_cast<std::size_t>(j);
            sum += (da[m] * b[n] * du + a[m] * db[n] * dv) * snapshot.coefficients[static_cast<std::size_t>(k)];
        }
    return sum;
}

} // namespace penumbra
