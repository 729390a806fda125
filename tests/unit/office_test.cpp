// The generated offices: as many polygons as asked for, closed, fronts where the light is; the bundled one is one of
// them.
#include "office/office.h"

#include "core/read_text.h"
#include "unit/obj_text.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace penumbra {
namespace {

Scene scene_of(const SceneText &text) { return penumbra::scene_of(text.obj, text.mtl); }

std::string file(const std::string &name) { return read_text(PENUMBRA_SOURCE_DIR "/assets/scenes/" + name, 1 << 20); }

TEST(Office, TheBundledOneIsMadeByIt) {
    const SceneText text = office(300);
    EXPECT_TRUE(text.obj == file("office.obj")) << "make it again: make_office 300 assets/scenes/office";
    EXPECT_TRUE(text.mtl == file("office.mtl"));
}

TEST(Office, AsManyPolygonsAsAskedFor) {
    for (const int n : {75, 150, 300, 600, 1200})
        EXPECT_NEAR(scene_of(office(n)).n_surfaces(), n, 0.1 * n);
    EXPECT_EQ(scene_of(office(1)).n_surfaces(), scene_of(office(75)).n_surfaces()) << "one room at least";
}

/// By the part before the number: the volume that it encloses, from outside positive (a sum of cones from the origin).
std::map<std::string, double> volumes(const Scene &scene) {
    std::map<std::string, double> sum;
    const Vec3 base = scene.own.to_solver(Vec3::Zero());
    for (const Surface &s : scene.surfaces)
        sum[s.name.substr(0, s.name.find_last_not_of("_0123456789") + 1)] +=
            s.area * (s.corners[0] - base).dot(s.frame.normal) / 3 * std::pow(scene.own.size, 3);
    return sum;
}

/// Four rooms, of 4 x 5 x 2.7 with a doorway of 0.9 x 0.2 x 2.1 each, on a corridor of 8.2 x 1.6; lamps are in the
/// ceilings and enclose no air of their own: their cones make up for what they would add.
TEST(Office, ClosedRoomsAndClosedFurniture) {
    const Scene scene = scene_of(office(300));
    EXPECT_TRUE(scene.notes.empty());
    const auto sum = volumes(scene);
    double air = 0;
    for (const char *part :
         {"floor", "ceiling", "walls", "door", "corridor_floor", "corridor_ceiling", "corridor_walls"})
        air += sum.at(part);
    EXPECT_NEAR(-air, 4 * (4 * 5 * 2.7 + 0.9 * 0.2 * 2.1) + 8.2 * 1.6 * 2.7, 1e-9);
    EXPECT_NEAR(sum.at("desk"), 4 * (1.6 * 0.8 * 0.04 + 4 * 0.05 * 0.05 * 0.7), 1e-9);
    EXPECT_NEAR(sum.at("cabinet"), 4 * 0.45 * 1.2 * 1.8, 1e-9);
    EXPECT_NEAR(sum.at("screen"), 4 * 0.6 * 0.06 * 0.4, 1e-9);
    // Turned chairs are rounded to 0.1 mm.
    EXPECT_NEAR(sum.at("chair"), 4 * (0.44 * 0.44 * 0.04 + 0.08 * 0.08 * 0.38 + 0.48 * 0.48 * 0.06 + 0.4 * 0.05 * 0.5),
                1e-3);
}

TEST(Office, WhatStandsCoversWhatCarriesIt) {
    const Scene scene = scene_of(office(300));
    for (const Surface &s : scene.surfaces) {
        const std::string name = s.name.substr(0, s.name.find_last_not_of("_0123456789") + 1);
        if (name == "floor") {
            EXPECT_NEAR(s.frame.normal.z(), 1, 1e-12);
            EXPECT_EQ(s.covers.size(), 6U) << "four legs of the desk, the chair's foot and the cabinet";
        }
        if (name == "light") {
            EXPECT_NEAR(s.frame.normal.z(), -1, 1e-12);
            EXPECT_TRUE(s.covers.empty());
        }
        if (name == "ceiling") {
            EXPECT_EQ(s.covers.size(), 1U) << "the lamp";
        }
    }
}

} // namespace
} // namespace penumbra
