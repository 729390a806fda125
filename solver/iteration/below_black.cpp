#include "iteration/below_black.h"

#include <algorithm>

namespace penumbra {

Darkness below_black(const Scene &scene, const Element &leaf, const Coefficients &radiosity, double aim) {
    constexpr int n = 6;
    const auto b = rows(leaf, radiosity);
    const Rgb mean = b.row(0).transpose().array().max(0);
    Darkness out;
    for (const BilinearQuad &tile : leaf.basis.tiles())
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) {
                const Vec2 p = tile.at(static_cast<double>(i) / n, static_cast<double>(j) / n);
                const Rgb value = (leaf.basis.evaluate(p).transpose() * b).transpose().array();
                if (value.minCoeff() >= -aim || is_covered(scene.surface(leaf.surface), p))
                    continue;
                if (-value.minCoeff() > out.depth) {
                    out.depth = -value.minCoeff();
                    out.at = p;
                }
                out.damping = std::min(out.damping, ((mean + aim) / (mean - value).max(mean + aim)).minCoeff());
            }
    return out;
}

} // namespace penumbra
