#include "completeness.h"

#include "discontinuity/trace_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace penumbra {

namespace {

std::string text(const VisibleShape &shape) {
    std::string all = "{";
    for (const std::string &corner : shape)
        all += corner + ", ";
    return all + "}";
}

} // namespace

Tally &Tally::operator+=(const Tally &o) {
    n_changes += o.n_changes;
    n_explained += o.n_explained;
    length += o.length;
    real_length += o.real_length;
    if (first_unexplained.empty())
        first_unexplained = o.first_unexplained;
    if (first_unreal.empty())
        first_unreal = o.first_unreal;
    return *this;
}

CheckedPair::CheckedPair(const Scene &scene, SurfaceId source, SurfaceId receiver)
    : scene_(scene), receiver_(receiver), reader_(scene, source, receiver),
      curves_(trace_curves(scene, source, receiver, possible_blockers(scene, source, receiver))),
      size_(2 * radius(scene.surface(receiver).outline)) {}

void CheckedPair::look_for_changes(int n_segments, std::mt19937 &random, Tally &tally) const {
    for (int i = 0; i < n_segments; ++i) {
        const Vec2 a = random_point(random), b = random_point(random);
        constexpr int n_steps = 60;
        VisibleShape before = reader_.at(a);
        for (int k = 0; k < n_steps; ++k) {
            const double t = k / double(n_steps), u = (k + 1) / double(n_steps);
            VisibleShape after = reader_.at(a + u * (b - a));
            bisect(a, b, t, u, before, after, tally);
            before = std::move(after);
        }
    }
}

void CheckedPair::walk_curves(int n_per_curve, Tally &tally) const {
    for (const Curve &c : curves_) {
        if (c.kind == CurveKind::plane)
            continue;
        for (int k = 0; k < n_per_curve; ++k) {
            const double t = (k + 0.5) / n_per_curve;
            const Vec2 x = point_at(c, t);
            const Vec2 along = point_at(c, t + 0.5 / n_per_curve) - point_at(c, t - 0.5 / n_per_curve);
            const Vec2 across = Vec2(-along.y(), along.x()).normalized();
            tally.length += along.norm();
            const VisibleShape left = reader_.at(x + 1e-6 * across), right = reader_.at(x - 1e-6 * across);
            if (left != right)
                tally.real_length += along.norm();
            else if (tally.first_unreal.empty())
                tally.first_unreal = std::string(name(c.kind)) + " at " + where(x) + " sees " + text(left);
        }
    }
}

Vec2 CheckedPair::random_point(std::mt19937 &random) const {
    const Polygon &outline = scene_.surface(receiver_).outline;
    Vec2 low = outline[0], high = outline[0];
    for (const Vec2 &p : outline) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    std::uniform_real_distribution<double> unit;
    const double u = unit(random), v = unit(random);
    return low + Vec2(u * (high - low).x(), v * (high - low).y());
}

std::string CheckedPair::where(const Vec2 &x) const {
    const Vec3 own = scene_.own.to_own(scene_.surface(receiver_).frame.to_space(x));
    return std::to_string(own.x()) + " " + std::to_string(own.y()) + " " + std::to_string(own.z());
}

void CheckedPair::bisect(const Vec2 &a, const Vec2 &b, double t, double u, const VisibleShape &before,
                         const VisibleShape &after, Tally &tally) const {
    if (before == after)
        return;
    if ((u - t) * (b - a).norm() < 1e-6 * size_) {
        const Vec2 x = a + (t + u) / 2 * (b - a);
        if (!reader_.on_receiver(a + t * (b - a)) || !reader_.on_receiver(a + u * (b - a)))
            return; // the receiver's own border
        ++tally.n_changes;
        if (std::ranges::any_of(curves_, [&](const Curve &c) { return distance(c, x) <= 1e-5 * size_; }))
            ++tally.n_explained;
        else if (tally.first_unexplained.empty())
            tally.first_unexplained = where(x) + ": " + text(before) + " to " + text(after);
        return;
    }
    const double middle = (t + u) / 2;
    const VisibleShape between = reader_.at(a + middle * (b - a));
    bisect(a, b, t, middle, before, between, tally);
    bisect(a, b, middle, u, between, after, tally);
}

Tally check_scene(const Scene &scene, int n_segments, std::uint32_t seed) {
    Tally tally;
    std::mt19937 random(seed);
    for (int r = 0; r < scene.n_surfaces(); ++r)
        for (int s = 0; s < scene.n_surfaces(); ++s)
            if (r != s && scene.emits(SurfaceId(s)) && scene.reflects(SurfaceId(r))) {
                const CheckedPair pair(scene, SurfaceId(s), SurfaceId(r));
                pair.look_for_changes(n_segments, random, tally);
                pair.walk_curves(24, tally);
            }
    return tally;
}

void expect_complete(const Tally &tally) {
    std::printf("%d of %d changes on a curve; change across %.4f of %.4f\n", tally.n_explained, tally.n_changes,
                tally.real_length, tally.length);
    EXPECT_GT(tally.n_changes, 0);
    if (!tally.first_unexplained.empty())
        std::printf("first unexplained: %s\n", tally.first_unexplained.c_str());
    EXPECT_GE(tally.n_explained, 0.995 * tally.n_changes) << tally.first_unexplained;
    EXPECT_GT(tally.length, 0);
    EXPECT_GE(tally.real_length, 0.99 * tally.length) << tally.first_unreal;
}

} // namespace penumbra
