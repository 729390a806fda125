// The bundled scenes: whole, and each face's front where light is.
#include "scene/bundled.h"

#include "core/error.h"

#include <fstream>
#include <gmock/gmock.h>
#include <set>
#include <string_view>

namespace penumbra {
namespace {

const Surface &named(const Scene &scene, std::string_view name) {
    for (const Surface &s : scene.surfaces)
        if (s.name == name)
            return s;
    throw std::out_of_range(std::string(name));
}

/// Volume that the surfaces of that name enclose, positive when their fronts face outwards: a sum of cones from the
/// origin, so that a bottom that is missing in the plane z = 0 adds nothing.
double volume(const Scene &scene, const std::string &name) {
    double sum = 0;
    for (const Surface &s : scene.surfaces)
        if (s.name == name) {
            const Vec3 base = scene.own.to_solver(Vec3::Zero());
            sum += s.area * (s.corners[0] - base).dot(s.frame.normal) / 3;
        }
    return sum * std::pow(scene.own.size, 3);
}

TEST(Bundled, AllAreThereWithDescriptionAndView) {
    std::vector<std::string_view> names;
    for (const BundledScene &b : bundled_scenes()) {
        names.push_back(b.name);
        const Scene scene = open_scene(std::string(b.name));
        EXPECT_EQ(scene.name, b.name);
        EXPECT_FALSE(scene.description.empty()) << b.name;
        EXPECT_TRUE(scene.view) << b.name;
        EXPECT_NEAR((scene.own.to_solver(scene.own.centre)).norm(), 0, 1e-15);
    }
    EXPECT_THAT(names, testing::UnorderedElementsAre("figure-4", "slanted-edge", "cornell-box", "furnace",
                                                     "skew-blockers", "box-on-floor", "stairs", "venetian-blinds",
                                                     "table", "next-room", "pierced", "three-blockers", "office",
                                                     "soft-shadow", "one-bounce", "no-blockers", "grey",
                                                     "two-rooms", "far-wall", "mirror-twins", "dark"));
}

TEST(Bundled, NothingNeedsMendingButTheCornellBox) {
    for (const BundledScene &b : bundled_scenes()) {
        const bool has_note = b.name == "cornell-box" || b.name == "dark"; // "no surface emits"
        EXPECT_EQ(open_scene(std::string(b.name)).notes.size(), has_note ? 1U : 0U) << b.name;
    }
}

TEST(Bundled, FloorsFaceUpAndLightsDown) {
    // Without one floor and one light: the office has a test of its own, the others are looked at in effects_test.cpp.
    const std::set<std::string_view> others{"furnace",   "office",   "no-blockers", "two-rooms",
                                            "far-wall", "mirror-twins", "dark"};
    for (const BundledScene &b : bundled_scenes()) {
        if (others.contains(b.name))
            continue;
        const Scene scene = open_scene(std::string(b.name));
        EXPECT_NEAR(named(scene, "floor").frame.normal.z(), 1, 1e-12) << b.name;
        if (b.name == "venetian-blinds") // its window looks along -y, over the floor
            EXPECT_NEAR(named(scene, "window").frame.normal.y(), -1, 1e-12);
        else
            EXPECT_NEAR(named(scene, "light").frame.normal.z(), -1, 1e-12) << b.name;
    }
}

// Volumes by hand: 0.7 x 0.5 x 0.8; five steps of 0.3 x 1.2 and heights 0.2 to 1; blocks by the area of their tops
// (cross product of the diagonals over 2) times height; the unit cube is seen from inside, so its volume is negative.
TEST(Bundled, SolidsFaceOutwards) {
    EXPECT_NEAR(volume(open_scene("box-on-floor"), "box"), 0.7 * 0.5 * 0.8, 1e-7);
    EXPECT_NEAR(volume(open_scene("stairs"), "steps"), 0.3 * 1.2 * (0.2 + 0.4 + 0.6 + 0.8 + 1.0), 1e-12);
    EXPECT_NEAR(volume(open_scene("furnace"), "walls"), -1, 1e-12);
    EXPECT_NEAR(volume(open_scene("table"), "top"), 1.4 * 0.8 * 0.04, 1e-12);
    for (const char *leg : {"leg_1", "leg_2", "leg_3", "leg_4"})
        EXPECT_NEAR(volume(open_scene("table"), leg), 0.08 * 0.08 * 0.7, 1e-12);
    EXPECT_NEAR(volume(open_scene("pierced"), "box"), 0.54 * 0.45 * 1.44, 1e-12);
    const Scene box = open_scene("cornell-box");
    EXPECT_NEAR(volume(box, "short_block"), 165 * (110 * 111 + 207 * 208) / 2.0, 1e-3);
    EXPECT_NEAR(volume(box, "tall_block"), 330 * (109 * 110 + 209 * 207) / 2.0, 1e-3);
}

TEST(Bundled, CornellBoxFacesInwards) {
    const Scene scene = open_scene("cornell-box");
    for (const char *wall : {"ceiling", "back_wall", "left_wall", "right_wall"}) {
        const Surface &s = named(scene, wall);
        EXPECT_GT(s.frame.height(Vec3::Zero()), 0) << wall << ": the middle of the box lies in front";
    }
    EXPECT_EQ(scene.n_surfaces(), 6 + 1 + 5 + 5) << "the bent wall is two triangles";
    EXPECT_EQ(named(scene, "ceiling").covers.size(), 1U);
    EXPECT_NEAR(area(named(scene, "ceiling").covers[0]), named(scene, "light").area, 1e-12);
    EXPECT_TRUE(named(scene, "light").covers.empty());
}

TEST(Bundled, BoxOnFloorDarkensBothFacesOfTheContact) {
    const Scene scene = open_scene("box-on-floor");
    ASSERT_EQ(named(scene, "floor").covers.size(), 1U);
    const double bottom = 0.7 * 0.5 / std::pow(scene.own.size, 2);
    EXPECT_NEAR(area(named(scene, "floor").covers[0]), bottom, 1e-9);
    EXPECT_EQ(named(scene, "box").covers.size(), 1U) << "its bottom is its first face";
}

/// Two rooms of 4 x 4 x 2.6, and a door of 0.9 x 2 through a wall of 0.2: every other face of the file shares its edges,
/// so all of them together enclose the three volumes, seen from inside, but for the lamp, which lies in the ceiling.
TEST(Bundled, NextRoomIsClosed) {
    const Scene scene = open_scene("next-room");
    double sum = 0;
    for (const char *part : {"floor", "ceiling", "walls", "next_walls", "dividing_wall", "next_dividing_wall", "door"})
        sum += volume(scene, part);
    EXPECT_NEAR(sum, -(2 * 4 * 4 * 2.6 + 0.9 * 2 * 0.2), 1e-9);
    for (const Surface &s : scene.surfaces)
        EXPECT_EQ(s.covers.size(), s.name == "ceiling" && s.face == 2 ? 1U : 0U) << s.name;
}

TEST(Bundled, TableStandsOnTheFloor) {
    const Scene scene = open_scene("table");
    EXPECT_EQ(named(scene, "floor").covers.size(), 4U);
    EXPECT_EQ(named(scene, "top").covers.size(), 4U) << "its underside is its first face";
    for (const Polygon &foot : named(scene, "floor").covers)
        EXPECT_NEAR(area(foot), 0.08 * 0.08 / std::pow(scene.own.size, 2), 1e-12);
}

TEST(Bundled, PiercedReachesBothSidesOfItsFloor) {
    const Scene scene = open_scene("pierced");
    double lowest = 0, highest = 0;
    for (const Surface &s : scene.surfaces)
        if (s.name == "box")
            for (const Vec3 &c : s.corners) {
                const double height = named(scene, "floor").frame.height(c) * scene.own.size;
                lowest = std::min(lowest, height);
                highest = std::max(highest, height);
            }
    EXPECT_LT(lowest, -0.3);
    EXPECT_GT(highest, 0.6);
}

TEST(Bundled, AnExistingFileWins) {
    const auto folder = std::filesystem::temp_directory_path() / "penumbra-bundled-test";
    std::filesystem::create_directories(folder);
    const auto here = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    std::ofstream("figure-4") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const int n = open_scene("figure-4").n_surfaces();
    std::filesystem::create_directories("furnace"); // a folder is no file
    const int n_of_furnace = open_scene("furnace").n_surfaces();
    EXPECT_THROW(open_scene("."), BadInput);
    std::filesystem::current_path(here);
    std::filesystem::remove_all(folder);
    EXPECT_EQ(n, 1);
    EXPECT_EQ(n_of_furnace, 6);
    EXPECT_EQ(open_scene("figure-4").n_surfaces(), 3);
}

TEST(Bundled, AnUnknownNameListsThem) {
    try {
        open_scene("no-such-scene");
        FAIL();
    } catch (const BadInput &e) {
        EXPECT_THAT(e.what(), testing::HasSubstr("figure-4"));
    }
}

} // namespace
} // namespace penumbra
