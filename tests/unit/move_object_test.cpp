// Objects that are moved: against the scene that has them there from the first.
#include "reference/faces.h"
#include "scene/bundled.h"
#include "scene/move_object.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

using reference::Face;

std::vector<Face> floor_and_sheet(const Vec3 &centre, double half) {
    return {{{Vec3(-2, -2, 0), Vec3(2, -2, 0), Vec3(2, 2, 0), Vec3(-2, 2, 0)}},
            {{centre + half * Vec3(-1, -1, 0), centre + half * Vec3(1, -1, 0), centre + half * Vec3(1, 1, 0),
              centre + half * Vec3(-1, 1, 0)},
             Rgb::Constant(0.2),
             Rgb::Constant(3)}};
}

void expect_the_same(const Scene &a, const Scene &b) {
    ASSERT_EQ(a.n_surfaces(), b.n_surfaces());
    for (int i = 0; i < a.n_surfaces(); ++i) {
        const SurfaceId s(i);
        EXPECT_EQ(a.surface(s).name, b.surface(s).name);
        EXPECT_EQ(a.surface(s).covers.size(), b.surface(s).covers.size());
        EXPECT_TRUE((a.exitance(s) == b.exitance(s)).all());
        ASSERT_EQ(a.surface(s).corners.size(), b.surface(s).corners.size());
        for (std::size_t k = 0; k < a.surface(s).corners.size(); ++k)
            EXPECT_LT((a.own.to_own(a.surface(s).corners[k]) - b.own.to_own(b.surface(s).corners[k])).norm(), 1e-12);
    }
}

TEST(MoveObject, IsAsIfItHadBeenThereFromTheFirst) {
    const auto before = reference::scene_of(floor_and_sheet({0, 0, 1}, 0.5));
    const ObjectMove move{1, {0.25, -0.5, 1}, 1.5};
    expect_the_same(with_moves(*before, {&move, 1}), *reference::scene_of(floor_and_sheet({0.25, -0.5, 2}, 0.75)));
}

TEST(MoveObject, WhatComesToLieOnTheFloorCoversIt) {
    const auto before = reference::scene_of(floor_and_sheet({0, 0, 1}, 0.5));
    EXPECT_TRUE(before->surface(SurfaceId(0)).covers.empty());
    const ObjectMove down{1, {0, 0, -1}, 1};
    EXPECT_EQ(with_moves(*before, {&down, 1}).surface(SurfaceId(0)).covers.size(), 1u);
}

TEST(MoveObject, AllFacesOfAnObjectMoveAndBacksStayBacks) {
    for (const char *name : {"table", "mirror-twins", "cornell-box"}) {
        const Scene scene = open_scene(name);
        for (int i = 0; i < scene.n_surfaces(); ++i) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
            const auto together = object_surfaces(scene, SurfaceId(i));
            ASSERT_FALSE(together.empty());
            const ObjectMove aside{together.front(), {0.01, 0.02, 0.015}, 1};
            const Scene moved = with_moves(scene, {&aside, 1});
            ASSERT_EQ(moved.n_surfaces(), scene.n_surfaces());
            for (int k = 0; k < scene.n_surfaces(); ++k) {
                const Surface &was = scene.surface(SurfaceId(k)), &is = moved.surface(SurfaceId(k));
                EXPECT_EQ(is.back, was.back);
                const bool moves = was.name == scene.surface(SurfaceId(i)).name;
                const Vec3 way = moved.own.to_own(is.corners[0]) - scene.own.to_own(was.corners[0]);
                EXPECT_NEAR((way - (moves ? aside.offset : Vec3(Vec3::Zero()))).norm(), 0, 1e-9);
            }
        }
    }
}

TEST(MoveObject, NothingMovedIsTheSameScene) {
    const Scene scene = open_scene("table");
    expect_the_same(with_moves(scene, {}), scene);
}

TEST(MoveObject, WhatCannotBeIsBadInput) {
    const auto scene = reference::scene_of(floor_and_sheet({0, 0, 1}, 0.5));
    for (const ObjectMove &bad : {ObjectMove{2, Vec3::Zero(), 1}, ObjectMove{-1, Vec3::Zero(), 1}, ObjectMove{1, Vec3::Zero(), 0},
                                  ObjectMove{1, Vec3(std::nan(""), 0, 0), 1}})
        EXPECT_THROW(with_moves(*scene, {&bad, 1}), BadInput);
}

} // namespace
} // namespace penumbra
