// Every hard case has a scene to be looked at.
#include "scene/bundled.h"
#include "study/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace penumbra {
namespace {

TEST(CaseScenes, EveryCaseShowsWhatItSolvesFirst) {
    for (const HardCase &hard_case : hard_cases()) {
        SCOPED_TRACE(hard_case.name);
        std::vector<Faces> solved;
        TrialSetting setting;
        Cancel cancel;
        setting.cancel = &cancel;
        setting.on_solve = [&](const Faces &faces) {
            solved.push_back(faces);
            cancel.raise(); // the solver does not begin
        };
        EXPECT_THROW(hard_case.measure(setting), Cancelled);
        ASSERT_EQ(solved.size(), 1u);
        const Scene scene = scene_of(hard_case), own = build_scene(solved[0], "own");
        EXPECT_EQ(scene.name, hard_case.name);
        ASSERT_EQ(scene.n_surfaces(), own.n_surfaces());
        for (int s = 0; s < scene.n_surfaces(); ++s)
            EXPECT_EQ(scene.surface(SurfaceId(s)).corners, own.surface(SurfaceId(s)).corners);
    }
}

TEST(CaseScenes, OneWithoutASceneSaysSo) {
    EXPECT_THROW(scene_of({"none", "", [](const TrialSetting &) { return std::vector<Measurement>(); }}), BadInput);
}

TEST(CaseScenes, NoBundledSceneHasACasesName) {
    for (const HardCase &hard_case : hard_cases())
        EXPECT_TRUE(std::ranges::none_of(bundled_scenes(), [&](const auto &b) { return b.name == hard_case.name; }))
            << hard_case.name;
}

} // namespace
} // namespace penumbra
