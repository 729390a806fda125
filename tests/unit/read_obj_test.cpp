// The reader and the checks: what real files contain is read as meant, what cannot be used is refused in one line.
#include "obj_text.h"

#include "core/error.h"

#include <fstream>
#include <gmock/gmock.h>

namespace penumbra {
namespace {

using testing::HasSubstr;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The one line with which the scene is refused; fails the test when it is taken.
std::string refusal(const std::string &obj, const std::string &mtl = "") {
    try {
        scene_of(obj, mtl);
    } catch (const BadInput &e) {
        EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
        return e.what();
    }
    ADD_FAILURE() << "was taken:\n" << obj;
    return "";
}

std::string notes_of(const Scene &scene) {
    std::string all;
    for (const std::string &note : scene.notes)
        all += note + "\n";
    return all;
}

TEST(ReadObj, KeepsPolygonsWholeAndNormalises) {
    const Scene scene = scene_of("v 10 10 5\nv 14 10 5\nv 14 13 5\nv 10 13 5\nf 1 2 3 4\n");
    ASSERT_EQ(scene.n_surfaces(), 1);
    EXPECT_EQ(scene.surfaces[0].corners.size(), 4U);
    EXPECT_EQ(scene.own.size, 5);
    EXPECT_EQ(scene.own.centre, Vec3(12, 11.5, 5));
    EXPECT_NEAR(scene.surfaces[0].area, 12.0 / 25, 1e-15);
    EXPECT_EQ(scene.surfaces[0].frame.normal, Vec3(0, 0, 1));
}

TEST(ReadObj, ScalingByAPowerOfTwoGivesTheSameBits) {
    // Three decimals: a reader that rounds wrongly gives different last bits for the scaled text.
    const Scene a = scene_of("v 0.11 0.37 0.1\nv 1.91 0.43 0.7\nv 0.23 1.79 0.3\nf 1 2 3\n");
    const Scene b = scene_of("v 112.64 378.88 102.4\nv 1955.84 440.32 716.8\nv 235.52 1832.96 307.2\nf 1 2 3\n");
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(a.surfaces[0].corners[i], b.surfaces[0].corners[i]);
}

TEST(ReadObj, LineEndsMarksContinuationsAndCommentsDoNotMatter) {
    const Scene plain = scene_of(square + "f 1 2 3 4\n");
    for (const std::string &text :
         {std::string("\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0 \r\n\tv 1 1 0\t\r\nv 0 1 0\r\nf 1 2 3 4 \r\n"),
          std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4"),
          std::string("# head\nv 0 0 0 # first\nv 1 0 \\\n0\nv 1 1 0\n\n\nv 0 1 0\nf 1 2 \\\r\n3 4")}) {
        const Scene scene = scene_of(text);
        ASSERT_EQ(scene.n_surfaces(), 1) << text;
        EXPECT_EQ(scene.surfaces[0].corners, plain.surfaces[0].corners);
    }
}

TEST(ReadObj, IndicesCountFromOneOrBackFromTheNewest) {
    for (const char *face : {"f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/1/1 3/1/1 4/1/1", "f -4 -3 -2 -1"})
        EXPECT_DOUBLE_EQ(scene_of(square + face).surfaces[0].area, 0.5);
    EXPECT_EQ(scene_of("f 1 2 3 4\n" + square).n_surfaces(), 1) << "faces before their vertices";
}

TEST(ReadObj, MoreNumbersOnAVertexAreWeightsOrColours) {
    EXPECT_EQ(scene_of("v 0 0 0 1 0 0\nv 1 0 0 1\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3\n").n_surfaces(), 1);
}

TEST(ReadObj, MaterialsMayComeAfterTheirUseAndHaveBlanksInTheirNames) {
    const Scene scene = scene_of(square + "usemtl deep red\nf 1 2 3 4\nmtllib my scene.mtl\n",
                                 "newmtl deep red\r\nKd 0.6 0.05 0.04 \r\nKs 1 1 1\r\n");
    EXPECT_EQ(scene.reflectance(SurfaceId(0))[1], 0.05);
    EXPECT_EQ(scene.exitance(SurfaceId(0)).maxCoeff(), 0) << "no Ke emits nothing";
    EXPECT_THAT(notes_of(scene), HasSubstr("'Ks' 1x"));
}

TEST(ReadObj, AnEmitterWithoutKdIsBlack) {
    const Scene scene = scene_of("mtllib m\nusemtl lamp\n" + square + "f 1 2 3 4\n", "newmtl lamp\nKe 3 2 1\n");
    EXPECT_EQ(scene.reflectance(SurfaceId(0)).maxCoeff(), 0);
    EXPECT_EQ(scene.exitance(SurfaceId(0))[0], 3);
}

TEST(ReadObj, AMissingLibraryIsGreyAndNoted) {
    const Scene scene = scene_of("mtllib gone.mtl\nusemtl wall\n" + square + "f 1 2 3 4\n");
    EXPECT_EQ(scene.reflectance(SurfaceId(0))[2], 0.5);
    EXPECT_THAT(notes_of(scene), HasSubstr("t.obj:1: material library 'gone.mtl' is not there"));
    EXPECT_THAT(notes_of(scene), HasSubstr("missing material 'wall': grey 0.5"));
}

TEST(ReadObj, AFaceWithoutMaterialIsGreyAndNoted) {
    EXPECT_THAT(notes_of(scene_of(square + "f 1 2 3 4\n")), HasSubstr("1 face without a material: grey 0.5"));
}

TEST(ReadObj, ASceneThatNothingLightsSaysSoFirst) {
    // A lamp whose light is in Ka, as older exporters wrote it.
    const Scene dark = scene_of("mtllib m\nusemtl light\n" + square + "f 1 2 3 4\n", "newmtl light\nKa 20 20 20\nKd 0.5 0.5 0.5\n");
    ASSERT_FALSE(dark.notes.empty());
    EXPECT_THAT(dark.notes[0], HasSubstr("nothing emits"));
    const Scene lit = scene_of("mtllib m\nusemtl light\n" + square + "f 1 2 3 4\n", "newmtl light\nKe 0 0 1\n");
    EXPECT_THAT(notes_of(lit), testing::Not(HasSubstr("nothing emits")));
}

TEST(ReadObj, WhatMeansNothingIsCountedOnce) {
    const Scene scene = scene_of("vn 0 0 1\nvn 0 1 0\nvt 0 0\ns off\n" + square + "f 1 2 3 4\nl 1 2\n");
    EXPECT_THAT(notes_of(scene), HasSubstr("'l' 1x, 's' 1x, 'vn' 2x, 'vt' 1x"));
}

TEST(ReadObj, NamesComeFromObjectsAndGroups) {
    const Scene scene = scene_of(square + "o wall\nf 1 2 3\ng left part\nf 1 3 4\n");
    EXPECT_EQ(scene.surfaces[0].name, "wall");
    EXPECT_EQ(scene.surfaces[1].name, "left part");
    EXPECT_EQ(scene.surfaces[1].face, 1);
}

TEST(ReadObj, LibrariesOutsideTheFolderAreNotRead) {
    const auto folder = std::filesystem::temp_directory_path() / "penumbra-read-test";
    std::filesystem::create_directories(folder / "inner");
    std::ofstream(folder / "m.mtl") << "newmtl red\nKd 0.6 0 0\n";
    std::ofstream(folder / "inner" / "up.obj") << "mtllib ../m.mtl\nusemtl red\n" << square << "f 1 2 3 4\n";
    std::ofstream(folder / "beside.obj") << "mtllib .\\m.mtl\nusemtl red\n" << square << "f 1 2 3 4\n";
    const Scene outside = read_obj(folder / "inner" / "up.obj"), beside = read_obj(folder / "beside.obj");
    std::filesystem::remove_all(folder);
    EXPECT_EQ(outside.reflectance(SurfaceId(0))[0], 0.5);
    EXPECT_EQ(beside.reflectance(SurfaceId(0))[0], 0.6);
    EXPECT_EQ(beside.name, "beside");
}

TEST(Mend, RepeatedCornersAreDropped) {
    const Scene scene = scene_of(square + "v 1 0 0\nf 1 2 5 2 3 4 1\n");
    EXPECT_EQ(scene.surfaces[0].corners.size(), 4U);
    EXPECT_THAT(notes_of(scene), HasSubstr("t.obj:6: face: 3 repeated corners dropped"));
}

TEST(Mend, FacesWithoutAreaAreDroppedAndNumbersStay) {
    const Scene scene = scene_of(square + "v 2 0 0\nf 1 2 5\nf 1 1 2\nf 1 2 3 4\n");
    ASSERT_EQ(scene.n_surfaces(), 1);
    EXPECT_EQ(scene.surfaces[0].face, 2);
    EXPECT_THAT(notes_of(scene), HasSubstr("t.obj:6: face has no area: dropped"));
}

TEST(Mend, CornersOnAStraightSideAreDropped) {
    EXPECT_EQ(scene_of(square + "v 0.5 0 0\nf 1 5 2 3 4\n").surfaces[0].corners.size(), 4U);
}

TEST(Mend, SlightlyBentFacesAreFlattened) {
    const Scene scene = scene_of("v 0 0 0\nv 1 0 0\nv 1 1 1e-6\nv 0 1 0\nf 1 2 3 4\n");
    ASSERT_EQ(scene.n_surfaces(), 1);
    for (const Vec3 &x : scene.surfaces[0].corners)
        EXPECT_NEAR(scene.surfaces[0].frame.height(x), 0, 1e-16);
    EXPECT_THAT(notes_of(scene), HasSubstr("flattened"));
}

TEST(Mend, BentFacesBecomeTriangles) {
    const Scene scene = scene_of("v 0 0 0\nv 1 0 0\nv 1 1 1e-3\nv 0 1 0\nf 1 2 3 4\n");
    ASSERT_EQ(scene.n_surfaces(), 2);
    EXPECT_EQ(scene.surfaces[1].face, 0);
    EXPECT_NEAR((scene.surfaces[0].area + scene.surfaces[1].area) * scene.own.size * scene.own.size, 1, 1e-6);
    EXPECT_THAT(notes_of(scene), HasSubstr("cut into 2 triangles"));
}

TEST(Mend, ABentConcaveFaceIsTiledExactly) {
    // An L of area 3, one corner lifted by 0.01: each triangle grows by less than 1e-3, and a fan would cover more.
    const Scene scene = scene_of("v 0 0 0\nv 2 0 0.01\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
    ASSERT_EQ(scene.n_surfaces(), 4);
    double sum = 0;
    for (const Surface &s : scene.surfaces) {
        EXPECT_GT(s.frame.normal.z(), 0.9);
        sum += s.area * scene.own.size * scene.own.size;
    }
    EXPECT_NEAR(sum, 3, 1e-3);
}

TEST(Mend, ConcaveFacesKeepTheirOutlineAndGetConvexParts) {
    const Scene scene = scene_of("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
    EXPECT_EQ(scene.surfaces[0].outline.size(), 6U);
    double sum = 0;
    for (const Polygon &part : scene.surfaces[0].parts)
        sum += area(part);
    EXPECT_EQ(scene.surfaces[0].parts.size(), 2U);
    EXPECT_NEAR(sum, scene.surfaces[0].area, 1e-15);
}

// A comb of 200 teeth: the optimal partition would take hours and gigabytes.
TEST(Mend, PolygonsOfManyCornersGetPartsInTime) {
    std::string vertices, face = "f";
    int n = 0;
    const auto corner = [&](double x, double y) {
        vertices += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
        face += " " + std::to_string(++n);
    };
    constexpr int n_teeth = 200;
    corner(0, 0);
    corner(2 * n_teeth, 0);
    for (int i = n_teeth - 1; i >= 0; --i) {
        corner(2 * i + 2, 1);
        corner(2 * i + 1, 3);
    }
    corner(0, 1);
    const Scene scene = scene_of(vertices + face + "\n");
    double sum = 0;
    for (const Polygon &part : scene.surfaces[0].parts)
        sum += area(part) * scene.own.size * scene.own.size;
    EXPECT_NEAR(sum, 2 * n_teeth + 2 * n_teeth, 1e-6) << "a bar of height 1 and teeth of area 2";
}

TEST(Mend, ManyNotesOfAKindAreCounted) {
    std::string faces = square;
    for (int i = 0; i < 10; ++i)
        faces += "f 1 1 2\n";
    EXPECT_THAT(notes_of(scene_of(faces + "f 1 2 3 4\n")), HasSubstr("and 7 more: faces without area dropped"));
}

struct Bad {
    std::string what, obj, mtl, message;
};

void PrintTo(const Bad &bad, std::ostream *out) { *out << bad.what; }

const Bad bad_inputs[] = {
    {"Empty", "", "", "t.obj: has no surface"},
    {"NoFace", square, "", "t.obj: has no surface"},
    {"OnlyFlatFaces", square + "f 1 2 1\n", "", "none of its faces has an area"},
    {"OnePoint", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "", "lie in one point"},
    {"IndexTooLarge", square + "f 1 2 5\n", "", "t.obj:5: face index 5 is out of range; the file has 4 vertices"},
    {"IndexZero", square + "f 0 1 2\n", "", "t.obj:5: face index 0 is out of range"},
    {"IndexTooFarBack", square + "f -5 -1 -2\n", "", "t.obj:5: face index -5 is out of range"},
    {"IndexHuge", square + "f 1 2 99999999999999999999\n", "", "t.obj:5: face index '99999999999999999999' is not"},
    {"IndexNoNumber", square + "f 1 2 x\n", "", "t.obj:5: face index 'x' is not a whole number"},
    {"IndexFraction", square + "f 1 2 3.5\n", "", "t.obj:5: face index '3.5' is not a whole number"},
    {"TruncatedFace", square + "f 1 2", "", "t.obj:5: a face has 2 corners"},
    {"TruncatedVertex", square + "f 1 2 3\nv 1 2", "", "t.obj:6: a vertex has 2 coordinates"},
    {"Nan", "v nan 0 0\n" + square + "f 1 2 3\n", "", "t.obj:1: coordinate 'nan' is not finite"},
    {"Infinite", "v 0 -inf 0\n" + square + "f 1 2 3\n", "", "t.obj:1: coordinate '-inf' is not finite"},
    {"Overflow", "v 0 1e999 0\n" + square + "f 1 2 3\n", "", "t.obj:1: coordinate '1e999' is not finite"},
    {"DiagonalOverflows", "v -1e308 0 0\nv 1.7e308 0 0\nv 0 1 0\nf 1 2 3\n", "", "too large for double precision"},
    {"NoNumber", "v 1,5 0 0\n" + square + "f 1 2 3\n", "", "t.obj:1: coordinate '1,5' is not a number"},
    {"BowTie", square + "o wall\nf 1 3 2 4\n", "", "t.obj:6: face of 'wall' crosses or touches itself"},
    {"LopsidedBowTie", "v 0 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 0 0.5 0\nf 1 2 3 4 5\n", "", "crosses or touches itself"},
    {"Spike", square + "v 2 0 0\nf 1 5 2 3 4\nf 1 2 5 2 3 4\n", "", "crosses or touches itself"},
    {"WhiteReflectance", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 1 1 1\n",
     "t.obj:7: material 'w': reflectance (Kd) 1 is outside [0, 1)"},
    {"NegativeReflectance", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 0.1 -0.1 0.1\n",
     "reflectance (Kd) -0.1 is outside [0, 1)"},
    {"NanReflectance", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 0.1 nan 0.1\n",
     "is outside [0, 1)"},
    {"NegativeExitance", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 0 0 0\nKe 1 1 -2\n",
     "material 'w': exitance (Ke) -2 is negative"},
    {"InfiniteExitance", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 0 0 0\nKe 1e999 0 0\n",
     "exitance (Ke) inf is negative or not finite"},
    {"KdNoNumber", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 0.1 red 0.1\n",
     "m:2: Kd 'red' is not a number"},
    {"KdTwoValues", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "newmtl w\nKd 0.1 0.2\n", "m:2: Kd has 2 values"},
    {"KdOutside", "mtllib m\nusemtl w\n" + square + "f 1 2 3\n", "Kd 0.1 0.2 0.3\n", "m:1: Kd stands before any newmtl"},
};

class BadInputs : public testing::TestWithParam<Bad> {};

TEST_P(BadInputs, AreRefusedInOneLine) { EXPECT_THAT(refusal(GetParam().obj, GetParam().mtl), HasSubstr(GetParam().message)); }

INSTANTIATE_TEST_SUITE_P(ReadObj, BadInputs, testing::ValuesIn(bad_inputs), [](const auto &p) { return p.param.what; });

TEST(ReadObj, FilesThatCannotBeReadAreRefused) {
    const auto folder = std::filesystem::temp_directory_path() / "penumbra-refuse-test";
    std::filesystem::create_directories(folder);
    const auto message = [](const std::filesystem::path &file) -> std::string {
        try {
            read_obj(file);
        } catch (const BadInput &e) {
            return e.what();
        }
        return "taken";
    };
    EXPECT_THAT(message(folder), HasSubstr("is a folder"));
    EXPECT_THAT(message(folder / "none.obj"), HasSubstr("cannot be opened: No such file"));
    std::ofstream(folder / "binary.obj", std::ios::binary).write("v 0 0\0 1", 8);
    EXPECT_THAT(message(folder / "binary.obj"), HasSubstr("is not a text file (byte 5 is zero)"));
    std::ofstream(folder / "large.obj").close();
    std::filesystem::resize_file(folder / "large.obj", largest_obj + 1);
    EXPECT_THAT(message(folder / "large.obj"), HasSubstr("is longer than the limit of 256 MiB"));
    std::filesystem::remove_all(folder);
}

TEST(ReadObj, UnusedMaterialsMayBeAnything) {
    EXPECT_EQ(scene_of("mtllib m\nusemtl w\n" + square + "f 1 2 3 4\n", "newmtl w\nKd 0.5 0.5 0.5\nnewmtl x\nKd 1 1 1\n")
                  .n_surfaces(),
              1);
}

} // namespace
} // namespace penumbra
