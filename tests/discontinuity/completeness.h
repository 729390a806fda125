// Curves against changes of the visible part's shape, both ways (see visible_shape.h).
#pragma once

#include "visible_shape.h"

#include "discontinuity/curve.h"

#include <random>
#include <string>
#include <vector>

namespace penumbra {

struct Tally {
    int n_changes = 0, n_explained = 0; ///< of the shape, and of these within 1e-5 of a curve
    double length = 0, real_length = 0; ///< of curves, plane ones aside, and of these with a change across
    std::string first_unexplained, first_unreal;

    Tally &operator+=(const Tally &o);
};

/// The curves of one source on one receiver, and the reader of shapes to hold against them.
class CheckedPair {
public:
    CheckedPair(const Scene &scene, SurfaceId source, SurfaceId receiver);

    /// Every change of the shape along random segments should lie within 1e-5 of the receiver's size of a curve.
    void look_for_changes(int n_segments, std::mt19937 &random, Tally &tally) const;
    /// Of the curves' length, how much has different shapes on its two sides?
    void walk_curves(int n_per_curve, Tally &tally) const;

    std::vector<Curve> &curves() { return curves_; }

private:
    Vec2 random_point(std::mt19937 &random) const;
    std::string where(const Vec2 &x) const;
    void bisect(const Vec2 &a, const Vec2 &b, double t, double u, const VisibleShape &before, const VisibleShape &after,
                Tally &tally) const;

    const Scene &scene_;
    SurfaceId receiver_;
    ShapeReader reader_;
    std::vector<Curve> curves_;
    double size_;
};

/// Both checks for every emitter and every surface that reflects.
Tally check_scene(const Scene &scene, int n_segments, std::uint32_t seed = 1);

/// At least 99.5 % of the changes lie on a curve, and at least 99 % of the length has a change across it.
void expect_complete(const Tally &tally);

} // namespace penumbra
