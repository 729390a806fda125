// Maps of the error against the exact direct light, by code that the maps do not use.
#include "core/random.h"
#include "iteration/error_map.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/direct.h"
#include "measure/leaf_at.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <atomic>

#include <cmath>
#include <random>

namespace penumbra {

namespace {

struct Solved {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const State> state;
    std::shared_ptr<const Snapshot> snapshot;
    std::shared_ptr<const ErrorMap> map;
    Blockers blockers;

    Solved(const char *name, const Options &options)
        : scene(std::make_shared<const Scene>(open_scene(name))), blockers(*scene) {
        Solver solver(scene, options);
        solver.run();
        state = solver.state();
        snapshot = solver.snapshot(true);
        const Truth truth = truth_of(scene, std::make_shared<const Reference>(scene));
        map = ErrorMapper(truth).map(*snapshot);
    }
    /// B_h - B down the forest, in solver coordinates.
    Rgb missed(int surface, const Vec2 &own) const {
        const Vec2 p = own / scene->own.size;
        return radiosity_at(state->forest, state->radiosity, SurfaceId(surface), p) -
               direct_radiosity(*scene, blockers, SurfaceId(surface), p);
    }
};

Options options_of(Strategy strategy, BasisFamily basis) {
    Options o;
    o.strategy = strategy;
    o.basis = basis;
    return o;
}

/// What the picture interpolates between the lattice's points, at parameters of a cell.
Rgb between(const PatchError &error, std::size_t tile, std::size_t row, std::size_t column, double s, double t) {
    const std::size_t side = static_cast<std::size_t>(error.n) + 2;
    const auto at = [&](std::size_t r, std::size_t c) { return error.missed[tile * side * side + r * side + c]; };
    return (1 - s) * (1 - t) * at(row, column) + s * (1 - t) * at(row, column + 1) + (1 - s) * t * at(row + 1, column) +
           s * t * at(row + 1, column + 1);
}

class ErrorMaps : public testing::TestWithParam<std::tuple<const char *, Strategy, BasisFamily>> {};

TEST_P(ErrorMaps, SquaresOfThePatchesAddUpToTheSnapshotsError) {
    const auto [name, strategy, basis] = GetParam();
    const Solved s(name, options_of(strategy, basis));
    ASSERT_GT(s.snapshot->error, 0);
    double sum = 0;
    for (std::size_t i = 0; i < s.map->patches.size(); ++i)
        sum += s.map->share(i) * s.map->share(i);
    // Both take Gauss points, other ones unless the patch is small.
    EXPECT_NEAR(std::sqrt(sum), s.snapshot->error, 0.02 * s.snapshot->error);
    EXPECT_EQ(s.map->truth_error, 0);
    EXPECT_EQ(s.map->version, s.snapshot->version);
}

TEST_P(ErrorMaps, LatticesHoldTheExactError) {
    const auto [name, strategy, basis] = GetParam();
    const Solved s(name, options_of(strategy, basis));
    std::mt19937_64 random(7);
    int compared = 0;
    for (std::size_t i = 0; i < s.map->patches.size(); ++i) {
        const PatchError &e = s.map->patches[i];
        const SnapshotPatch &patch = s.snapshot->patches[i];
        if (e.n == 0)
            continue;
        const std::size_t side = static_cast<std::size_t>(e.n) + 2;
        ASSERT_EQ(e.points.size(), tiles(patch).size() * side * side);
        for (int k = 0; k < 4; ++k) { // cells' middles: on borders the forest may see the neighbour
            const std::size_t tile = random() % tiles(patch).size();
            const auto stop = [&] { return 1 + random() % static_cast<std::size_t>(e.n); };
            const std::size_t row = stop(), column = stop();
            const std::size_t at = (tile * side + row) * side + column;
            if (is_covered(s.snapshot->surfaces[static_cast<std::size_t>(patch.surface)], e.points[at]))
                continue;
            ++compared;
            EXPECT_LT((e.missed[at] - s.missed(patch.surface, e.points[at])).abs().maxCoeff(), 1e-8 * s.map->peak);
        }
    }
    EXPECT_GE(compared, 4);
}

TEST_P(ErrorMaps, BetweenThemThePictureIsRight) {
    const auto [name, strategy, basis] = GetParam();
    const Solved s(name, options_of(strategy, basis));
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform;
    double off = 0, whole = 0;
    for (std::size_t i = 0; i < s.map->patches.size(); ++i) {
        const PatchError &e = s.map->patches[i];
        const SnapshotPatch &patch = s.snapshot->patches[i];
        if (e.n == 0)
            continue;
        const std::vector<BilinearQuad> quads = tiles(patch);
        for (std::size_t tile = 0; tile < quads.size(); ++tile)
            for (int k = 0; k < 40; ++k) {
                const auto cell = [&] { return 1 + random() % static_cast<std::size_t>(e.n - 1); };
                const std::size_t row = cell(), column = cell();
                const double a = uniform(random), b = uniform(random);
                const std::size_t side = static_cast<std::size_t>(e.n) + 2,
                                  corner = (tile * side + row) * side + column;
                const auto along = [&](std::size_t step) { return quads[tile].inverse(e.points[corner + step]); };
                const double u = (1 - a) * along(0).x() + a * along(1).x(),
                             v = (1 - b) * along(0).y() + b * along(side).y();
                const Rgb exact = s.missed(patch.surface, quads[tile].at(u, v));
                const double weight = quads[tile].jacobian(u, v);
                off += weight * (between(e, tile, row, column, a, b) - exact).square().sum();
                whole += weight * exact.square().sum();
            }
    }
    EXPECT_LT(std::sqrt(off / whole), 0.2);
    RecordProperty("off", std::to_string(std::sqrt(off / whole)));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ErrorMaps,
                         testing::Combine(testing::Values("slanted-edge", "figure-4"),
                                          testing::ValuesIn(all_strategies),
                                          testing::Values(BasisFamily::parametric, BasisFamily::planar)),
                         [](const auto &param_info) {
                             std::string n = std::get<0>(param_info.param) + std::string("_") +
                                             std::string(name(std::get<1>(param_info.param))) + "_" +
                                             std::string(name(std::get<2>(param_info.param)));
                             std::ranges::replace(n, '-', '_');
                             return n;
                         });

TEST(ErrorMap, AFieldThatIsOffByAConstantMissesThatConstant) {
    // B_h = B + 0.25 everywhere: no other number than 0.25 may come out, and the square is 3 * 0.25^2 times the area.
    const auto scene = std::make_shared<const Scene>(open_scene("slanted-edge"));
    const auto snapshot = Solver(scene, options_of(Strategy::uniform_constant, BasisFamily::parametric)).snapshot();
    const Truth truth{[&](int surface, const Vec2 &) -> Rgb { // B_h at the start is the exitance
                          return snapshot->surfaces[static_cast<std::size_t>(surface)].exitance - 0.25;
                      },
                      0.01};
    const auto map = ErrorMapper(truth, {8, 1, 1}).map(*snapshot);
    double area_of_reflectors = 0;
    for (std::size_t i = 0; i < map->patches.size(); ++i) {
        const SnapshotSurface &surface = snapshot->surfaces[static_cast<std::size_t>(snapshot->patches[i].surface)];
        if (surface.reflectance.maxCoeff() <= 0) {
            EXPECT_EQ(map->patches[i].n, 0);
            continue;
        }
        const double a = area(snapshot->patches[i].corners);
        area_of_reflectors += a;
        EXPECT_NEAR(map->patches[i].square, 3 * 0.25 * 0.25 * a, 1e-12 * a);
        for (const Rgb &m : map->patches[i].missed)
            EXPECT_TRUE((m == Rgb::Constant(0.25)).all());
    }
    EXPECT_NEAR(map->reflected, 3 * 0.25 * 0.25 * area_of_reflectors, 1e-12);
    EXPECT_NEAR(map->error(), 1, 1e-12);
    EXPECT_EQ(map->truth_error, 0.01);
}

TEST(ErrorMap, AsksForAPointOfASharedPatchOnce) {
    const auto scene = std::make_shared<const Scene>(open_scene("slanted-edge"));
    Solver solver(scene, options_of(Strategy::uniform_constant, BasisFamily::parametric));
    std::atomic<int> asked{0};
    const Truth exact = truth_of(scene, std::make_shared<const Reference>(scene));
    ErrorMapper mapper({[&](int surface, const Vec2 &p) {
                            ++asked;
                            return exact.radiosity_at(surface, p);
                        },
                        0},
                       {16, 2, 2});
    const auto first = mapper.map(*solver.snapshot());
    const int n = asked;
    EXPECT_GT(n, 0);
    solver.sub_step(); // links alone, or a split: coefficients stay
    solver.sub_step();
    const auto same = mapper.map(*solver.snapshot());
    const auto again = mapper.map(*solver.snapshot());
    EXPECT_EQ(again->error(), same->error());
    const int before = asked;
    mapper.map(*solver.snapshot());
    EXPECT_EQ(asked, before);
}

TEST(ErrorMap, CanBeCancelled) {
    const auto scene = std::make_shared<const Scene>(open_scene("slanted-edge"));
    const auto snapshot = Solver(scene, Options{}).snapshot();
    Cancel cancel;
    cancel.raise();
    ErrorMapper mapper(truth_of(scene, std::make_shared<const Reference>(scene)));
    EXPECT_THROW(mapper.map(*snapshot, &cancel), Cancelled);
}

TEST(OraclesShare, IsOfTheSizeOfTheTrueError) {
    // The oracle's points are denser where shadows fall, so that it sees more than there is, but not by an order.
    for (const Strategy strategy : all_strategies) {
        const Solved s("slanted-edge", options_of(strategy, BasisFamily::parametric));
        double estimated = 0, true_square = 0;
        for (std::size_t i = 0; i < s.map->patches.size(); ++i)
            if (s.map->patches[i].n > 0) {
                if (s.snapshot->patches[i].estimate < 0) { // nothing was tested there: nothing arrives
                    EXPECT_EQ(s.map->patches[i].square, 0);
                    continue;
                }
                estimated += s.snapshot->patches[i].estimate * s.snapshot->patches[i].estimate;
                true_square += s.map->patches[i].square;
            }
        const double ratio = std::sqrt(true_square / estimated);
        EXPECT_GT(ratio, 0.2) << name(strategy);
        EXPECT_LT(ratio, 2) << name(strategy);
    }
}

/// A solution with its own way of finding the element that holds a point.
struct Plain {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const State> state;
    std::shared_ptr<const Snapshot> snapshot;

    explicit Plain(Strategy strategy) : scene(std::make_shared<const Scene>(open_scene("slanted-edge"))) {
        Options o = options_of(strategy, BasisFamily::parametric);
        o.threshold = 0.05;
        Solver solver(scene, o);
        solver.run();
        state = solver.state();
        snapshot = solver.snapshot(false);
    }
    Rgb at(int surface, const Vec2 &own) const {
        return radiosity_at(state->forest, state->radiosity, SurfaceId(surface), own / scene->own.size);
    }
};

TEST(Differences, AreTheSecondSolutionMinusTheFirstAtEveryPoint) {
    const Plain first(Strategy::uniform_constant), second(Strategy::discontinuity_wavelet);
    const auto map = ErrorMapper(truth_in(first.snapshot)).map(*second.snapshot);
    EXPECT_EQ(map->version, second.snapshot->version);
    EXPECT_EQ(map->against, first.snapshot->version);
    EXPECT_FALSE(map->change.has_value());
    double worst = 0, largest = 0;
    int compared = 0;
    for (std::size_t i = 0; i < map->patches.size(); ++i) {
        const PatchError &error = map->patches[i];
        const std::size_t side = static_cast<std::size_t>(error.n) + 2;
        for (std::size_t at = 0; at < error.missed.size(); ++at) {
            const std::size_t row = at / side % side, column = at % side;
            if (row == 0 || column == 0 || row == side - 1 || column == side - 1)
                continue; // on a side either of two patches may be asked
            const int surface = second.snapshot->patches[i].surface;
            const Rgb expected = second.at(surface, error.points[at]) - first.at(surface, error.points[at]);
            worst = std::max(worst, (error.missed[at] - expected).abs().maxCoeff());
            largest = std::max(largest, expected.abs().maxCoeff());
            ++compared;
        }
    }
    EXPECT_GT(compared, 5000);
    EXPECT_GT(largest, 0.01 * second.snapshot->peak);
    EXPECT_LT(worst, 1e-9 * second.snapshot->peak);
}

TEST(Differences, AreAsLargeTheOtherWayRoundAndNothingFromThemselves) {
    const Plain first(Strategy::uniform_constant), second(Strategy::discontinuity_wavelet);
    const double there = ErrorMapper(truth_in(first.snapshot)).map(*second.snapshot)->error(),
                 back = ErrorMapper(truth_in(second.snapshot)).map(*first.snapshot)->error();
    EXPECT_GT(there, 1e-4);
    EXPECT_NEAR(there, back, 0.05 * back); // by the quadrature of two meshes
    EXPECT_LT(ErrorMapper(truth_in(first.snapshot)).map(*first.snapshot)->error(), 1e-12);
}

} // namespace

} // namespace penumbra
