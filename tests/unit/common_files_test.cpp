// OBJ files in the hands of people: the ways of writing that common exporters and collections have.
#include "obj_text.h"

#include <gmock/gmock.h>

namespace penumbra {
namespace {

using testing::HasSubstr;

std::string notes_of(const Scene &scene) {
    std::string all;
    for (const std::string &note : scene.notes)
        all += note + "\n";
    return all;
}

TEST(CommonFiles, ACornellBoxOfRelativeIndices) {
    // Tabs and blanks at line ends, a group named after its material, a face that looks back at older vertices,
    // indented materials; the left wall is bent.
    const Scene scene =
        scene_of("mtllib box.mtl\n\n## Object floor\nv  -1.01  0.00   0.99\nv   1.00  0.00   0.99  \n"
                 "v   1.00  0.00  -1.04\nv  -0.99  0.00  -1.04\n\ng floor\nusemtl floor\nf -4 -3 -2 -1 \n\n"
                 "v\t-1.02  1.99   0.99\nv\t-1.02  1.99  -1.04\n\ng leftWall\nusemtl leftWall\nf -6 -3 -1 -2\n"
                 "## Object light \nv\t-0.24  1.98   0.16\nv\t-0.24  1.98  -0.22\nv\t 0.23  1.98  -0.22\n"
                 "v\t 0.23  1.98   0.16\n\n\ng light\nusemtl light\nf -4 -3 -2 -1",
                 "# mtl\nnewmtl leftWall\n\tNs 10.0000\n\tNi 1.5000\n\tillum 2\n\tKa  0.63 0.065 0.05\n"
                 "\tKd  0.63 0.065 0.05\n\tKs 0 0 0\n\tKe 0 0 0\n\nnewmtl floor\n\tKd 0.725 0.71 0.68\n"
                 "\nnewmtl light\n\tKd 0.78 0.78 0.78\n\tKe 17 12 4\n",
                 Vec3::UnitY());
    ASSERT_EQ(scene.n_surfaces(), 4) << "floor, two halves of the wall, light";
    EXPECT_EQ(scene.surfaces[1].face, 1);
    EXPECT_EQ(scene.surfaces[2].face, 1);
    EXPECT_EQ(scene.surfaces[2].name, "leftWall");
    EXPECT_EQ(scene.reflectance(SurfaceId(1))[0], 0.63);
    EXPECT_EQ(scene.exitance(SurfaceId(3))[2], 4);
    EXPECT_NEAR((scene.surfaces[3].frame.normal - Vec3(0, -1, 0)).norm(), 0, 1e-12);
    EXPECT_THAT(notes_of(scene), HasSubstr("t.obj:18: face of 'leftWall' is bent by"));
}

TEST(CommonFiles, ABlenderExport) {
    const Scene scene =
        scene_of("# Blender 3.4.1\n# www.blender.org\nmtllib cube.mtl\no Cube.001_Cube\n"
                 "v 1.000000 1.000000 -1.000000\nv 1.000000 -1.000000 -1.000000\n"
                 "v -1.000000 -1.000000 -1.000000\nv -1.000000 1.000000 -1.000000\nv 1.000000 1.000001 1.000000\n"
                 "v -1.000000 0.999999 1.000000\nvn -0.0000 -0.0000 -1.0000\nvt 0.625000 0.500000\nvt 0.375 0.5\n"
                 "s 0\nusemtl Material\nf 1/1/1 2/2/1 3/1/1 4/2/1\ns 1\nusemtl None\nf 1//1 4//1 6//1 5//1\n"
                 "o Edges\nv 0 0 5\nl 7 1\nl 1 2 3\ncstype bezier\nmg 1 0.5\n",
                 "# Blender 3.4.1 MTL File: 'None'\n\nnewmtl Material\nNs 250.000000\nKa 1.0 1.0 1.0\n"
                 "Kd 0.800000 0.800000 0.800000\nKs 0.5 0.5 0.5\nKe 0.000000 0.000000 0.000000\nNi 1.45\nd 1.0\n"
                 "illum 2\nmap_Kd C:\\\\textures\\\\a b.png\nPr 0.5\n\nnewmtl None\nKd 0.8 0.8 0.8\n");
    ASSERT_EQ(scene.n_surfaces(), 2);
    EXPECT_EQ(scene.surfaces[0].corners.size(), 4U);
    EXPECT_EQ(scene.surfaces[1].corners.size(), 4U) << "bent by a rounding of the file: flattened";
    EXPECT_EQ(scene.surfaces[0].name, "Cube.001_Cube");
    EXPECT_THAT(notes_of(scene), HasSubstr("'l' 2x"));
    EXPECT_THAT(notes_of(scene), HasSubstr("'map_Kd' 1x"));
}

TEST(CommonFiles, ASketchUpExport) {
    // Both sides written as two faces, materials with colons and brackets in their names, exponents with leading zeros,
    // numbers that begin with a dot or a plus.
    const Scene scene = scene_of("mtllib m\ng Mesh1 [Color_A06]:1 Group2\nusemtl [Color_A06]:1\nv 0 0 0\nv +1. 0 0\n"
                                 "v 1.0e+000 .5 0\nv 0 5e-01 -0\nf 1 2 3 4\nf 4 3 2 1\n",
                                 "newmtl [Color_A06]:1\nKd .25 +0.5 7.5e-001\n");
    ASSERT_EQ(scene.n_surfaces(), 2);
    EXPECT_TRUE(scene.surfaces[0].covers.empty());
    EXPECT_EQ(scene.reflectance(SurfaceId(0))[0], 0.25);
    EXPECT_EQ(scene.reflectance(SurfaceId(0))[2], 0.75);
}

TEST(CommonFiles, AVariantOfKdForEveryTaste) {
    const std::string obj = "mtllib m\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    EXPECT_EQ(scene_of(obj, "newmtl a\nKd 0.5\n").reflectance(SurfaceId(0))[2], 0.5);
    EXPECT_EQ(scene_of(obj, "newmtl a\nKd 0.1 0.2 0.3 1.0\n").reflectance(SurfaceId(0))[2], 0.3)
        << "an alpha behind it";
    EXPECT_EQ(scene_of(obj, "newmtl a\nKd 0 0 0\nKd 0.1 0.2 0.3\n").reflectance(SurfaceId(0))[0], 0.1)
        << "the last one";
    EXPECT_EQ(scene_of(obj, "newmtl a\nkd 0.1 0.2 0.3\n").reflectance(SurfaceId(0))[0], 0.5)
        << "keywords are as they are";
}

} // namespace
} // namespace penumbra
