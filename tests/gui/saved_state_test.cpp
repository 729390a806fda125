// States in the window: saved, opened again, dropped, and given on the command line.
#include "gui/session.h"

#include "capture.h"

#include <gtest/gtest.h>

#include <fstream>

namespace penumbra::gui {
namespace {

/// What a state brings back. The keyhole's point and the camera are the same to the last bit.
constexpr const char *kept[] = {"scene",   "options",  "position", "strategies",   "layout",    "active",
                                "camera",  "layers",   "curves",   "keyhole",      "shading",   "error",
                                "profile", "exposure", "range",    "false_colour", "background"};

void expect_same_view(const Json &a, const Json &b) {
    for (const char *key : kept)
        EXPECT_EQ(a[key], b[key]) << key;
}

/// Four panes of another scene, two phases on, seen from elsewhere, with the keyhole open.
Json unusual_view(Session &session) {
    for (const char *key : {"ctrl+4", "shift+Right", "shift+Right", "l", "v", "t", "o", "f", "k"}) {
        session.key(key);
        session.settled();
    }
    session.wait_until("two phases",
                       [](const Json &s) { return s["panes"].size() == 4 && s["panes"][3]["computed"] == 2; });
    return session.settled();
}

TEST(SavedStates, AStateBringsTheViewBack) {
    std::filesystem::path kept_file, picture;
    Json view;
    {
        Session session({"skew-blockers", "--threshold", "0.05"});
        view = unusual_view(session);
        EXPECT_EQ(view["layout"], "four");
        EXPECT_EQ(view["position"], 2);
        EXPECT_FALSE(view["keyhole"].is_null());
        session.key("ctrl+s");
        const Json saved = session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; });
        EXPECT_EQ(saved["saved"], (session.home() / "Pictures/penumbra-1.penumbra.json").string());
        session.key("F12");
        const Json taken = session.wait_until("the picture", [](const Json &s) { return s["picture"] != ""; });
        // The session's home goes with it.
        kept_file =
            std::filesystem::temp_directory_path() / ("penumbra-kept-" + std::to_string(::getpid()) + ".penumbra.json");
        picture = std::filesystem::temp_directory_path() / ("penumbra-kept-" + std::to_string(::getpid()) + ".png");
        std::filesystem::copy_file(saved["saved"].get<std::string>(), kept_file);
        std::filesystem::copy_file(taken["picture"].get<std::string>(), picture);
    }
    {
        Session session({kept_file.string()});
        session.wait_until("two phases",
                           [](const Json &s) { return s["panes"].size() == 4 && s["panes"][3]["computed"] == 2; });
        expect_same_view(view, session.settled());
    }
    Session session; // on another scene
    session.drop(picture);
    session.wait_until("the scene", [](const Json &s) { return s["scene"] == "skew-blockers"; });
    session.wait_until("two phases",
                       [](const Json &s) { return s["panes"].size() == 4 && s["panes"][3]["computed"] == 2; });
    view["layers"]["fresh"] = false; // pictures do not point at what is new
    expect_same_view(view, session.settled());
    // And from there a picture, which is the same but for the seconds.
    session.key("F12");
    const Json taken = session.wait_until("the picture", [](const Json &s) { return s["picture"] != ""; });
    const Image before = read_png(picture), after = read_png(taken["picture"].get<std::string>());
    ASSERT_EQ(before.width, after.width);
    ASSERT_EQ(before.height, after.height);
    std::size_t n = 0;
    for (std::size_t i = 0; i < before.rgb.size(); ++i)
        n += before.rgb[i] != after.rgb[i];
    EXPECT_LT(static_cast<double>(n) / static_cast<double>(before.rgb.size()), 0.003);
    std::filesystem::remove(kept_file);
    std::filesystem::remove(picture);
}

TEST(SavedStates, ABadStateIsOneLineAndTheOldViewStays) {
    Session session;
    const Json before = session.settled();
    const auto file = session.home() / "bad.penumbra.json";
    std::ofstream(file) << R"({"scene": "furnace", "camera": {"eye": [0, 0, 1], "target": [0, 0, 1]}})";
    session.drop(file);
    const Json after = session.wait_until("the line", [](const Json &s) { return s["message_is_error"] == true; });
    EXPECT_NE(after["message"].get<std::string>().find("camera has its eye in its target"), std::string::npos);
    EXPECT_EQ(after["message"].get<std::string>().find('\n'), std::string::npos);
    expect_same_view(before, after);
}

} // namespace
} // namespace penumbra::gui
