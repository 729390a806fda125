// What is left out because a scene does not call for it: nothing that would be seen.
#include "iteration/error_map.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "measure/leaf_at.h"
#include "measure/residual.h"
#include "reference/faces.h"
#include "scene/bundled.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace penumbra {
namespace {

using testing::UnorderedElementsAreArray;

EffectSwitches all(Switch value) {
    EffectSwitches switches;
    for (const Effect e : all_effects)
        switches[e] = value;
    return switches;
}

std::unique_ptr<Solver> solved(const std::shared_ptr<const Scene> &scene, Options options, const EffectSwitches &effects) {
    options.effects = effects;
    auto solver = std::make_unique<Solver>(scene, options);
    EXPECT_TRUE(solver->run()) << scene->name;
    return solver;
}

/// ||a - b|| / ||a|| of B - E over the reflecting surfaces, at random points.
double difference(const Solver &a, const Solver &b) {
    const State &one = *a.state(), &other = *b.state();
    ResidualSampling sampling;
    sampling.n_batches = 16;
    double apart = 0, whole = 0;
    for (const auto &batch : draw_points(a.scene(), {one.forest, one.radiosity}, sampling))
        for (const ResidualPoint &p : batch) {
            const Rgb first = radiosity_at(one.forest, one.radiosity, p.surface, p.at) - a.scene().exitance(p.surface);
            const Rgb second = radiosity_at(other.forest, other.radiosity, p.surface, p.at) - a.scene().exitance(p.surface);
            apart += p.area * (first - second).square().sum();
            whole += p.area * first.square().sum();
        }
    return whole > 0 ? std::sqrt(apart / whole) : std::sqrt(apart);
}

std::vector<LedgerEntry> entries(const Solver &solver) { return solver.snapshot()->effects; }

std::set<std::string> called_for(const Solver &solver) {
    std::set<std::string> out;
    for (const LedgerEntry &e : entries(solver)) {
        EXPECT_FALSE(e.reason.empty()) << name(e.effect);
        if (e.decision != Decision::off)
            out.emplace(name(e.effect));
    }
    return out;
}

struct Lesson {
    const char *scene;
    std::set<std::string> calls_for; ///< besides, everything is off
    std::function<bool(const Counters &)> left_undone;
};

class TeachingScenes : public testing::TestWithParam<Lesson> {};

// Any light has to be emitted and fitted: "emission" and, but for a wall so far that constants do, "order".
TEST_P(TeachingScenes, CallForOneEffectAndTheRestIsNotDone) {
    const Lesson &lesson = GetParam();
    const auto scene = std::make_shared<const Scene>(open_scene(lesson.scene));
    const Options options = Options().to_tolerance(0.01);
    const auto plain = solved(scene, options, {}), whole = solved(scene, options, all(Switch::on));
    EXPECT_EQ(called_for(*plain), lesson.calls_for);
    const Counters &c = plain->counters();
    EXPECT_TRUE(lesson.left_undone(c));
    EXPECT_EQ(c.total_work.traced_reflectors, 0);
    EXPECT_EQ(c.total_work.rays, 0);
    EXPECT_EQ(c.channels, 1);
    const Work &done = whole->counters().total_work;
    EXPECT_EQ(whole->counters().channels, 3);
    EXPECT_GT(done.traced_pairs + done.pairs, c.total_work.traced_pairs + c.total_work.pairs);
    EXPECT_LT(difference(*whole, *plain), 0.01);
}

bool nothing_between(const Counters &c) { return c.total_work.clips == 0 && c.total_work.traced_pairs == 0 && c.curves == 0; }

INSTANTIATE_TEST_SUITE_P(
    Lessons, TeachingScenes,
    testing::Values(Lesson{"one-bounce", {"emission", "order"}, [](const Counters &c) { return nothing_between(c) && c.total_work.pairs == 1; }},
                    Lesson{"no-blockers", {"emission", "order", "interreflection"}, nothing_between},
                    Lesson{"grey", {"emission", "order", "visibility", "discontinuities.ve-ev"},
                           [](const Counters &c) { return c.total_work.traced_pairs == 1; }},
                    Lesson{"two-rooms", {"emission", "order", "hidden-pairs"},
                           [](const Counters &c) { return nothing_between(c) && c.total_work.pairs == 4; }},
                    Lesson{"far-wall", {"emission"},
                           [](const Counters &c) { return nothing_between(c) && c.links == 1 && c.link_coefficients == 1; }},
                    Lesson{"mirror-twins", {"emission", "order", "two-sided"}, nothing_between},
                    Lesson{"dark", {}, [](const Counters &c) {
                               return nothing_between(c) && c.links == 0 && c.total_work.kernel_evaluations == 0 &&
                                      c.total_work.pairs == 0;
                           }}),
    [](const auto &lesson) {
        std::string name = lesson.param.scene;
        std::ranges::replace(name, '-', '_');
        return name;
    });

TEST(TeachingScenes, TheFarWallsOtherEffectsAreNotBoughtByAWrongAnswer) {
    // A lamp of exitance E that is seen under a small angle: B = rho E cos cos' A / (pi d^2); here 20 m away, 1 m2.
    const auto scene = std::make_shared<const Scene>(open_scene("far-wall"));
    const auto solver = solved(scene, Options().to_tolerance(0.01), {});
    const State &state = *solver->state();
    const double b = radiosity_at(state.forest, state.radiosity, SurfaceId(0), Vec2::Zero())[0];
    EXPECT_NEAR(b, 0.6 * 100 / (std::acos(-1) * 400), 0.01 * b);
}

std::int64_t done(const Counters &c, Effect effect) {
    const std::map<std::string_view, std::int64_t> of{{"pairs", c.total_work.pairs},
                                                      {"links", c.links},
                                                      {"clips", c.total_work.clips},
                                                      {"traced_pairs", c.total_work.traced_pairs},
                                                      {"products", c.total_work.products},
                                                      {"link_coefficients", c.link_coefficients}};
    return of.at(unit(effect));
}

class SavedWork : public testing::TestWithParam<std::string> {};

TEST_P(SavedWork, IsWhatTheEffectsSwitchAdds) {
    const auto scene = std::make_shared<const Scene>(open_scene(GetParam()));
    Options options = Options().to_threshold(0.02);
    const auto plain = solved(scene, options, {});
    int n_saving = 0;
    for (const LedgerEntry &e : entries(*plain)) {
        // What reflectors' curves there would be is not known before the links that would ask for them.
        if (e.effect == Effect::curves_secondary)
            continue;
        EffectSwitches switches;
        switches[e.effect] = Switch::on;
        const auto added = done(solved(scene, options, switches)->counters(), e.effect) - done(plain->counters(), e.effect);
        EXPECT_LE(std::abs(e.saved - added), 0.2 * std::abs(added)) << name(e.effect) << " " << e.saved << " " << added;
        n_saving += e.saved > 0;
    }
    const bool rich = std::set<std::string>{"cornell-box", "table", "pierced"}.contains(GetParam());
    const bool dark = plain->counters().links == 0; // each of two effects leaves out all: one of them on changes nothing
    EXPECT_GE(n_saving, rich ? 4 : dark ? 0 : 1);
}

/// But for office, whose twelve solutions take minutes.
std::vector<std::string> small_scenes() {
    std::vector<std::string> names;
    for (const BundledScene &scene : bundled_scenes())
        if (scene.name != "office")
            names.emplace_back(scene.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SavedWork, testing::ValuesIn(small_scenes()),
                         [](const auto &scene) {
                             std::string name = scene.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(Effects, OffLeavesOutWhatItSays) {
    const auto scene = std::make_shared<const Scene>(open_scene("cornell-box"));
    const Options options = Options().to_threshold(0.05);
    const auto whole = solved(scene, options, {});
    const auto without = [&](std::string_view effect) {
        EffectSwitches switches;
        for (const Effect e : effects_from_name(effect))
            switches[e] = Switch::off;
        return solved(scene, options, switches);
    };
    EXPECT_EQ(without("emission")->counters().links, 0);
    const auto no_shadows = without("visibility");
    EXPECT_EQ(no_shadows->counters().total_work.clips, 0);
    EXPECT_GT(difference(*whole, *no_shadows), 0.1);
    const auto direct = without("interreflection");
    for (const auto &here : direct->state()->interactions)
        for (const auto &interaction : here)
            EXPECT_TRUE(scene->emits(interaction->source));
    EXPECT_GT(difference(*whole, *direct), 0.1);
    EXPECT_EQ(without("discontinuities")->counters().curves, 0);
    const auto constant = without("order");
    EXPECT_EQ(constant->counters().coefficients, constant->counters().patches);
    const auto grey = without("colour");
    EXPECT_EQ(grey->counters().channels, 1);
    const State &state = *grey->state();
    EXPECT_LT((state.radiosity.col(0) - state.radiosity.col(2)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Effects, ChangesAreMapped) {
    const auto scene = std::make_shared<const Scene>(open_scene("cornell-box"));
    const Options options = Options().to_threshold(0.05);
    const auto whole = solved(scene, options, {});
    const EffectChange change{Effect::visibility, Switch::off};
    EffectSwitches switches;
    switches[change.effect] = change.to;
    const auto other = solved(scene, options, switches);
    const auto map = ErrorMapper(with_change(scene, options, change)).map(*whole->snapshot());
    EXPECT_EQ(map->change, change);
    // Without shadows it is brighter: that is what the map's shares are of.
    EXPECT_NEAR(map->error(), difference(*other, *whole), 0.05 * map->error());
    const auto same = ErrorMapper(with_change(scene, options, {Effect::two_sided, Switch::on})).map(*whole->snapshot());
    EXPECT_LT(same->error(), 1e-9);
    EXPECT_GT(same->reflected, 0);
}

/// A floor and a wall that meet, and a lamp above them.
std::vector<reference::Face> corner(double rho) {
    return {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Rgb::Constant(rho)},
            {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, Rgb::Constant(rho)},
            {{{0.5, 0.2, 2}, {0.5, 0.8, 2}, {1.1, 0.8, 2}, {1.1, 0.2, 2}}, Rgb::Zero(), Rgb::Constant(3)}};
}

TEST(Effects, BouncesWithoutWeightAreLeftOut) {
    const Options options = Options().to_tolerance(0.01);
    EffectSwitches whole;
    whole[Effect::interreflection] = Switch::on;
    for (const double rho : {2e-4, 4e-3, 0.5}) {
        const auto scene = reference::scene_of(corner(rho));
        const auto plain = solved(scene, options, {}), on = solved(scene, options, whole);
        // What is reflected twice is at most rho / (1 - rho) of the rest; a twentieth of 0.01 is let go.
        const bool dim = rho / (1 - rho) < 5e-4;
        EXPECT_EQ(plain->counters().links < on->counters().links, dim) << rho;
        EXPECT_EQ(called_for(*plain).contains("interreflection"), !dim) << rho;
        if (dim) {
            EXPECT_LT(difference(*on, *plain), rho);
        }
    }
    // Bright, but a hundred metres apart: F is below 1 / (pi 100^2).
    std::vector<reference::Face> far = corner(0.5);
    far[1] = {{{100, 0, 0}, {100, 0, 1}, {100, 1, 1}, {100, 1, 0}}, Rgb::Constant(0.5)};
    EXPECT_FALSE(called_for(*solved(reference::scene_of(far), options, {})).contains("interreflection"));
}

// --- Scenes on which a plan could err: solved both ways.

using Random = std::mt19937;

double in(Random &random, double low, double high) { return low + (high - low) * (random() / 4294967296.0); }

reference::Face rectangle(const Vec3 &corner, const Vec3 &first, const Vec3 &second, Rgb rho, Rgb e = Rgb::Zero()) {
    return {{corner, corner + first, corner + first + second, corner + second}, rho, e};
}

/// A screen whose edge only just enters the shaft between lamp and floor, or only just does not.
std::vector<reference::Face> grazing_screen(Random &random) {
    const double h = in(random, 0.3, 1.7), lamp = 0.5, floor = 1;
    const double shaft = floor + (lamp - floor) * h / 2; // half the shaft's width there
    const double edge = shaft + std::pow(10, in(random, -9, -1)) * (random() % 2 ? 1 : -1);
    return {rectangle({-floor, -floor, 0}, {2 * floor, 0, 0}, {0, 2 * floor, 0}, Rgb::Constant(0.5)),
            rectangle({-lamp, lamp, 2}, {2 * lamp, 0, 0}, {0, -2 * lamp, 0}, Rgb::Zero(), Rgb::Constant(4)),
            rectangle({edge, -2, h}, {1, 0, in(random, -0.2, 0.2)}, {0, 4, 0}, Rgb::Zero())};
}

/// Walls that see the lamp only by way of each other: the last is bright after three bounces, and nearly white.
std::vector<reference::Face> round_corners(Random &random) {
    const double rho = in(random, 0.7, 0.95), w = in(random, 0.5, 1);
    const Rgb white = Rgb::Constant(rho);
    return {rectangle({0, 0, 0}, {0, w, 0}, {0, 0, 1}, white),              // looks along +x
            rectangle({3, 0, 0}, {0, 0, 1}, {0, w, 0}, white),              // along -x
            rectangle({0.2, 2, 0}, {0, 0, 1}, {2, 0, 0}, white),            // along -y ...
            rectangle({0.5, -0.2, 0}, {2, 0, 0}, {0, 0, 1}, white),
            rectangle({1.2, w, 0.2}, {0.4, 0, 0}, {0, 0, 0.4}, Rgb::Zero(), Rgb::Constant(5))};
}

/// Channels alike in all but one material, or one lamp.
std::vector<reference::Face> nearly_grey(Random &random) {
    auto faces = grazing_screen(random);
    faces.push_back(rectangle({-1, 1, 0}, {0, 0, 1}, {2, 0, 0}, Rgb::Constant(0.5)));
    std::ranges::reverse(faces.back().corners);
    const double odd = in(random, 0, 0.9);
    if (random() % 2)
        faces[random() % 2 ? 0 : 3].reflectance[static_cast<int>(random() % 3)] = odd;
    else
        faces[1].exitance[static_cast<int>(random() % 3)] *= odd;
    return faces;
}

struct Trap {
    const char *name;
    std::vector<reference::Face> (*make)(Random &);
};

class WrongDecisions : public testing::TestWithParam<Trap> {};

TEST_P(WrongDecisions, AreNotTaken) {
    Random random(20);
    int n_dark = 0;
    for (int i = 0; i < 15; ++i) {
        const auto scene = reference::scene_of(GetParam().make(random));
        const Options options = Options().to_tolerance(0.02);
        const auto plain = solved(scene, options, {}), whole = solved(scene, options, all(Switch::on));
        n_dark += whole->state()->peak == 0;
        // Each is within the tolerance of the truth.
        EXPECT_LT(difference(*whole, *plain), 0.03) << GetParam().name << " " << i;
    }
    EXPECT_EQ(n_dark, 0);
}

INSTANTIATE_TEST_SUITE_P(Traps, WrongDecisions,
                         testing::Values(Trap{"grazing_screen", grazing_screen}, Trap{"round_corners", round_corners},
                                         Trap{"nearly_grey", nearly_grey}),
                         [](const auto &trap) { return trap.param.name; });

} // namespace
} // namespace penumbra
