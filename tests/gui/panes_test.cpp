// Two strategies in one place: wiped over one another, flipped, and subtracted; and panes side by side with views of their own.
#include "gui/session.h"

#include "render/error_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <array>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace penumbra::gui {
namespace {

/// Share of the box' pixels that are not the very same.
double share_that_differs(const Screenshot &a, const Screenshot &b, const Box &box) {
    std::size_t n = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x)
            n += a.at(x, y) != b.at(x, y);
    return static_cast<double>(n) / std::max(1, box.width * box.height);
}

/// Coarse solutions by (a) and (d) of a scene on which they differ, on one range, without lines and legend: all places are
/// as large.
class PanesTest : public testing::Test {
protected:
    PanesTest() {
        for (const char *key : {"n", "g", "m", "d", "1", "End"})
            press(key);
        solved();
        press("k");
        session.move({4, 500});
        of_a = session.shot();
        press("4");
        press("End");
        solved();
        of_d = session.shot();
        pane = session.widget("pane 0");
    }

    void press(const char *key) {
        session.key(key);
        session.settled();
    }
    Json solved() {
        return session.wait_until("solutions", [](const Json &s) {
            return !s["busy"] && std::ranges::all_of(s["panes"], [](const Json &p) { return p.value("converged", false); });
        }, 120);
    }
    Json enter(const char *key, const char *layout) {
        EXPECT_NE(session.state()["layout"], layout);
        session.key(key);
        session.wait_until(layout, [&](const Json &s) { return s["layout"] == layout; });
        press("End"); // of both
        return solved();
    }
    /// Of the pane, between two shares of its width; below labels and clear of the divider and of the frame.
    Box part(double from, double to) const {
        const int left = pane.x + static_cast<int>(from * pane.width) + 24, right = pane.x + static_cast<int>(to * pane.width) - 24;
        return {left, pane.y + 90, right - left, pane.height - 130};
    }
    Point at(double x, double y) const { return {std::round(pane.x + x * pane.width), std::round(pane.y + y * pane.height)}; }
    Json under(Point p) {
        session.move({4, 500});
        session.wait_until("no patch", [](const Json &s) { return s["under_cursor"].is_null(); }, 10);
        session.move(p);
        return session.wait_until("a patch", [](const Json &s) { return !s["under_cursor"].is_null() && s["under_cursor"]["patch"] >= 0; },
                                  10)["under_cursor"];
    }
    void drag_divider(double to) {
        Point p = session.middle("divider");
        p.y += 60;
        session.move(p);
        session.wait_until("the mouse on the divider", [](const Json &s) { return s["told"]["control"] == "divider"; }, 10);
        session.hold(p);
        session.wait_until("it is held", [](const Json &s) { return s["told"]["control"] == ""; }, 10);
        session.move({pane.x + to * pane.width, p.y});
        const double share = std::clamp(to, 0.0, 1.0);
        session.wait_until("the divider follows", [&](const Json &s) { return std::abs(s["wipe"].get<double>() - share) < 2.0 / pane.width; });
        session.let_go();
        session.move({4, 500});
        session.settled();
    }
    /// Left of the share it is (a), right of it (d).
    void expect_wiped_at(double share) {
        const Screenshot now = session.shot();
        EXPECT_EQ(share_that_differs(of_a, now, part(0, share)), 0);
        EXPECT_EQ(share_that_differs(of_d, now, part(share, 1)), 0);
        EXPECT_GT(share_that_differs(of_d, now, part(0, share)), 0.05) << "they look the same: nothing is proven";
        EXPECT_GT(share_that_differs(of_a, now, part(share, 1)), 0.05);
    }

    Session session{{"slanted-edge", "--threshold", "0.2"}}; // patches are far larger than what the map interpolates over
    Screenshot of_a, of_d;
    Box pane;
};

TEST_F(PanesTest, TheWipeShowsOneStrategyOnEachSideOfItsDivider) {
    const Json s = enter("w", "wipe");
    EXPECT_EQ(s["strategies"], Json::array({"uniform-constant", "discontinuity-wavelet"}));
    EXPECT_EQ(s["wipe"], 0.5);
    expect_wiped_at(0.5);
    drag_divider(0.35);
    EXPECT_EQ(session.state()["camera"], s["camera"]) << "the view was turned in place of it";
    expect_wiped_at(session.state()["wipe"]);
    session.key("ctrl+z");
    session.wait_until("undone", [](const Json &now) { return now["wipe"] == 0.5 && now["layout"] == "wipe"; });
    expect_wiped_at(0.5);
    session.key("ctrl+z");
    session.wait_until("undone", [](const Json &now) { return now["layout"] == "single"; });
    session.key("w");
    session.wait_until("the wipe", [](const Json &now) { return now["layout"] == "wipe"; });
    session.settled();
    drag_divider(-0.2); // beyond the pane
    EXPECT_EQ(session.state()["wipe"], 0.0);
    EXPECT_EQ(share_that_differs(of_d, session.shot(), part(0, 1)), 0);
}

TEST_F(PanesTest, TheMouseIsOverTheSolutionThatIsSeenThere) {
    const Point p = at(0.45, 0.6);
    const Json of_second = under(p)["radiosity"];
    press("1");
    press("End");
    solved();
    const Json of_first = under(p)["radiosity"];
    EXPECT_NE(of_first, of_second);
    press("4");
    enter("w", "wipe");
    EXPECT_EQ(under(p)["radiosity"], of_first);
    session.click(p);
    session.wait_until("the left one is active", [](const Json &s) { return s["active"] == 0; });
    drag_divider(0.3);
    EXPECT_EQ(under(p)["radiosity"], of_second);
    session.click(p);
    session.wait_until("the right one is active", [](const Json &s) { return s["active"] == 1; });
}

TEST_F(PanesTest, FlipsChangeOnePictureForTheOtherInPlace) {
    const Json first = enter("shift+w", "flip");
    EXPECT_EQ(first["active"], 1);
    for (const int active : {0, 1, 0}) {
        session.move({4, 500});
        session.key("shift+w");
        session.wait_until("the other", [&](const Json &s) { return s["active"] == active && s["layout"] == "flip"; });
        const Screenshot now = session.shot();
        EXPECT_EQ(share_that_differs(active == 0 ? of_a : of_d, now, part(0, 1)), 0);
        EXPECT_GT(share_that_differs(active == 0 ? of_d : of_a, now, part(0, 1)), 0.05);
    }
    // The label is its own as well.
    const Box label{pane.x + 4, pane.y + 4, 400, 40};
    EXPECT_EQ(share_that_differs(of_a, session.shot(), label), 0);
    EXPECT_GT(share_that_differs(of_d, session.shot(), label), 0.01);
}

/// Mean radiosity of the fixed point there, by the command line.
double solved_radiosity(const Session &session, const std::string &strategy, const Json &point) {
    const auto in = session.folder() / "probe.csv", out = session.folder() / (strategy + ".csv");
    std::ofstream(in) << "x,y,z,nx,ny,nz\n"
                      << std::setprecision(17) << point[0].get<double>() << ',' << point[1].get<double>() << ','
                      << point[2].get<double>() << ",0,0,1\n";
    output_of({PENUMBRA_PROGRAM, "solve", "slanted-edge", "-q", "--strategy", strategy, "--threshold", "0.2", "--probe",
               in.string(), "--probe-output", out.string(), "-o", (session.folder() / "record.json").string()},
              {});
    std::ifstream file(out);
    std::string line;
    std::getline(file, line);
    std::getline(file, line);
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    std::array<double, 9> row{};
    for (double &x : row)
        numbers >> x;
    EXPECT_TRUE(numbers) << line;
    return (row[6] + row[7] + row[8]) / 3;
}

TEST_F(PanesTest, TheDifferenceIsTheSecondMinusTheFirst) {
    enter("shift+d", "difference");
    const Json s = session.wait_until("the difference", [](const Json &now) { return !now["panes"][1]["error"].is_null() && !now["busy"]; });
    EXPECT_GT(s["panes"][1]["error"], 0);
    EXPECT_EQ(s["shading"], "polynomial") << "the other layouts keep their own";
    const double end = s["error"]["range"][1];
    EXPECT_EQ(s["error"]["range"][0], -end);
    int n = 0, n_right = 0;
    for (const double x : {0.36, 0.4, 0.44, 0.47})
        for (const double y : {0.5, 0.56, 0.62, 0.68}) {
            const Json now = under(at(x, y)); // on the floor
            const Json d = now["difference"];
            const double told = (d[0].get<double>() + d[1].get<double>() + d[2].get<double>()) / 3;
            if (std::abs(told) < 0.2 * end || n == 6)
                continue;
            ++n;
            SCOPED_TRACE(now.dump());
            const double known = solved_radiosity(session, "discontinuity-wavelet", now["point"]) -
                                 solved_radiosity(session, "uniform-constant", now["point"]);
            EXPECT_NEAR(told, known, 1e-9 * end);
            // The picture has that colour: the map stands between lattice points.
            session.move({4, 500});
            const Point p = at(x, y);
            const Colour drawn = session.shot().at(static_cast<int>(p.x), static_cast<int>(p.y));
            const glm::dvec3 right = 255.0 * error_colour(ErrorKind::signed_error, {-end, end}, known),
                             wrong = 255.0 * error_colour(ErrorKind::signed_error, {-end, end}, -known);
            double off = 0, off_wrong = 0;
            for (int c = 0; c < 3; ++c) {
                off = std::max(off, std::abs(drawn[static_cast<std::size_t>(c)] - right[c]));
                off_wrong = std::max(off_wrong, std::abs(drawn[static_cast<std::size_t>(c)] - wrong[c]));
            }
            n_right += off < 24;
            EXPECT_GT(off_wrong, off);
        }
    EXPECT_GE(n, 3) << "no points where they differ were found";
    EXPECT_GE(n_right, n - 1); // one may lie at a jump
    session.move({4, 500});
    const Screenshot now = session.shot();
    EXPECT_GT(changed_share(of_d, now, part(0, 1)), 0.2);
    // X is for other layouts; the lock holds the difference's own scale.
    session.key("x");
    EXPECT_EQ(session.settled()["shading"], "polynomial");
    session.key("k");
    session.wait_until("locked", [](const Json &state) { return state["error"]["locked"] == true; });
    press("ctrl+1");
    EXPECT_EQ(share_that_differs(of_d, session.shot(), part(0, 1)), 0);
}

/// What of the panes lies clear of labels and frames.
Box clear_part(const Box &b) { return {b.x + 8, b.y + 90, b.width - 16, b.height - 130}; }

TEST_F(PanesTest, UnlinkedViewsMoveAloneUntilTheyAreLinkedAgain) {
    const Json two = enter("ctrl+2", "two");
    EXPECT_EQ(two["cameras"], Json::array());
    press("shift+l");
    const Json unlinked = session.wait_until("unlinked", [](const Json &s) { return s["cameras"].size() == 2; });
    EXPECT_EQ(unlinked["cameras"][0], unlinked["cameras"][1]);
    session.move({4, 500});
    const Screenshot before = session.shot();
    const Box left = session.widget("pane 0"), right = session.widget("pane 1");
    session.hold(Point{left.x + 0.5 * left.width, left.y + 0.6 * left.height});
    session.wait_until("it is held", [](const Json &s) { return s["active"] == 0; });
    session.move({left.x + 0.7 * left.width, left.y + 0.65 * left.height});
    session.wait_until("the view turns", [&](const Json &s) { return s["cameras"][0] != unlinked["cameras"][0]; });
    session.let_go();
    session.move({4, 500});
    const Json turned = session.settled();
    EXPECT_EQ(turned["cameras"][1], unlinked["cameras"][1]);
    const Screenshot after = session.shot();
    EXPECT_EQ(share_that_differs(before, after, clear_part(right)), 0);
    EXPECT_GT(changed_share(before, after, clear_part(left)), 0.05);
    // What is saved comes back.
    session.key("ctrl+s");
    const Json saved = session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; });
    press("shift+l");
    const Json linked = session.wait_until("linked", [](const Json &s) { return s["cameras"].empty(); });
    EXPECT_EQ(linked["camera"], turned["cameras"][0]) << "the active pane's";
    session.key("ctrl+z");
    session.wait_until("undone", [&](const Json &s) { return s["cameras"] == turned["cameras"]; });
    press("shift+l");
    session.drop(saved["saved"].get<std::string>());
    session.wait_until("as it was saved", [&](const Json &s) { return s["cameras"] == turned["cameras"] && s["layout"] == "two"; });
}

TEST_F(PanesTest, UnlinkedExposureAndRangeAreThePanesOwn) {
    press("k"); // follows what is shown
    enter("ctrl+2", "two");
    EXPECT_EQ(session.state()["tones"], Json::array());
    press("shift+k");
    const Json unlinked = session.wait_until("unlinked", [](const Json &s) { return s["tones"].size() == 2; });
    EXPECT_EQ(unlinked["active"], 1);
    const Box left = clear_part(session.widget("pane 0")), right = clear_part(session.widget("pane 1"));
    session.move({4, 500});
    const Screenshot before = session.shot();
    press("e");
    press("e");
    const Json brighter = session.settled();
    EXPECT_EQ(brighter["tones"][0]["exposure"], 0.0);
    EXPECT_EQ(brighter["tones"][1]["exposure"], 1.0);
    const Screenshot bright = session.shot();
    EXPECT_EQ(share_that_differs(before, bright, left), 0);
    EXPECT_GT(changed_share(before, bright, right), 0.05);
    // The other pane's own comes with it.
    press("shift+Tab");
    press("shift+e");
    press("k");
    const Json darker = session.settled();
    EXPECT_EQ(darker["active"], 0);
    EXPECT_EQ(darker["exposure"], -0.5);
    EXPECT_EQ(darker["tones"][0]["exposure"], -0.5);
    EXPECT_EQ(darker["tones"][0]["range_chosen"], true);
    EXPECT_EQ(darker["tones"][1], brighter["tones"][1]);
    // What is saved comes back, and what is linked again has the active pane's.
    session.key("ctrl+s");
    const Json saved = session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; });
    press("shift+k");
    const Json linked = session.wait_until("linked", [](const Json &s) { return s["tones"].empty(); });
    EXPECT_EQ(linked["exposure"], -0.5);
    session.key("ctrl+z");
    session.wait_until("undone", [&](const Json &s) { return s["tones"] == darker["tones"]; });
    press("shift+k");
    session.drop(saved["saved"].get<std::string>());
    session.wait_until("as it was saved", [&](const Json &s) { return s["tones"] == darker["tones"] && s["layout"] == "two"; });
}

TEST_F(PanesTest, WhichPaneIsActiveIsNoChangeToTakeBack) {
    press("m");
    enter("shift+w", "flip");
    press("l");
    const Json before = session.settled();
    press("shift+w");
    press("shift+w");
    press("shift+w");
    const Json flipped = session.settled();
    EXPECT_NE(flipped["active"], before["active"]);
    EXPECT_EQ(flipped["changes"], before["changes"]);
    EXPECT_EQ(flipped["layers"]["links"], true);
    session.key("ctrl+z");
    session.wait_until("no links", [](const Json &s) { return s["layers"]["links"] == false && s["layout"] == "flip"; });
}

TEST_F(PanesTest, UnlinkedStepsMoveAlone) {
    press("ctrl+2");
    press("Home");
    session.wait_until("the start", [](const Json &s) { return s["position"] == 0; });
    press("shift+s");
    EXPECT_EQ(session.settled()["positions"], Json({0, 0}));
    press("Right");
    press("shift+Right");
    const Json moved = session.settled();
    EXPECT_EQ(moved["positions"], Json({0, 4}));
    EXPECT_EQ(moved["panes"][0]["iteration"], 0);
    EXPECT_EQ(moved["panes"][1]["iteration"], 2);
    EXPECT_EQ(moved["panes"][1]["phase"], "refine");
    press("shift+Tab"); // with the step of its own
    EXPECT_EQ(session.settled()["position"], 0);
    press("Right");
    press("4"); // the same strategy in both, at two steps
    const Json same = session.settled();
    EXPECT_EQ(same["positions"], Json({3, 4}));
    EXPECT_EQ(same["panes"][0]["strategy"], same["panes"][1]["strategy"]);
    EXPECT_EQ(same["panes"][0]["iteration"], 1);
    EXPECT_EQ(same["panes"][1]["iteration"], 2);
    session.key("ctrl+s");
    const Json saved = session.wait_until("the state", [](const Json &s) { return s["saved"] != ""; });
    press("w"); // one place, two steps; the left is the active one
    const Json wipe = session.settled();
    EXPECT_EQ(wipe["layout"], "wipe");
    EXPECT_EQ(wipe["positions"], Json({3, 4}));
    press("shift+s");
    const Json linked = session.settled();
    EXPECT_EQ(linked["positions"], Json::array());
    EXPECT_EQ(linked["panes"][1]["iteration"], 1) << "the active pane's";
    session.drop(saved["saved"].get<std::string>());
    session.wait_until("as it was saved", [&](const Json &s) {
        return s["positions"] == Json({3, 4}) && s["layout"] == "two" && !s["busy"] && s["panes"][1].value("iteration", 0) == 2;
    });
}

TEST_F(PanesTest, AStateBringsWipeFlipAndDifferenceBack) {
    enter("w", "wipe");
    drag_divider(0.3);
    const Json wipe = session.settled();
    const auto save = [&] {
        const Json before = session.state()["saved"];
        session.key("ctrl+s");
        return session.wait_until("a state", [&](const Json &s) { return s["saved"] != before; })["saved"].get<std::string>();
    };
    const std::string wiped = save();
    enter("shift+w", "flip");
    const std::string flipped = save();
    enter("shift+d", "difference");
    const std::string subtracted = save();
    press("ctrl+1");
    for (const auto &[file, layout] : {std::pair(wiped, "wipe"), std::pair(flipped, "flip"), std::pair(subtracted, "difference")}) {
        session.drop(file);
        session.wait_until(layout, [&, l = layout](const Json &s) { return s["layout"] == l; });
        const Json now = solved();
        EXPECT_EQ(now["strategies"], wipe["strategies"]);
        EXPECT_EQ(now["wipe"], wipe["wipe"]);
        press("ctrl+1");
    }
}

} // namespace
} // namespace penumbra::gui
