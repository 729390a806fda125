// What tells weak sources: the largest form factor over an element, from a few points, against many.
#include "hierarchy/forest.h"
#include "scene/bundled.h"
#include "transport/interaction.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace penumbra {
namespace {

/// Whether any corner of one lies in front of the other: neighbours on a convex solid see each other by rounding alone.
bool in_front(const Surface &one, const Surface &other) {
    return std::ranges::any_of(one.corners, [&](const Vec3 &c) { return other.frame.height(c) > 1e-9; });
}

class FormFactorBounds : public testing::TestWithParam<const char *> {};

TEST_P(FormFactorBounds, MissNoPlaceWhereASmallSourceShinesOnALargeReceiver) {
    // Sources that bring less than a tenth of what the oracle lets pass are not tested: a factor of two in the bound does
    // no harm. A step's riser before a floor of twenty times its height is 0.5 at the step and 0.01 at the floor's corners.
    const Scene scene = open_scene(GetParam(), {});
    const Blockers blockers(scene);
    const Transport transport{scene, blockers};
    const Forest forest = plant(scene, 1);
    constexpr int n = 12;
    int n_pairs = 0;
    for (const Element &root : forest.elements)
        for (int s = 0; s < scene.n_surfaces(); ++s) {
            const Surface &receiver = scene.surface(root.surface), &source = scene.surface(SurfaceId(s));
            if (!scene.reflects(root.surface) || !in_front(receiver, source) || !in_front(source, receiver))
                continue;
            double most = 0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const double u = 1.0 * i / n, v = 1.0 * j / n, d = 1.0 / n;
                    const BilinearQuad &quad = *root.basis.quad();
                    Element cell = root;
                    cell.basis = ElementBasis(
                        1, BilinearQuad{{quad.at(u, v), quad.at(u + d, v), quad.at(u + d, v + d), quad.at(u, v + d)}});
                    most = std::max(most, form_factor_bound(transport, cell, SurfaceId(s)));
                }
            EXPECT_GE(form_factor_bound(transport, root, SurfaceId(s)), 0.5 * most - 1e-12)
                << scene.surface(root.surface).name << ' ' << root.surface.index << " from " << s;
            n_pairs += most > 0;
        }
    EXPECT_GT(n_pairs, 10);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FormFactorBounds, testing::Values("stairs", "table", "cornell-box", "next-room"));

} // namespace
} // namespace penumbra
