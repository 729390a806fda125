// The exact visible part, and the direct solution made of it, against stratified points of the source with own rays.
#include "reference/faces.h"
#include "reference/rays.h"

#include "measure/direct.h"
#include "scene/bundled.h"
#include "visibility/visible_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

using reference::Face;

struct Sampled {
    double area = 0, form_factor = 0; ///< of what is seen, from a point with its surface's normal
};

/// One random point in each of n x n cells of the source's bounding box: the error falls as n^(-3/2).
Sampled sampled(const Scene &scene, SurfaceId source, const Vec3 &x, const Vec3 &normal, int n, unsigned seed) {
    const Surface &s = scene.surface(source);
    Vec2 low = s.outline[0], high = low;
    for (const Vec2 &p : s.outline) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform;
    const double cell = (high.x() - low.x()) * (high.y() - low.y()) / (static_cast<double>(n) * n);
    Sampled out;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec2 p = low + (high - low).cwiseProduct(Vec2((i + uniform(random)) / n, (j + uniform(random)) / n));
            if (!reference::inside(s.outline, p) || reference::covered(s, p))
                continue;
            const Vec3 y = s.frame.to_space(p), d = y - x;
            const double here = normal.dot(d), there = -s.frame.normal.dot(d), r2 = d.squaredNorm();
            if (here <= 0 || there <= 0 || !reference::sees(scene, x, y))
                continue;
            out.area += cell;
            out.form_factor += cell * here * there / (std::numbers::pi * r2 * r2);
        }
    return out;
}

Face floor_face() { return {{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}}; }
Face lamp(std::vector<Vec2> outline, double z) {
    Face face{{}, Rgb::Zero(), Rgb::Ones()};
    for (const Vec2 &p : outline)
        face.corners.emplace_back(p.x(), -p.y(), z); // mirrored: it looks down
    return face;
}
const std::vector<Vec2> square_lamp{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
const std::vector<Vec2> star_lamp{{-0.6, -0.6}, {0, -0.2}, {0.6, -0.6}, {0.2, 0}, {0.6, 0.6}, {0, 0.2}, {-0.6, 0.6}, {-0.2, 0}};
Face black(std::vector<Vec3> corners) { return {std::move(corners), Rgb::Zero()}; }

struct Case {
    const char *name;
    std::vector<Face> faces; ///< 0: the receiver, 1: the source
};

std::vector<Case> cases() {
    const Face skew_1 = black({{-0.75, -0.35, 0.55}, {0.6, -0.1, 0.85}, {0.4, 0.45, 1}, {-0.95, 0.2, 0.7}});
    const Face skew_2 = black({{0.3, -0.9, 1.5}, {0.5, 0.7, 1.15}, {0, 0.8, 1.4}, {-0.2, -0.8, 1.75}});
    const Face concave = black({{-0.5, -0.5, 1}, {0.7, -0.5, 1}, {0.7, 0.6, 1}, {0.1, 0, 1}, {-0.5, 0.6, 1}});
    Case boxes{"two boxes, one on the floor", {floor_face(), lamp(square_lamp, 2)}};
    for (const auto &b : {reference::box({0.2, 0.1, 0}, {0.4, 0.2, 0}, {-0.2, 0.4, 0}, {0, 0, 0.7}, Rgb::Constant(0.3)),
                          reference::box({-0.6, -0.3, 0.9}, {0.5, 0, 0.1}, {0, 0.4, 0.1}, {-0.1, -0.1, 0.3}, Rgb::Zero())})
        boxes.faces.insert(boxes.faces.end(), b.begin(), b.end());
    return {{"none", {floor_face(), lamp(square_lamp, 2)}},
            {"one", {floor_face(), lamp(square_lamp, 2), skew_1}},
            {"two skew", {floor_face(), lamp(square_lamp, 2), skew_1, skew_2}},
            {"concave blocker", {floor_face(), lamp(square_lamp, 2), concave}},
            {"concave source", {floor_face(), lamp(star_lamp, 2), skew_1, skew_2}},
            {"concave both", {floor_face(), lamp(star_lamp, 2), concave, skew_2}},
            {"through the lamp's plane", {floor_face(), lamp(square_lamp, 2), black({{-0.2, -1, 1.2}, {0.3, 1, 1.2}, {0.2, 1, 2.5}, {-0.3, -1, 2.5}})}},
            boxes};
}

TEST(VisiblePart, AgainstStratifiedPointsAndOwnRays) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    constexpr int n = 160;
    for (const Case &c : cases()) {
        const auto scene = reference::scene_of(c.faces);
        const Blockers blockers(*scene);
        const Surface &receiver = scene->surfaces[0], &source = scene->surfaces[1];
        ConvexPieces whole;
        for (const Polygon &part : source.parts)
            whole.add(part);
        int n_partly = 0;
        for (int k = 0; k < 12; ++k) {
            const Vec3 x = scene->own.to_solver(Vec3(1.2 * uniform(random), 1.2 * uniform(random), 0));
            std::vector<PairBlocker> pair;
            for (std::size_t b = 0; b < blockers.all().size(); ++b)
                if (blockers.all()[b].surface.index > 1)
                    pair.push_back({static_cast<int>(b), false});
            VisibleScratch scratch;
            Work work;
            scratch.hidden.cast(x, source.frame, blockers, pair, work);
            visible_part(x, receiver.frame.normal, source.frame, whole, scratch.hidden, scratch);
            const double expected = sampled(*scene, SurfaceId(1), x, receiver.frame.normal, n, 11).area;
            EXPECT_NEAR(scratch.pieces.area() / source.area, expected / source.area, 3e-3) << c.name << " at " << x.transpose();
            n_partly += expected > 0 && expected < 0.99 * source.area;
        }
        EXPECT_GE(n_partly, c.faces.size() > 2 ? 2 : 0) << c.name;
    }
}

TEST(DirectRadiosity, AgainstStratifiedPointsAndOwnRays) {
    for (const char *name : {"slanted-edge", "skew-blockers", "box-on-floor", "stairs", "cornell-box", "figure-4"}) {
        const Scene scene = open_scene(name);
        const Blockers blockers(scene);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> uniform;
        for (int s = 0; s < scene.n_surfaces(); ++s) {
            if (!scene.reflects(SurfaceId(s)))
                continue;
            const Surface &surface = scene.surface(SurfaceId(s));
            Vec2 low = surface.outline[0], high = low;
            for (const Vec2 &p : surface.outline) {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            for (int k = 0; k < 6; ++k) {
                const Vec2 p = low + (high - low).cwiseProduct(Vec2(uniform(random), uniform(random)));
                if (!reference::inside(surface.outline, p) || reference::covered(surface, p))
                    continue;
                Rgb expected = Rgb::Zero();
                for (int q = 0; q < scene.n_surfaces(); ++q)
                    if (q != s && scene.emits(SurfaceId(q))) {
                        const Sampled part =
                            sampled(scene, SurfaceId(q), surface.frame.to_space(p), surface.frame.normal, 100, 17);
                        expected += scene.exitance(SurfaceId(q)) * part.form_factor;
                    }
                expected = scene.exitance(SurfaceId(s)) + scene.reflectance(SurfaceId(s)) * expected;
                const Rgb ours = direct_radiosity(scene, blockers, SurfaceId(s), p);
                EXPECT_LT((ours - expected).abs().maxCoeff(), 0.01 * expected.maxCoeff() + 1e-4) << name << ", surface " << s;
            }
        }
    }
}

} // namespace
} // namespace penumbra
