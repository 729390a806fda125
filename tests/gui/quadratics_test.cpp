// Constants drawn as quadratics, beside the constants.
#include "gui/session.h"

#include <gtest/gtest.h>

namespace penumbra::gui {
namespace {

bool drawn(const Json &s, bool quadratics) {
    return s["panes"].size() == 2 && s["panes"][1].value("reconstructed", !quadratics) == quadratics && !s["busy"];
}

TEST(Quadratics, StandBesideTheConstantsWithTheirOwnErrorAndFollowSteps) {
    Session session({"slanted-edge", "--threshold", "0.1"});
    for (const char *key : {"n", "ctrl+2", "2", "shift+Tab", "2", "shift+Tab", "End"}) {
        session.key(key);
        session.settled();
    }
    const Json plain = session.wait_until(
        "two solutions", [](const Json &s) { return drawn(s, false) && s["panes"][1].value("converged", false); }, 120);
    EXPECT_EQ(plain["panes"][0]["patches"], plain["panes"][1]["patches"]);
    EXPECT_EQ(plain["panes"][0]["direct_error"], plain["panes"][1]["direct_error"]);
    const Screenshot before = session.shot();
    session.key("q");
    const Json smooth = session.wait_until("quadratics", [](const Json &s) { return drawn(s, true); });
    EXPECT_EQ(smooth["panes"][0]["reconstructed"], false);
    EXPECT_EQ(smooth["panes"][1]["patches"], plain["panes"][1]["patches"]);
    EXPECT_LT(smooth["panes"][1]["direct_error"].get<double>(), 0.2 * plain["panes"][1]["direct_error"].get<double>());
    session.settled();
    Box scene = session.widget("pane 1"); // without its label, which changes too
    scene.y += scene.height / 3;
    scene.height /= 2;
    EXPECT_GT(changed_share(before, session.shot(), scene), 0.01);
    EXPECT_EQ(changed_share(before, session.shot(), session.widget("pane 0")), 0);
    // They are made anew for another step, and another strategy's pane is its own again.
    session.key("Left");
    const Json back = session.wait_until("the step before", [&](const Json &s) {
        return drawn(s, true) && s["panes"][1]["version"] != smooth["panes"][1]["version"];
    });
    EXPECT_EQ(back["reconstructed"], Json::array({false, true}));
    session.key("4");
    session.wait_until("multiwavelets", [](const Json &s) { return drawn(s, false); });
    EXPECT_EQ(session.state()["reconstructed"], Json::array({false, false}));
}

} // namespace
} // namespace penumbra::gui
