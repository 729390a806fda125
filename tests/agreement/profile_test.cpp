// Radiosity along a line, against other ways to the same numbers.
#include "iteration/profile.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/direct.h"
#include "measure/leaf_at.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

namespace penumbra {

namespace {

class Profiles : public testing::TestWithParam<std::tuple<Strategy, BasisFamily>> {
protected:
    Profiles() : scene(std::make_shared<const Scene>(open_scene("slanted-edge"))) {
        Options options;
        options.strategy = std::get<0>(GetParam());
        options.basis = std::get<1>(GetParam());
        Solver solver(scene, options);
        solver.run();
        state = solver.state();
        snapshot = solver.snapshot();
        const auto lit = std::ranges::find_if(snapshot->surfaces,
                                              [](const SnapshotSurface &s) { return s.reflectance.maxCoeff() > 0; });
        const std::vector<Vec2> &o = lit->outline;
        const auto at = [&](const Vec2 &p) { return Vec3(lit->origin + p.x() * lit->u + p.y() * lit->v); };
        line = *line_over(*snapshot, at(0.93 * o[0] + 0.05 * o[1] + 0.02 * o[2]),
                          at(0.12 * o[0] + 0.08 * o[1] + 0.8 * o[2]), 1e-6);
    }
    Vec2 solver_point(double at) const {
        return to_plane(snapshot->surfaces[static_cast<std::size_t>(line.surface)], line.at(at)) / scene->own.size;
    }

    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const State> state;
    std::shared_ptr<const Snapshot> snapshot;
    ProfileLine line;
};

TEST_P(Profiles, PiecesTileTheLineAndHoldTheSolution) {
    const auto pieces = profile(*snapshot, line, 200);
    ASSERT_GT(pieces.size(), 1u);
    EXPECT_NEAR(pieces.back().high, line.length(), 1e-9 * line.length());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_NEAR(pieces[i].low, i > 0 ? pieces[i - 1].high : 0, 1e-9 * line.length());
        ASSERT_GE(pieces[i].points.size(), 2u);
        for (std::size_t k = 1; k + 1 < pieces[i].points.size(); ++k) {
            const ProfilePoint &p = pieces[i].points[k];
            const Rgb forest =
                radiosity_at(state->forest, state->radiosity, SurfaceId(line.surface), solver_point(p.at));
            EXPECT_LT((p.radiosity - forest).abs().maxCoeff(), 1e-9 * snapshot->peak);
        }
    }
}

TEST_P(Profiles, SlopesAreThePolynomialsOwn) {
    const SnapshotSurface &s = snapshot->surfaces[static_cast<std::size_t>(line.surface)];
    const double step = 1e-4 * line.length();
    for (const ProfilePiece &piece : profile(*snapshot, line, 50))
        for (const ProfilePoint &p : piece.points) {
            // Fourth order in the step, the patch's polynomial continued over its border.
            const auto b = [&](double d) {
                return radiosity(*snapshot, snapshot->patches[static_cast<std::size_t>(piece.patch)],
                                 to_plane(s, line.at(p.at + d)));
            };
            const double near = std::min(p.at - piece.low, piece.high - p.at);
            if (near < 2 * step && snapshot->options.basis == BasisFamily::parametric)
                continue; // parameters outside a quad may have no inverse
            const Rgb slope = (8 * (b(step) - b(-step)) - (b(2 * step) - b(-2 * step))) / (12 * step);
            EXPECT_LT((p.slope - slope).abs().maxCoeff(), 1e-5 * snapshot->peak / line.length())
                << piece.patch << " at " << p.at;
        }
}

TEST_P(Profiles, TheTrueOneIsTheExactDirectLight) {
    const Truth truth = truth_of(scene, std::make_shared<const Reference>(scene));
    const Blockers blockers(*scene);
    const std::vector<double> breaks{0.31 * line.length()};
    const auto points =
        true_profile(truth, snapshot->surfaces[static_cast<std::size_t>(line.surface)], line, 40, breaks);
    ASSERT_EQ(points.size(), 43u);
    EXPECT_EQ(points.front().at, 0);
    EXPECT_NEAR(points.back().at, line.length(), 1e-12);
    const auto exact = [&](double at) {
        return direct_radiosity(*scene, blockers, SurfaceId(line.surface), solver_point(at));
    };
    int smooth = 0;
    for (const ProfilePoint &p : points) {
        EXPECT_LT((p.radiosity - exact(p.at)).abs().maxCoeff(), 1e-9 * snapshot->peak);
        const double step = difference_step() * line.length();
        if (p.at < 2 * step || p.at > line.length() - 2 * step)
            continue;
        const Rgb outer = (exact(p.at + step) - exact(p.at - step)) / (2 * step);
        const Rgb inner = (exact(p.at + step / 2) - exact(p.at - step / 2)) / step;
        EXPECT_LT((p.slope - outer).abs().maxCoeff(), 1e-6 * snapshot->peak / line.length());
        smooth += (inner - outer).abs().maxCoeff() < 1e-3 * outer.abs().maxCoeff();
    }
    EXPECT_GT(smooth, 20) << "away from kinks the step is short enough";
}

TEST(ProfileLines, LieOnASurfaceOrAreNone) {
    const auto scene = std::make_shared<const Scene>(open_scene("cornell-box"));
    const auto snapshot = Solver(scene, Options{}).snapshot();
    double size = 0;
    for (const SnapshotSurface &s : snapshot->surfaces)
        for (const Vec2 &p : s.outline)
            size = std::max(size, p.norm());
    for (std::size_t i = 0; i < snapshot->surfaces.size(); ++i) {
        const SnapshotSurface &s = snapshot->surfaces[i];
        const auto at = [&](double t) {
            const Vec2 c = centroid(s.outline), p = c + t * (s.outline[0] - c);
            return Vec3(s.origin + p.x() * s.u + p.y() * s.v);
        };
        const auto line = line_over(*snapshot, at(0.1), at(0.5), 1e-6 * size);
        if (s.reflectance.maxCoeff() <= 0) {
            EXPECT_FALSE(line);
            continue;
        }
        ASSERT_TRUE(line) << i;
        EXPECT_EQ(line->surface, static_cast<int>(i));
        EXPECT_FALSE(line_over(*snapshot, at(0.1), at(0.1), 1e-6 * size)) << "no way";
        EXPECT_FALSE(line_over(*snapshot, at(0.1), at(0.5) + 0.1 * size * s.normal, 1e-6 * size)) << "in the air";
    }
}

INSTANTIATE_TEST_SUITE_P(All, Profiles,
                         testing::Combine(testing::ValuesIn(all_strategies),
                                          testing::Values(BasisFamily::parametric, BasisFamily::planar)));

} // namespace

} // namespace penumbra
