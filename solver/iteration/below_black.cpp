#include "iteration/below_black.h"

#include <algorithm>
#include <limits>

namespace penumbra {

namespace {

/// The least and the most that were seen of a tile, and where the least was, in the tile's unit square.
struct Seen {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    Vec2 at = Vec2::Zero();
};

/// Looks at points of a leaf and keeps what was darkest.
class Look {
public:
    Look(const Scene &scene, const Element &leaf, const Coefficients &radiosity, double aim)
        : surface_(scene.surface(leaf.surface)), leaf_(leaf), b_(rows(leaf, radiosity)),
          mean_(b_.row(0).transpose().array().max(0)), aim_(aim) {}

    void at(const BilinearQuad &tile, const Vec2 &unit, Seen &seen) {
        const Vec2 p = tile.at(unit.x(), unit.y());
        const Rgb value = (leaf_.basis.evaluate(p).transpose() * b_).transpose().array();
        const double least = value.minCoeff();
        seen.most = std::max(seen.most, value.maxCoeff());
        if (least < -aim_) {
            if (is_covered(surface_, p))
                return;
            if (-least > found.depth) {
                found.depth = -least;
                found.at = p;
            }
            found.damping = std::min(found.damping, ((mean_ + aim_) / (mean_ - value).max(mean_ + aim_)).minCoeff());
        }
        if (least < seen.least) {
            seen.least = least;
            seen.at = unit;
        }
    }

    void grid(const BilinearQuad &tile, int n, Seen &seen) {
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j)
                at(tile, {static_cast<double>(i) / n, static_cast<double>(j) / n}, seen);
    }

    /// From the darkest point on, to neighbours while these are darker, by steps that halve.
    void descend(const BilinearQuad &tile, double step, Seen &seen) {
        for (; step > 1e-3; step /= 2)
            for (double before = std::numeric_limits<double>::infinity(); seen.least < before;) {
                before = seen.least;
                const Vec2 here = seen.at;
                for (const Vec2 &way : {Vec2(step, 0), Vec2(-step, 0), Vec2(0, step), Vec2(0, -step)})
                    at(tile, (here + way).cwiseMax(0).cwiseMin(1), seen);
            }
    }

    Darkness found;

private:
    const Surface &surface_;
    const Element &leaf_;
    Coefficients::ConstRowsBlockXpr b_;
    Rgb mean_;
    double aim_;
};

} // namespace

Darkness below_black(const Scene &scene, const Element &leaf, const Coefficients &radiosity, double aim) {
    Look look(scene, leaf, radiosity, aim);
    for (const BilinearQuad &tile : leaf.basis.tiles()) {
        Seen seen;
        look.grid(tile, 6, seen);
        // Between these points a polynomial of degree 3 falls by about a quarter of its range.
        if (seen.least - 0.25 * (seen.most - seen.least) >= -aim)
            continue;
        look.grid(tile, 12, seen);
        look.descend(tile, 1.0 / 24, seen);
    }
    return look.found;
}

} // namespace penumbra
