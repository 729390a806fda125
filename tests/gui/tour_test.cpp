// The cards of the first start: each does what it speaks of, whatever is shown, and closed they stay away.
#include "gui/session.h"

#include "tour.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace penumbra::gui {
namespace {

/// What holds when a card has shown what it speaks of, by card.
const std::vector<std::function<bool(const Json &)>> &shown() {
    static const std::vector<std::function<bool(const Json &)>> all{
        [](const Json &s) { return s["position"] == 3 && s["panes"][0].value("iteration", 0) == 1 && s["layers"]["mesh"] == true; },
        [](const Json &s) {
            return s["layers"]["curves"] == true && s["panes"][0].value("converged", false) &&
                   s["strategies"][0].get<std::string>().starts_with("discontinuity");
        },
        [](const Json &s) {
            return s["layout"] == "four" && s["strategies"] == Json{"uniform-constant", "discontinuity-constant",
                                                                    "uniform-wavelet", "discontinuity-wavelet"};
        },
        [](const Json &s) { return s["looking"]["open"] == true && !s["looking"]["emitters"].empty(); },
        [](const Json &s) { return s["shading"] == "error" && s["panes"][0].contains("error") && !s["panes"][0]["error"].is_null(); },
        [](const Json &s) { return s["inspector"] == "cost" && s["palette"] == true && s["panels_hidden"] == false; },
    };
    return all;
}

void go_through_all_cards(Session &session) {
    ASSERT_EQ(tour_cards().size(), shown().size());
    for (std::size_t card = 0; card < shown().size(); ++card) {
        SCOPED_TRACE("card " + std::to_string(card + 1));
        if (card > 0) {
            session.click("tour.next");
            session.wait_until("the next card", [&](const Json &s) { return s["tour"]["card"] == card; });
        }
        const Json before = session.settled();
        EXPECT_FALSE(shown()[card](before)) << "holds already: the card would prove nothing";
        session.click("tour.show");
        session.wait_until("what the card speaks of", shown()[card], 60);
        session.settled();
        if (card + 1 < shown().size()) { // the palette lies over what comes after it
            session.click("tour.show");
            session.settled();
            EXPECT_TRUE(shown()[card](session.state())) << "shown again, it is not switched off";
        }
    }
    session.key("Escape");
    session.wait_until("no palette", [](const Json &s) { return s["palette"] == false; });
}

TEST(Tour, OpensAtTheFirstStartAndClosedStaysAway) {
    const Home home;
    {
        Session session({}, 1280, 800, {.first = true, .home = home.path()});
        const Json first = session.settled();
        EXPECT_EQ(first["tour"]["open"], true);
        const Box card = session.widget("tour"), pane = session.widget("pane 0");
        EXPECT_LE(card.x + card.width, pane.x + pane.width);
        EXPECT_LE(card.y + card.height, pane.y + pane.height) << "the legend below can be read";
        EXPECT_GT(card.x, pane.x + pane.width / 2);
        EXPECT_GT(card.y, pane.y + pane.height / 2) << "nor does it lie over the label";
        session.click("tour.close");
        session.wait_until("no card", [](const Json &s) { return s["tour"]["open"] == false; });
        session.key("ctrl+q");
        EXPECT_EQ(session.program().wait(10), 0);
    }
    Session session({}, 1280, 800, {.first = true, .home = home.path()});
    EXPECT_EQ(session.settled()["tour"]["open"], false);
    session.key("shift+F1");
    session.wait_until("the first card", [](const Json &s) { return s["tour"]["open"] == true && s["tour"]["card"] == 0; });
}

TEST(Tour, EachCardShowsWhatItSpeaksOf) {
    Session session({}, 1280, 800, {.first = true});
    go_through_all_cards(session);
    session.click("tour.back");
    session.wait_until("the card before", [](const Json &s) { return s["tour"]["card"] == 4; });
}

TEST(Tour, WhateverIsShown) {
    Session session;
    // Nothing that the cards speak of can be seen, and much else lies over it.
    for (const char *key : {"1", "m", "d", "g", "x", "End", "s", "F11", "shift+F1"}) {
        session.key(key);
        session.settled();
    }
    const Json before = session.state();
    EXPECT_EQ(before["panels_hidden"], true);
    EXPECT_EQ(before["layers"]["curves"], false);
    EXPECT_EQ(before["strategies"][0], "uniform-constant");
    EXPECT_EQ(before["profiling"]["open"], true);
    go_through_all_cards(session);
}

} // namespace
} // namespace penumbra::gui
