// Which file is what, and where a state finds its scene again.
#include "files/open_file.h"

#include "capture.h"
#include "core/error.h"
#include "files/read_state.h"
#include "files/write_state.h"
#include "scene/bundled.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OpenFile : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-open-" + std::to_string(::getpid()));
        fs::create_directories(folder / "scenes");
        fs::create_directories(folder / "states");
        write("scenes/square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    }
    void TearDown() override { fs::remove_all(folder); }
    std::string write(const std::string &name, const std::string &text) const {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    }
    /// A state of the scene, in a file of that name.
    std::string save(const std::string &name, const Scene &scene, SavedState state = {}) const {
        state.scene = scene.name;
        state.file = place_of(scene, (folder / name).parent_path());
        state.up = up_axis(scene);
        return write(name, state_text(state));
    }
    static std::string refusal(const std::string &name) {
        try {
            open_file(name);
        } catch (const BadInput &e) {
            EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
            EXPECT_THAT(e.what(), testing::StartsWith(name));
            return e.what();
        }
        ADD_FAILURE() << name << " was taken";
        return "";
    }
    fs::path folder;
};

TEST_F(OpenFile, ScenesAreAsBefore) {
    EXPECT_EQ(open_file("figure-4").scene->name, "figure-4");
    EXPECT_FALSE(open_file("figure-4").state);
    EXPECT_EQ(open_file((folder / "scenes/square.obj").string()).scene->n_surfaces(), 1);
    EXPECT_THAT(refusal("nothing.png"), HasSubstr("there is no such file"));
    EXPECT_THAT(refusal("nothing.penumbra.json"), HasSubstr("there is no such file"));
}

TEST_F(OpenFile, StatesFindTheirSceneFromWhereTheyLie) {
    const Scene scene = open_scene((folder / "scenes/square.obj").string(), Vec3::UnitX());
    const std::string file = save("states/a.penumbra.json", scene);
    OpenedFile opened = open_file(file);
    ASSERT_TRUE(opened.state);
    EXPECT_EQ(opened.state->file, "../scenes/square.obj");
    EXPECT_EQ(opened.scene->name, "square");
    EXPECT_EQ(opened.scene->up, Vec3::UnitX());
    EXPECT_EQ(open_file(file, Vec3::UnitY()).scene->up, Vec3::UnitY()) << "what is asked for holds";

    // Both moved together.
    fs::create_directories(folder / "elsewhere");
    fs::rename(folder / "scenes", folder / "elsewhere/scenes");
    EXPECT_THAT(refusal(file),
                HasSubstr("its scene is not there (" + (folder / "scenes/square.obj").string() + "); put it"));
    fs::rename(folder / "states", folder / "elsewhere/states");
    EXPECT_EQ(open_file((folder / "elsewhere/states/a.penumbra.json").string()).scene->name, "square");
}

TEST_F(OpenFile, PlacesAreRelativeWhereTheyCanBe) {
    Scene scene;
    const auto place = [&](const char *file, const char *in) {
        scene.file = file;
        return place_of(scene, in);
    };
    EXPECT_EQ(place("", "/none/a"), "");
    EXPECT_EQ(place("/none/a/s.obj", "/none/a"), "s.obj");
    EXPECT_EQ(place("/none/a/b/s.obj", "/none/a/"), "b/s.obj");
    EXPECT_EQ(place("/none/a/../b/s.obj", "/none/c"), "../b/s.obj");
    EXPECT_EQ(place("/other/s.obj", "/none/a"), "/other/s.obj");
    fs::create_directory_symlink(folder / "scenes", folder / "states/link");
    const std::string file = (folder / "scenes/square.obj").string();
    EXPECT_EQ(place(file.c_str(), (folder / "states/link").c_str()), "square.obj");
}

/// The name of a bundled scene is not taken from the folder that the program happens to be in.
TEST_F(OpenFile, BundledScenesAreTheProgramsOwn) {
    const std::string file = save("states/a.penumbra.json", open_scene("furnace"));
    EXPECT_TRUE(open_file(file).state->file.empty());
    write("states/furnace", "v 0 0 0\n");
    const fs::path before = fs::current_path();
    fs::current_path(folder / "states");
    EXPECT_EQ(open_file(file).scene->n_surfaces(), open_bundled_scene("furnace")->n_surfaces());
    fs::current_path(before);
    const std::string old = write("states/old.penumbra.json", R"({"scene": "furnace", "file": "furnace.obj"})");
    EXPECT_EQ(open_file(old).scene->name, "furnace");
    EXPECT_THAT(refusal(write("b.JSON", R"({"scene": "castle"})")), HasSubstr("'castle' is none of the bundled ones"));
}

TEST_F(OpenFile, PicturesAreToldByNameOrContent) {
    EXPECT_THAT(refusal(write("a.png", "GIF89a")), HasSubstr("is no PNG"));
    const std::string plain = (folder / "plain.png").string();
    write_png(plain, {1, 1, {1, 2, 3}});
    EXPECT_THAT(refusal(plain), HasSubstr("holds no state; open a picture that Penumbra wrote"));
    const std::string renamed = (folder / "renamed.picture").string();
    write_png(renamed, {1, 1, {1, 2, 3}}, R"({"scene": "figure-4", "position": 5})");
    EXPECT_EQ(open_file(renamed).state->position, 5);
}

TEST_F(OpenFile, SurfacesThatThereAreNotAreSaid) {
    SavedState state;
    state.look.curve_filter.source = 1;
    EXPECT_THAT(refusal(save("a.penumbra.json", open_scene((folder / "scenes/square.obj").string()), state)),
                HasSubstr("curves.source is 1; the scene has 1 surfaces"));
}

TEST_F(OpenFile, AFifoOrAFolderInTheScenesPlaceIsNotOpened) {
    EXPECT_THAT(refusal(write("a.penumbra.json", R"({"scene": "x", "file": "/dev/zero"})")), HasSubstr("is not there"));
    EXPECT_THAT(refusal(write("b.penumbra.json", R"({"scene": "x", "file": "scenes"})")), HasSubstr("is not there"));
    EXPECT_THAT(refusal((folder / "scenes").string()), HasSubstr("is a folder"));
}

} // namespace
} // namespace penumbra
