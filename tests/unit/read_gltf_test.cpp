// The glTF reader: what exporters write is read as meant, what cannot be used is refused in one line.
#include "gltf_draft.h"

#include "core/error.h"
#include "geometry/ears.h"
#include "scene/bundled.h"

#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>

namespace penumbra {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

std::string notes_of(const Scene &scene) {
    std::string all;
    for (const std::string &note : scene.notes)
        all += note + "\n";
    return all;
}

/// A room of 4 x 3 x 5 (y up) with a unit box in it and a lamp of 1 x 1 below the ceiling.
GltfDraft box_in_a_room() {
    GltfDraft draft;
    const int white = draft.material("white", {0.7, 0.7, 0.7}), red = draft.material("red", {0.6, 0.1, 0.05}),
              lamp = draft.material("lamp", {0, 0, 0}, {12, 6, 3});
    const BoxMesh room = box_mesh({0, 0, 0}, {4, 3, 5}, true), box = box_mesh({1, 0.5, 1}, {2, 1.5, 2});
    draft.node("room", draft.mesh(room.positions, room.indices, white));
    draft.node("box", draft.mesh(box.positions, box.indices, red));
    draft.node("lamp", draft.mesh({{1, 2.5, 2}, {2, 2.5, 2}, {2, 2.5, 3}, {1, 2.5, 3}}, {0, 1, 2, 0, 2, 3}, lamp));
    return draft;
}

void expect_box_in_a_room(const Scene &scene) {
    ASSERT_EQ(scene.n_surfaces(), 13);
    EXPECT_DOUBLE_EQ(scene.own.size, std::sqrt(50.0));
    EXPECT_EQ(scene.up, Vec3(0, 1, 0));
    double area[3] = {};
    for (const Surface &s : scene.surfaces) {
        EXPECT_EQ(s.corners.size(), 4U) << s.name;
        area[s.material] += s.area * scene.own.size * scene.own.size;
    }
    EXPECT_NEAR(area[0], 2 * (4 * 3 + 3 * 5 + 5 * 4), 1e-12);
    EXPECT_NEAR(area[1], 6, 1e-12);
    EXPECT_NEAR(area[2], 1, 1e-12);
    EXPECT_EQ(scene.surfaces[0].name, "room");
    EXPECT_EQ(scene.surfaces[0].frame.normal, Vec3(1, 0, 0)) << "rooms look inwards";
    EXPECT_EQ(scene.surfaces[6].frame.normal, Vec3(-1, 0, 0)) << "boxes outwards";
    EXPECT_EQ(scene.surfaces[12].frame.normal, Vec3(0, -1, 0));
    EXPECT_NEAR(scene.exitance(SurfaceId(12))[1], 6, 1e-12);
    EXPECT_EQ(scene.reflectance(SurfaceId(6))[0], 0.6);
    EXPECT_EQ(notes_of(scene), "");
}

TEST(ReadGltf, TextBinaryAndABufferBesideAreOneScene) {
    const GltfDraft draft = box_in_a_room();
    const fs::path folder = fs::temp_directory_path() / "penumbra-gltf-test";
    fs::create_directories(folder / "data");
    std::ofstream(folder / "text.gltf") << draft.gltf();
    std::ofstream(folder / "binary.GLB", std::ios::binary) << draft.glb();
    std::ofstream(folder / "beside.gltf") << draft.gltf_beside("data/my%20room.bin");
    std::ofstream(folder / "data" / "my room.bin", std::ios::binary) << draft.bytes;
    for (const char *name : {"text.gltf", "binary.GLB", "beside.gltf"}) {
        SCOPED_TRACE(name);
        const Scene scene = open_scene((folder / name).string());
        EXPECT_EQ(scene.name, fs::path(name).stem().string());
        expect_box_in_a_room(scene);
    }
    EXPECT_EQ(open_scene((folder / "text.gltf").string(), Vec3::UnitZ()).up, Vec3(0, 0, 1));
    fs::remove_all(folder);
}

TEST(ReadGltf, BuffersOutsideTheFolderAreNotRead) {
    const GltfDraft draft = box_in_a_room();
    const fs::path folder = fs::temp_directory_path() / "penumbra-gltf-outside";
    fs::create_directories(folder / "inner");
    std::ofstream(folder / "b.bin", std::ios::binary) << draft.bytes;
    for (const std::string &uri : {std::string("../b.bin"), std::string("%2e%2e/b.bin"), std::string("..\\\\b.bin"),
                                   (folder / "b.bin").string(), "file://" + (folder / "b.bin").string()}) {
        std::ofstream(folder / "inner" / "up.gltf") << draft.gltf_beside(uri);
        try {
            read_gltf(folder / "inner" / "up.gltf");
            ADD_FAILURE() << uri;
        } catch (const BadInput &e) {
            EXPECT_THAT(e.what(), HasSubstr("outside the scene's folder"));
        }
    }
    fs::remove_all(folder);
}

TEST(ReadGltf, WhatBlenderExports) {
    // z up there: the mesh stays as it was modelled and a node turns it by -90 degrees about x. Positions are repeated
    // for normals and texture coordinates, and a primitive is made for each material.
    GltfDraft draft;
    const int white = draft.material("Material", {0.8, 0.8, 0.8}),
              glow = draft.material("Emission", {0, 0, 0}, {5, 5, 5});
    draft.json["materials"][0]["doubleSided"] = true;
    draft.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    // A plane of 2 x 2 in two triangles that share no vertex number.
    const int mesh =
        draft.mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 3, 4, 5}, white);
    nlohmann::json &primitives = draft.json["meshes"][static_cast<std::size_t>(mesh)]["primitives"];
    const int normals = draft.vec3(std::vector<Vec3>(6, Vec3(0, 0, 1))), uv = draft.vec2(6);
    primitives[0]["attributes"]["NORMAL"] = normals;
    primitives[0]["attributes"]["TEXCOORD_0"] = uv;
    const int above = draft.vec3({{-1, -1, 2}, {1, 1, 2}, {1, -1, 2}});
    primitives.push_back({{"attributes", {{"POSITION", above}}}, {"material", glow}}); // no indices
    primitives.push_back({{"attributes", {{"POSITION", above}}}, {"mode", 1}});        // edges
    const double h = std::sqrt(0.5);
    draft.json["nodes"] = {{{"name", "Plane"}, {"mesh", mesh}, {"rotation", {-h, 0, 0, h}}, {"scale", {2, 2, 2}}},
                           {{"name", "Camera"}, {"camera", 0}, {"translation", {0, 1, 10}}, {"rotation", {0, 0, 0, 1}}},
                           {{"name", "Root"}, {"children", {0, 1}}, {"translation", {100, 0, 0}}},
                           {{"name", "Unused"}, {"mesh", mesh}}};
    draft.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", std::numbers::pi / 4}, {"znear", 0.1}}}}};
    draft.json["scenes"] = {{{"nodes", {3}}}, {{"nodes", {2}}}};
    draft.json["scene"] = 1;
    draft.json["extensionsUsed"] = {"KHR_materials_emissive_strength"};
    draft.json["extensionsRequired"] = {"KHR_materials_emissive_strength"};
    draft.json["animations"] = {nlohmann::json::object()};
    const Scene scene = scene_of(draft);
    ASSERT_EQ(scene.n_surfaces(), 3) << "the floor, the lamp, and the floor's back";
    EXPECT_EQ(scene.surfaces[0].name, "Plane");
    EXPECT_EQ(scene.surfaces[0].corners.size(), 4U);
    EXPECT_NEAR((scene.surfaces[0].frame.normal - Vec3(0, 1, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR(scene.surfaces[0].area * scene.own.size * scene.own.size, 16, 1e-9);
    EXPECT_NEAR((scene.surfaces[1].frame.normal - Vec3(0, -1, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(scene.exitance(SurfaceId(1))[0], 5);
    EXPECT_TRUE(scene.surfaces[2].back);
    EXPECT_EQ(scene.surfaces[2].face, 0);
    EXPECT_NEAR((scene.own.centre - Vec3(100, 2, 0)).norm(), 0, 1e-9);
    ASSERT_TRUE(scene.view);
    EXPECT_EQ(scene.view->eye, Vec3(100, 1, 10));
    EXPECT_NEAR((scene.view->target - Vec3(100, 1, 0)).norm(), 0, 1e-9) << "looks along -z";
    EXPECT_NEAR(scene.view->fov_degrees, 45, 1e-12);
    EXPECT_THAT(notes_of(scene), HasSubstr("'animations' 1x, 'baseColorTexture' 1x, 'points and lines' 1x"));
}

TEST(ReadGltf, TheCornellBoxIsThatOfTheObj) {
    const Scene box = open_scene("cornell-box");
    GltfDraft draft;
    for (const Material &m : box.materials)
        draft.material(m.name, m.reflectance, m.exitance);
    for (const Surface &s : box.surfaces) {
        std::vector<Vec3> positions;
        for (const Vec3 &x : s.corners) {
            const Vec3 own = box.own.to_own(x);
            positions.push_back({own.x(), own.z(), -own.y()});
        }
        std::vector<int> indices;
        for (const auto &ear : cut_ears(s.outline))
            indices.insert(indices.end(), ear.begin(), ear.end());
        draft.node(s.name, draft.mesh(positions, indices, s.material));
    }
    const Scene scene = scene_of(draft);
    ASSERT_EQ(scene.n_surfaces(), box.n_surfaces());
    for (std::size_t i = 0; i < box.surfaces.size(); ++i) {
        const Surface &ours = scene.surfaces[i], &theirs = box.surfaces[i];
        EXPECT_EQ(ours.name, theirs.name);
        EXPECT_EQ(ours.corners.size(), theirs.corners.size());
        EXPECT_EQ(ours.covers.size(), theirs.covers.size());
        EXPECT_NEAR(ours.area * scene.own.size * scene.own.size / (theirs.area * box.own.size * box.own.size), 1, 1e-6);
        const Material &a = scene.materials[static_cast<std::size_t>(ours.material)];
        const Material &b = box.materials[static_cast<std::size_t>(theirs.material)];
        EXPECT_EQ(a.name, b.name);
        EXPECT_TRUE(((a.reflectance - b.reflectance).abs() < 1e-15).all());
        EXPECT_TRUE(((a.exitance - b.exitance).abs() < 1e-12).all());
    }
}

TEST(ReadGltf, MirroredNodesKeepTheirFronts) {
    GltfDraft draft;
    const BoxMesh box = box_mesh({1, 0, 0}, {2, 1, 1});
    const int node = draft.node("box", draft.mesh(box.positions, box.indices, draft.material("m", {0.5, 0.5, 0.5})));
    for (const nlohmann::json &scale :
         {nlohmann::json{-1, 1, 1}, nlohmann::json{-1, -1, 1}, nlohmann::json{-2, -1, -3}}) {
        draft.json["nodes"][static_cast<std::size_t>(node)]["scale"] = scale;
        const Scene scene = scene_of(draft);
        ASSERT_EQ(scene.n_surfaces(), 6);
        for (const Surface &s : scene.surfaces) // the box' centre is 0
            EXPECT_LT(s.frame.height(Vec3::Zero()), 0) << scale.dump();
    }
}

TEST(ReadGltf, MatricesAreByColumnsAndParentsComeFirst) {
    GltfDraft draft;
    const int mesh = draft.mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}, draft.material("m", {0.5, 0.5, 0.5}));
    draft.node("child", mesh);
    draft.json["nodes"][0]["translation"] = {1, 0, 0};
    draft.json["nodes"].push_back(
        {{"children", {0}}, {"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1}}});
    const Scene scene = scene_of(draft); // (x, y, z) -> 2 (-y, x, z) + (10, 20, 30), after x + 1
    EXPECT_NEAR((scene.own.to_own(scene.surfaces[0].corners[0]) - Vec3(10, 22, 30)).norm(), 0, 1e-12);
    EXPECT_NEAR((scene.own.to_own(scene.surfaces[0].corners[1]) - Vec3(10, 24, 30)).norm(), 0, 1e-12);
    EXPECT_NEAR((scene.own.to_own(scene.surfaces[0].corners[2]) - Vec3(8, 22, 30)).norm(), 0, 1e-12);
}

TEST(ReadGltf, StripsAndFansAreTriangles) {
    for (const int mode : {5, 6}) {
        GltfDraft draft;
        const std::vector<int> order = mode == 5 ? std::vector{0, 1, 3, 2} : std::vector{0, 1, 2, 3};
        draft.node(
            "s", draft.mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, order, draft.material("m", {0.5, 0.5, 0.5})));
        draft.json["meshes"][0]["primitives"][0]["mode"] = mode;
        const Scene scene = scene_of(draft);
        ASSERT_EQ(scene.n_surfaces(), 1) << mode;
        EXPECT_EQ(scene.surfaces[0].corners.size(), 4U);
        EXPECT_EQ(scene.surfaces[0].frame.normal, Vec3(0, 0, 1));
    }
}

TEST(ReadGltf, QuantizedPositionsAreRead) {
    GltfDraft draft; // 8 bits, normalized, every fourth byte unused
    draft.bytes = std::string("\0\0\0\0\x7f\0\0\0\0\x7f\0\0", 12);
    draft.json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 12}, {"byteStride", 4}}};
    draft.json["accessors"] = {
        {{"bufferView", 0}, {"componentType", 5120}, {"normalized", true}, {"count", 3}, {"type", "VEC3"}}};
    draft.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
    draft.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    draft.node("q", 0);
    const Scene scene = scene_of(draft);
    EXPECT_DOUBLE_EQ(scene.own.size, std::sqrt(2.0));
    EXPECT_THAT(notes_of(scene), HasSubstr("1 face without a material: grey 0.5"));
}

TEST(ReadGltf, AMaterialWithoutColourIsGreyAndAnEmitterBlack) {
    GltfDraft draft;
    const int plain = draft.material("plain", {0, 0, 0}), glow = draft.material("glow", {0, 0, 0}, {1, 2, 3});
    for (auto &m : draft.json["materials"])
        m.erase("pbrMetallicRoughness");
    draft.node("a", draft.mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}, plain));
    draft.node("b", draft.mesh({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {0, 1, 2}, glow));
    const Scene scene = scene_of(draft);
    EXPECT_EQ(scene.reflectance(SurfaceId(0))[0], 0.5);
    EXPECT_EQ(scene.reflectance(SurfaceId(1))[0], 0);
    EXPECT_THAT(notes_of(scene), HasSubstr("1 face of material 'plain' without a baseColorFactor: grey 0.5"));
}

/// The one line with which the bytes are refused.
std::string refusal(const std::string &bytes) {
    try {
        read_gltf_bytes("t.gltf", bytes, [](const std::string &) { return std::nullopt; });
    } catch (const BadInput &e) {
        EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
        EXPECT_THAT(e.what(), testing::StartsWith("t.gltf: "));
        return e.what();
    }
    ADD_FAILURE() << "was taken: " << bytes.substr(0, 2000);
    return "";
}

/// The refusal of the box in a room after `spoil`.
std::string refusal_with(const std::function<void(GltfDraft &)> &spoil) {
    GltfDraft draft = box_in_a_room();
    spoil(draft);
    return refusal(draft.gltf());
}

#define SPOIL(...) refusal_with([](GltfDraft &d) { __VA_ARGS__; })

TEST(BadGltf, NoJson) {
    EXPECT_THAT(refusal(""), HasSubstr("not valid JSON"));
    EXPECT_THAT(refusal("{\"asset\": {\"version\": \"2.0\"}, \n\n"), HasSubstr("at byte"));
    EXPECT_THAT(refusal(std::string("\0\1\2\3", 4)), HasSubstr("not valid JSON"));
    EXPECT_THAT(refusal("[]"), HasSubstr("the file is an array of 0; give an object"));
    EXPECT_THAT(refusal("{}"), HasSubstr("has no asset"));
    EXPECT_THAT(refusal(R"({"asset":{"version":"1.0"}})"), HasSubstr("asset.version is '1.0'; export it as glTF 2.0"));
    EXPECT_THAT(refusal(R"({"asset":{"version":"2.0"},"x":1e999})"), HasSubstr("beyond double precision"));
    EXPECT_THAT(refusal(R"({"asset":{"version":"2.0"}})"), HasSubstr("has no surface"));
}

TEST(BadGltf, DeepOrEndlessJson) {
    const std::string asset = R"({"asset":{"version":"2.0"},"extras":)";
    EXPECT_THAT(refusal(asset + std::string(200'000, '[')), HasSubstr("nested deeper than 64"));
    std::string nested;
    for (int i = 0; i < 200'000; ++i)
        nested += "{\"a\":";
    EXPECT_THAT(refusal(asset + nested), HasSubstr("nested deeper than 64"));
    std::string many = asset + "[0";
    for (int i = 0; i < 1'000'000; ++i)
        many += ",0";
    EXPECT_THAT(refusal(many + "]}"), HasSubstr("more than 1000000 values"));
    std::string objects = asset + "[{}"; // within the limit, and read in time
    for (int i = 0; i < 500'000; ++i)
        objects += ",{}";
    EXPECT_THAT(refusal(objects + "]}"), HasSubstr("has no surface"));
}

TEST(BadGltf, CutOffBinary) {
    const std::string glb = box_in_a_room().glb();
    for (const std::size_t n : {4UL, 11UL, 19UL, 40UL, glb.size() / 2, glb.size() - 1})
        refusal(glb.substr(0, n));
    std::string old = glb;
    old[4] = 1;
    EXPECT_THAT(refusal(old), HasSubstr("glTF version 1"));
    std::string long_chunk = glb;
    long_chunk[15] = 0x7f;
    EXPECT_THAT(refusal(long_chunk), HasSubstr("chunk 0 says"));
    std::string other = glb;
    other[16] = 'X';
    EXPECT_THAT(refusal(other), HasSubstr("not JSON"));
    const std::size_t binary = glb.find(std::string("BIN\0", 4));
    std::string no_binary = glb;
    no_binary[binary] = 'X';
    EXPECT_THAT(refusal(no_binary), HasSubstr("buffers[0] has no uri"));
}

TEST(BadGltf, IndicesOutOfRange) {
    EXPECT_THAT(SPOIL(d.json["nodes"][1]["mesh"] = 17),
                HasSubstr("nodes[1].mesh is 17, out of range; there are 3 meshes"));
    EXPECT_THAT(SPOIL(d.json["nodes"][1]["mesh"] = -1), HasSubstr("nodes[1].mesh is -1, out of range"));
    EXPECT_THAT(SPOIL(d.json["nodes"][1]["mesh"] = 0.5), HasSubstr("nodes[1].mesh is 0.5, out of range"));
    EXPECT_THAT(SPOIL(d.json["nodes"][1]["mesh"] = "box"), HasSubstr("nodes[1].mesh is 'box'; give a number"));
    EXPECT_THAT(SPOIL(d.json["meshes"][0]["primitives"][0]["material"] = 3), HasSubstr("material is 3, out of range"));
    EXPECT_THAT(SPOIL(d.json["meshes"][0]["primitives"][0]["indices"] = 99), HasSubstr("there are 6 accessors"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["bufferView"] = 99), HasSubstr("accessors[0].bufferView is 99"));
    EXPECT_THAT(SPOIL(d.json["bufferViews"][0]["buffer"] = 1), HasSubstr("there are 1 buffers"));
    EXPECT_THAT(SPOIL(d.json["scene"] = 0; d.json["scenes"] = nlohmann::json::array({{{"nodes", {7}}}})),
                HasSubstr("scenes[0].nodes[0] is 7"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["camera"] = 0), HasSubstr("there are 0 cameras"));
    EXPECT_THAT(SPOIL(d.bytes[24 * 12] = 24), HasSubstr("vertex index 24, out of range; there are 24 positions"));
}

TEST(BadGltf, BuffersAndAccessorsBeyondTheirEnds) {
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["count"] = 1'000'000), HasSubstr("reaches to byte 12000000"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["count"] = 0), HasSubstr("accessors[0].count is 0"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["count"] = 1e300), HasSubstr("accessors[0].count is 1e+300"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["byteOffset"] = 4),
                HasSubstr("accessors[0] reaches to byte 292 of a bufferView of 288"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["byteOffset"] = -4), HasSubstr("accessors[0].byteOffset is -4"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["type"] = "VEC2"), HasSubstr("'VEC2'; give VEC3"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["componentType"] = 5124), HasSubstr("5124, which glTF does not have"));
    EXPECT_THAT(SPOIL(d.json["accessors"][1]["componentType"] = 5122), HasSubstr("indices are 5121, 5123 or 5125"));
    EXPECT_THAT(SPOIL(d.json["bufferViews"][0]["byteLength"] = 100'000), HasSubstr("beyond the buffer's"));
    EXPECT_THAT(SPOIL(d.json["bufferViews"][0]["byteStride"] = 8), HasSubstr("12 bytes at a byteStride of 8"));
    EXPECT_THAT(SPOIL(d.json["accessors"][0].erase("bufferView")), HasSubstr("has no bufferView"));
    GltfDraft draft = box_in_a_room();
    std::string text = draft.gltf();
    text.replace(text.find("\"byteLength\": " + std::to_string(draft.bytes.size())), 14, "\"byteLength\": 9");
    EXPECT_THAT(refusal(text), HasSubstr("(is it whole?)"));
    EXPECT_THAT(refusal(draft.gltf_beside("gone.bin")), HasSubstr("buffers[0].uri is 'gone.bin', which is not there"));
    EXPECT_THAT(refusal(draft.gltf_beside("data:;base64,A?==")), HasSubstr("no base64"));
    EXPECT_THAT(refusal(draft.gltf_beside("%zz.bin")), HasSubstr("malformed"));
}

TEST(BadGltf, WhatIsCompressedOrUnknownIsRefused) {
    EXPECT_THAT(SPOIL(d.json["accessors"][0]["sparse"] = nlohmann::json::object()),
                HasSubstr("is sparse, which is not read"));
    EXPECT_THAT(SPOIL(d.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}),
                HasSubstr("'KHR_draco_mesh_compression', which is not read"));
    EXPECT_THAT(SPOIL(d.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = 0),
                HasSubstr("export it without compression"));
    EXPECT_THAT(SPOIL(d.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = 0),
                HasSubstr("export it without compression"));
}

TEST(BadGltf, Nodes) {
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["children"] = {1}; d.json["nodes"][1]["children"] = {0};
                      d.json["scenes"] = nlohmann::json::array({{{"nodes", {0}}}})),
                HasSubstr("nodes[0] is reached twice"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["children"] = {2}; d.json["nodes"][1]["children"] = {2}),
                HasSubstr("nodes[2] is reached twice"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["rotation"] = {0, 0, 0, 0}), HasSubstr("quaternion of length 0"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["scale"] = {1, 1}), HasSubstr("nodes[0].scale has 2 numbers; give 3"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["matrix"] = std::vector<int>(16, 1)), HasSubstr("is not affine"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["scale"] = {1e308, 1e308, 1e308}),
                HasSubstr("face of 'room' has a corner (0, inf, 0)"));
    EXPECT_THAT(SPOIL(d.json["nodes"][0]["name"] = std::string(1000, 'x')), HasSubstr("text of 1000 bytes"));
}

TEST(BadGltf, ValuesThatMakeNoSense) {
    EXPECT_THAT(SPOIL(d.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 1}),
                HasSubstr("material 'white': reflectance (baseColorFactor) 1 is outside [0, 1); give less than 1"));
    EXPECT_THAT(SPOIL(d.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5}),
                HasSubstr("has 1 values"));
    EXPECT_THAT(SPOIL(d.json["materials"][2]["emissiveFactor"] = {-1, 0, 0}), HasSubstr("exitance (emissiveFactor)"));
    EXPECT_THAT(SPOIL(const float nan = std::numeric_limits<float>::quiet_NaN(); std::memcpy(d.bytes.data(), &nan, 4)),
                HasSubstr("meshes[0].primitives[0] has a position (nan, 0, 0) that is not finite"));
    EXPECT_THAT(SPOIL(d.json["accessors"][1]["count"] = 35), HasSubstr("35 vertices, not three for each triangle"));
    EXPECT_THAT(SPOIL(d.json["cameras"] = {{{"perspective", {{"yfov", 4}}}}}; d.json["nodes"][0]["camera"] = 0),
                HasSubstr("cameras[0].perspective.yfov is 4; give an angle"));
}

TEST(BadGltf, FilesThatCannotBeReadAreRefused) {
    const fs::path folder = fs::temp_directory_path() / "penumbra-gltf-unreadable.gltf";
    fs::create_directories(folder);
    std::ofstream(folder / "empty.glb");
    const auto says = [](const fs::path &file) {
        try {
            open_scene(file.string());
        } catch (const BadInput &e) {
            return std::string(e.what());
        }
        return std::string("was taken");
    };
    EXPECT_THAT(says(folder), HasSubstr("is a folder"));
    EXPECT_THAT(says(folder / "empty.glb"), HasSubstr("not valid JSON"));
    EXPECT_THAT(says(folder / "gone.glb"), HasSubstr("there is no such file"));
    fs::remove_all(folder);
}

TEST(BadGltf, TooManyFaces) {
    // A mesh of 6 faces in 40 000 places.
    EXPECT_THAT(SPOIL(for (int i = 0; i < 40'000; ++i) d.node("n", 1)), HasSubstr("more than 200000 faces; simplify"));
}

} // namespace
} // namespace penumbra
