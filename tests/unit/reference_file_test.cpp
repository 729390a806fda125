// What is kept of a solution brings the same reference back, and nothing else does.
#include "files/reference_file.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <memory>

namespace penumbra {

namespace {

struct ReferenceFiles : testing::Test {
    const std::shared_ptr<const Scene> scene = std::make_shared<const Scene>(open_scene("stairs", {}));
    KeptSolution kept{0.05, {}};

    void SetUp() override {
        Solver solver(scene, Options().to_tolerance(0.05));
        ASSERT_TRUE(solver.run());
        kept.solution = {std::make_shared<const Forest>(solver.state()->forest), solver.state()->radiosity, 0.0125};
    }
};

TEST_F(ReferenceFiles, BringTheSolutionBack) {
    const auto again = read_reference(*scene, reference_bytes(*scene, kept));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->tolerance, 0.05);
    EXPECT_EQ(again->solution.error, 0.0125);
    const Reference before(scene, kept.solution), after(scene, again->solution);
    for (int s = 0; s < scene->n_surfaces(); ++s) {
        const Vec2 at = 0.3 * scene->surface(SurfaceId(s)).outline[0] + 0.4 * scene->surface(SurfaceId(s)).outline[1] +
                        0.3 * scene->surface(SurfaceId(s)).outline[2];
        EXPECT_TRUE((before.radiosity_at(SurfaceId(s), at) == after.radiosity_at(SurfaceId(s), at)).all()) << s;
    }
}

TEST_F(ReferenceFiles, OfAnotherSceneAreNone) {
    const std::string bytes = reference_bytes(*scene, kept);
    const Scene other = open_scene("table", {});
    EXPECT_FALSE(read_reference(other, bytes));
    EXPECT_NE(reference_path("folder", *scene), reference_path("folder", other));
    Scene brighter = *scene;
    brighter.materials[0].reflectance[1] += 1e-9;
    EXPECT_FALSE(read_reference(brighter, bytes));
}

TEST_F(ReferenceFiles, DamagedAreNone) {
    const std::string bytes = reference_bytes(*scene, kept);
    for (std::size_t cut : {std::size_t{0}, std::size_t{7}, bytes.size() / 2, bytes.size() - 1})
        EXPECT_FALSE(read_reference(*scene, bytes.substr(0, cut))) << cut;
    EXPECT_FALSE(read_reference(*scene, bytes + "x"));
    for (std::size_t at = 0; at < bytes.size(); at += 997) {
        std::string damaged = bytes;
        damaged[at] ^= 0x10;
        EXPECT_FALSE(read_reference(*scene, damaged)) << at;
    }
}

} // namespace

} // namespace penumbra
