// Split by split through a refinement, and what was there before.
#include "gui/session.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace penumbra::gui {
namespace {

/// But for the number of keys pressed.
Json seen(Json state) {
    state.erase("inputs");
    return state;
}

void expect_same(const Screenshot &a, const Screenshot &b, const std::string &what) {
    EXPECT_TRUE(a.pixels == b.pixels) << what;
}

/// At a position, with so many splits shown; none: all.
Json wait_for(Session &session, int position, const Json &split) {
    return session.wait_until("position " + std::to_string(position) + ", split " + split.dump(), [&](const Json &s) {
        return s["position"] == position && s["split"] == split && s["busy"] == false;
    });
}

/// Four splits in the second iteration, and in the third.
const std::vector<std::string> room{"cornell-box", "--threshold", "0.03"};

/// The refinement of the second iteration, all splits shown, new patches not made to stand out for a while.
Json at_second_refinement(Session &session) {
    session.key("n");
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["position"] == 3 && s["panes"][0]["computed"] == 3; });
    session.key("shift+Right");
    const Json s = wait_for(session, 4, nullptr);
    EXPECT_GT(s["splits"], 2) << "the test needs a refinement with a middle";
    return s;
}

TEST(Splits, ComeOneByOneAndGoBackTheSameWay) {
    Session session(room);
    const Json whole = at_second_refinement(session);
    const int n = whole["splits"].get<int>();
    session.key("shift+Left");
    const Json before = wait_for(session, 3, nullptr);
    std::vector<Json> states;
    std::vector<Screenshot> shots;
    std::set<std::string> sentences;
    for (int k = 1; k <= 3; ++k) {
        session.key("ctrl+Right");
        wait_for(session, 4, k);
        states.push_back(seen(session.settled()));
        shots.push_back(session.shot());
        EXPECT_GT(states.back()["panes"][0]["patches"],
                  k == 1 ? before["panes"][0]["patches"] : states[states.size() - 2]["panes"][0]["patches"]);
        const auto sentence = states.back()["message"].get<std::string>();
        EXPECT_NE(sentence.find(" misses what "), std::string::npos) << sentence;
        EXPECT_TRUE(sentences.insert(sentence).second) << "said twice: " << sentence;
        EXPECT_TRUE(session.state()["widgets"].contains("splits"));
        if (k > 1) {
            EXPECT_FALSE(shots[shots.size() - 2].pixels == shots.back().pixels) << "nothing is seen of split " << k;
        }
    }
    for (int k = 2; k >= 1; --k) {
        session.key("ctrl+Left");
        wait_for(session, 4, k);
        EXPECT_EQ(seen(session.settled()), states[static_cast<std::size_t>(k - 1)]);
        expect_same(session.shot(), shots[static_cast<std::size_t>(k - 1)], "split " + std::to_string(k) + " again");
    }
    session.key("ctrl+Left");
    EXPECT_EQ(wait_for(session, 3, nullptr)["panes"][0]["patches"], before["panes"][0]["patches"]);
    // Beyond the last split lies the gather; back from there, the last split.
    session.key("ctrl+Right");
    wait_for(session, 4, 1);
    for (int k = 2; k <= n; ++k) {
        session.key("ctrl+Right");
        wait_for(session, 4, k);
    }
    EXPECT_EQ(session.state()["panes"][0]["patches"], whole["panes"][0]["patches"]);
    session.key("ctrl+Right");
    wait_for(session, 5, nullptr);
    session.key("ctrl+Left");
    wait_for(session, 4, n);
    session.key("shift+Right");
    wait_for(session, 5, nullptr);
}

TEST(Splits, ATickIsGoneTo) {
    Session session(room);
    const int n = at_second_refinement(session)["splits"].get<int>();
    const Box row = session.widget("splits");
    const auto tick = [&](int k) { return Point{row.x + row.width * (k - 0.5) / n, row.y + 0.5 * row.height}; };
    session.click(tick(2));
    wait_for(session, 4, 2);
    session.drag(tick(2), tick(n));
    wait_for(session, 4, n);
}

TEST(Splits, TheNextCutIsFoundThroughAllPhases) {
    Session session({"--strategy", "discontinuity-wavelet", "--threshold", "0.02"});
    session.key("ctrl+shift+Right");
    const Json first = session.wait_until("a cut", [](const Json &s) { return !s["split"].is_null(); });
    EXPECT_EQ(first["phase"], "refine");
    EXPECT_NE(first["message"].get<std::string>().find("cut along the "), std::string::npos) << first["message"];
    const auto place = [](const Json &s) { return std::pair(s["position"].get<int>(), s["split"].is_null() ? 1 << 30 : s["split"].get<int>()); };
    std::pair<int, int> last = place(first);
    for (int i = 0; i < 1000; ++i) {
        session.key("ctrl+shift+Right");
        const Json now = session.wait_until("the next cut", [&](const Json &s) {
            return s["busy"] == false && s["seeking"] == false &&
                   (place(s) > last || s["message"].get<std::string>().starts_with("No cut"));
        });
        if (now["split"].is_null()) {
            EXPECT_EQ(now["message"], "No cut along a curve follows up to the end of this solution.");
            EXPECT_EQ(now["panes"][0]["converged"], true);
            return;
        }
        EXPECT_NE(now["message"].get<std::string>().find("cut along the "), std::string::npos) << now["message"];
        last = place(now);
    }
    ADD_FAILURE() << "there is no end of cuts";
}

TEST(Splits, UniformMeshingHasNoCut) {
    Session session({"--strategy", "uniform-wavelet", "--threshold", "0.05"});
    session.key("ctrl+shift+Right");
    const Json s = session.wait_until("the end", [](const Json &j) { return j["message"].get<std::string>().starts_with("No cut"); });
    EXPECT_EQ(s["panes"][0]["converged"], true);
    EXPECT_EQ(s["seeking"], false);
}

TEST(Splits, PlayingShowsThem) {
    Session session(room);
    session.key("comma");
    session.wait_until("a slower pace", [](const Json &s) { return s["speed"] == 1; });
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["panes"][0]["computed"] == 3; });
    session.key("Left");
    session.key("shift+Right");
    session.key("shift+Right");
    session.key("shift+Right");
    session.wait_until("position 3", [](const Json &s) { return s["position"] == 3; });
    session.key("space");
    std::set<int> shown;
    session.wait_until("the gather", [&](const Json &s) {
        if (s["position"] == 4 && !s["split"].is_null())
            shown.insert(s["split"].get<int>());
        return s["position"] == 5;
    });
    session.key("space");
    EXPECT_GE(shown.size(), 1u) << "splits stand alone while a refinement is played";
    session.key("j");
    session.key("Left");
    wait_for(session, 3, nullptr);
    session.key("space");
    shown.clear();
    session.wait_until("the gather", [&](const Json &s) {
        if (!s["split"].is_null())
            shown.insert(s["split"].get<int>());
        return s["position"] == 5;
    });
    EXPECT_TRUE(shown.empty()) << "switched off";
}

TEST(Splits, BeforeIsWhatWasBeforeTheLastStep) {
    Session session(room);
    session.key("n");
    session.key("Right");
    session.wait_until("a step", [](const Json &s) { return s["panes"][0]["computed"] == 3; });
    const Json one = session.settled();
    session.key("Right");
    session.wait_until("two steps", [](const Json &s) { return s["panes"][0]["computed"] == 6; });
    const Json two = session.settled();
    const Screenshot shot = session.shot();
    session.hold("b");
    const Json held = session.wait_until("before", [](const Json &s) { return s["before"] == true; });
    EXPECT_EQ(held["panes"][0]["version"], one["panes"][0]["version"]);
    EXPECT_EQ(held["position"], 6) << "where we stand has not changed";
    session.let_go("b");
    session.wait_until("now", [](const Json &s) { return s["before"] == false; });
    EXPECT_EQ(seen(session.settled()), seen(two));
    expect_same(session.shot(), shot, "as it was");
    session.hold(session.middle("view.before"));
    EXPECT_EQ(session.wait_until("before, by mouse", [](const Json &s) { return s["before"] == true; })["panes"][0]["version"],
              one["panes"][0]["version"]);
    session.let_go();
    session.wait_until("now", [](const Json &s) { return s["before"] == false; });
    // In a refinement it is the split before.
    session.key("ctrl+Right");
    const Json first = session.wait_until("a split or a phase", [](const Json &s) { return s["position"] == 7 && s["busy"] == false; });
    ASSERT_GT(first["splits"], 1);
    session.key("ctrl+Right");
    wait_for(session, 7, 2);
    session.hold("b");
    EXPECT_EQ(session.wait_until("before", [](const Json &s) { return s["before"] == true; })["panes"][0]["version"],
              first["panes"][0]["version"]);
    session.let_go("b");
    wait_for(session, 7, 2);
}

TEST(Splits, PanesShowTheirOwn) {
    Session session(room);
    session.key("ctrl+2");
    session.key("Right");
    session.wait_until("both", [](const Json &s) {
        return s["position"] == 3 && s["panes"].size() == 2 && s["panes"][0]["computed"] == 3 && s["panes"][1]["computed"] == 3;
    });
    session.key("ctrl+Right");
    session.wait_until("both", [](const Json &s) { return s["panes"][0]["split"] == 1 && s["panes"][1]["split"] == 1; });
    session.key("ctrl+Right");
    session.wait_until("both", [](const Json &s) { return s["panes"][0]["split"] == 2 && s["panes"][1]["split"] == 2; });
}

TEST(Links, FollowTheSplitsOneByOneAndGoBackTheSameWay) {
    Session session(room);
    const Json whole = at_second_refinement(session);
    const int n = whole["splits"].get<int>(), n_links = whole["linkings"].get<int>();
    ASSERT_GT(n_links, 10);
    const auto at_link = [&](const Json &k) {
        return session.wait_until("link " + k.dump(), [&](const Json &s) {
            return s["position"] == 4 && s["linking"] == k && s["busy"] == false;
        });
    };
    session.key("ctrl+Left");
    wait_for(session, 4, n - 1);
    std::vector<Json> states;
    std::vector<Screenshot> shots;
    for (int k = 1; k <= 3; ++k) {
        session.key("ctrl+Down");
        at_link(k);
        states.push_back(seen(session.settled()));
        shots.push_back(session.shot());
        EXPECT_EQ(states.back()["split"], nullptr);
        EXPECT_EQ(states.back()["panes"][0]["patches"], whole["panes"][0]["patches"]) << "all splits are made";
        EXPECT_LT(states.back()["panes"][0]["links"], whole["panes"][0]["links"]);
        const auto sentence = states.back()["message"].get<std::string>();
        EXPECT_NE(sentence.find(": linked to "), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("; links of an element above it failed"), std::string::npos) << sentence;
    }
    EXPECT_GT(states[1]["panes"][0]["links"], states[0]["panes"][0]["links"]);
    EXPECT_FALSE(shots[0].pixels == shots[1].pixels);
    for (int k = 2; k >= 1; --k) {
        session.key("ctrl+Up");
        at_link(k);
        EXPECT_EQ(seen(session.settled()), states[static_cast<std::size_t>(k - 1)]);
        expect_same(session.shot(), shots[static_cast<std::size_t>(k - 1)], "link " + std::to_string(k));
    }
    session.key("ctrl+Up");
    wait_for(session, 4, n);
    session.key("ctrl+Down");
    at_link(1);
    session.click("linkings");
    const Json middle = session.wait_until("the middle", [](const Json &s) { return s["linking"] > 3; });
    EXPECT_NEAR(middle["linking"].get<double>(), n_links / 2.0, 0.05 * n_links + 1);
    session.key("ctrl+s");
    const auto file = session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; })["saved"].get<std::string>();
    session.key("shift+Right");
    session.wait_until("the gather", [](const Json &s) { return s["position"] == 5 && s["linking"] == nullptr; });
    session.drop(file);
    const Json again = session.wait_until("it", [&](const Json &s) { return s["linking"] == middle["linking"] && s["busy"] == false; });
    EXPECT_EQ(session.settled()["panes"][0]["links"], middle["panes"][0]["links"]);
    EXPECT_EQ(again["position"], 4);
}

TEST(Links, TheNextOfTheLastIsTheFirstOfTheNextRefinement) {
    Session session(room);
    session.key("ctrl+Down");
    const Json first = session.wait_until("the first", [](const Json &s) { return s["position"] == 1 && s["linking"] == 1 && s["panes"][0]["linking"] == 1; });
    EXPECT_EQ(first["splits"], 0) << "the first refinement links alone";
    const int n = first["linkings"].get<int>();
    for (int k = 2; k <= n; ++k)
        session.key("ctrl+Down");
    session.wait_until("the last", [&](const Json &s) { return s["linking"] == n; });
    session.key("ctrl+Down");
    session.wait_until("the next refinement", [](const Json &s) { return s["position"] == 4 && s["linking"] == 1; });
}

TEST(Splits, AStateAndAPictureBringThemBack) {
    std::filesystem::path state, picture;
    Json view;
    const auto keep = [](const std::string &file, const char *as) {
        const auto to = std::filesystem::temp_directory_path() / ("penumbra-split-" + std::to_string(::getpid()) + as);
        std::filesystem::copy_file(file, to, std::filesystem::copy_options::overwrite_existing);
        return to;
    };
    {
        Session session(room);
        const int n = at_second_refinement(session)["splits"].get<int>();
        session.key("ctrl+Left");
        wait_for(session, 4, n - 1);
        session.key("ctrl+Left");
        wait_for(session, 4, n - 2);
        view = session.settled();
        session.key("ctrl+s");
        state = keep(session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; })["saved"], ".penumbra.json");
        session.key("F12");
        picture = keep(session.wait_until("the picture", [](const Json &s) { return s["picture"] != ""; })["picture"], ".png");
    }
    for (const auto &file : {state, picture}) {
        Session session({file.string()});
        session.wait_until("the split", [&](const Json &s) { return s["split"] == view["split"]; });
        const Json now = session.settled();
        EXPECT_EQ(now["position"], view["position"]);
        EXPECT_EQ(now["panes"][0]["patches"], view["panes"][0]["patches"]);
        EXPECT_EQ(now["message"], view["message"]);
    }
    std::filesystem::remove(state);
    std::filesystem::remove(picture);
}

} // namespace
} // namespace penumbra::gui
