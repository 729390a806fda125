// The lecture that comes with the program, played in the window without its pauses.
#include "gui/session.h"

#include "capture.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace penumbra::gui {
namespace {

const std::string script = PENUMBRA_SOURCE_DIR "/assets/lectures/ten-minutes.txt";

/// Names after `picture` and `window`, in their order, and all seconds of its waits.
struct Course {
    std::vector<std::string> pictures;
    double seconds = 0;
    int last_line = 0;
};

Course course() {
    Course out;
    std::ifstream in(script);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        std::istringstream words(line);
        std::string word, value;
        if (!(words >> word) || word.front() == '#')
            continue;
        out.last_line = number;
        words >> value;
        if (word == "picture" || word == "window")
            out.pictures.push_back(value);
        if (word == "wait")
            out.seconds += std::stod(value);
    }
    return out;
}

TEST(Lecture, TakesTenMinutesAndShowsWhatItSays) {
    const Course plan = course();
    EXPECT_NEAR(plan.seconds, 600, 120);
    ASSERT_GE(plan.pictures.size(), 8u);
    const auto folder = std::filesystem::path(testing::TempDir()) / "lecture-pictures";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    Session session({"--pictures", folder.string(), "--pace", "0", "--script", script});
    const Json end = session.wait_until("the end", [&](const Json &s) {
        return s["script"]["line"] == plan.last_line && s["script"]["playing"] == false;
    }, 300);
    EXPECT_EQ(end["message_is_error"], false) << end["message"];
    EXPECT_EQ(end["scene"], "cornell-box");
    EXPECT_EQ(end["panes"][0]["converged"], true);

    std::map<std::string, Json> states;
    for (const std::string &name : plan.pictures) {
        SCOPED_TRACE(name);
        const Image image = read_png(folder / name);
        EXPECT_GT(image.width, 600);
        const auto state = read_png_state(folder / name);
        ASSERT_TRUE(state);
        states[name] = Json::parse(*state);
    }
    EXPECT_EQ(states["compare.png"]["strategies"], (Json{"uniform-constant", "discontinuity-wavelet"}));
    EXPECT_EQ(states["compare.png"]["converged"], true);
    EXPECT_EQ(states["errors.png"]["shading"], "error");
    EXPECT_FALSE(states["keyhole.png"]["keyhole"].is_null());
    EXPECT_FALSE(states["profile.png"]["profile"].is_null());
    EXPECT_EQ(states["first-step.png"]["position"], 3);
    EXPECT_EQ(states["cut.png"]["phase"], "refine");
    EXPECT_EQ(states["four.png"]["strategies"].size(), 4u);
    EXPECT_EQ(states["table.png"]["scene"], "table");
    EXPECT_NE(states["table.png"]["caption"], "");
}

} // namespace
} // namespace penumbra::gui
