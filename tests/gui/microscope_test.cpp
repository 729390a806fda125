// The filter microscope: what it shows is the picked split's, in both bases, and the maps answer the mouse.
#include "gui/session.h"

#include "iteration/solver.h"
#include "iteration/split_filters.h"
#include "render/camera.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>

namespace penumbra::gui {
namespace {

double largest(const Eigen::MatrixXd &m) { return m.cwiseAbs().maxCoeff(); }

/// The window's solution, from a solver of our own, and where its points are on the screen.
class MicroscopeTest : public testing::Test {
protected:
    explicit MicroscopeTest(BasisFamily basis = BasisFamily::parametric, const std::string &scene = "skew-blockers",
                            int n_steps = 4)
        : session({scene, "--basis", std::string(name(basis))}) {
        Options options;
        options.basis = basis;
        Solver solver(std::make_shared<const Scene>(open_scene(scene)), options);
        for (int k = 0; k < n_steps; ++k) {
            solver.step();
            session.key("Right");
        }
        snapshot = solver.snapshot();
        session.wait_until("the steps", [&](const Json &s) { return s["position"] == 3 * n_steps; });
        session.settled();
        session.key("t");
        session.wait_until("the microscope", [](const Json &s) { return s["inspector"] == "filters"; });
        session.settled();
    }

    Point on_screen(const Vec3 &p) {
        const Json s = session.state();
        const auto vector = [](const Json &v) {
            return glm::dvec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
        };
        const Camera c{vector(s["camera"]["eye"]), vector(s["camera"]["target"]), vector(s["camera"]["up"]),
                       s["camera"]["fov"].get<double>()};
        const Box pane = session.widget("pane 0");
        const auto at = place_in_frame(c, static_cast<double>(pane.width) / pane.height, {p.x(), p.y(), p.z()});
        return {pane.x + (0.5 + 0.5 * at->x) * pane.width, pane.y + (0.5 - 0.5 * at->y) * pane.height};
    }
    /// The largest patch whose parent was cut, and a point in its middle.
    int cut_patch() const {
        int best = -1;
        double most = 0;
        for (int p = 0; p < static_cast<int>(snapshot->patches.size()); ++p) {
            const SnapshotPatch &patch = snapshot->patches[static_cast<std::size_t>(p)];
            if (patch.surface == 0 && patch.place.split >= 0 && area(patch.corners) > most &&
                snapshot->splits[static_cast<std::size_t>(patch.place.split)].kind == SplitKind::cut) {
                most = area(patch.corners);
                best = p;
            }
        }
        return best;
    }
    Point middle_of(int patch) {
        const SnapshotSurface &s = snapshot->surfaces[0];
        const Vec2 p = centroid(snapshot->patches[static_cast<std::size_t>(patch)].corners);
        return on_screen(s.origin + p.x() * s.u + p.y() * s.v);
    }
    void expect_shown(const Json &m, int split, int piece) const {
        const SplitFilters own = split_filters(*snapshot, split);
        EXPECT_EQ(m["kind"], own.kind == SplitKind::cut ? "cut" : "uniform");
        EXPECT_EQ(m["pieces"].get<std::size_t>(), own.pieces.size());
        EXPECT_EQ(m["piece"], piece);
        const PieceFilters &p = own.pieces[static_cast<std::size_t>(piece)];
        EXPECT_NEAR(m["share"].get<double>(), p.share, 1e-12);
        EXPECT_NEAR(m["difference"].get<double>(), largest(p.difference), 1e-12);
        EXPECT_NEAR(m["loss"].get<double>(), largest(own.loss), 1e-12);
    }
    /// Clicks the patch and checks that its split is shown.
    void pick(int patch) {
        const SnapshotPlace place = snapshot->patches[static_cast<std::size_t>(patch)].place;
        const double share = split_filters(*snapshot, place.split).pieces[static_cast<std::size_t>(place.piece)].share;
        session.click(middle_of(patch));
        const Json s = session.wait_until("its split", [&](const Json &now) {
            return now["microscope"].contains("share") && now["microscope"]["outward"] == 0 &&
                   std::abs(now["microscope"]["share"].get<double>() - share) < 1e-9;
        });
        expect_shown(s["microscope"], place.split, place.piece);
        EXPECT_EQ(s["microscope"]["splits"].get<std::size_t>(), splits_above(*snapshot, patch).size());
    }

    Session session;
    std::shared_ptr<const Snapshot> snapshot;
};

class PlanarMicroscopeTest : public MicroscopeTest {
protected:
    PlanarMicroscopeTest() : MicroscopeTest(BasisFamily::planar) {}
};

TEST_F(MicroscopeTest, AClickShowsTheSplitThatMadeThePatch) {
    const int patch = cut_patch();
    ASSERT_GE(patch, 0);
    pick(patch);
    // The other child, by its button and by the sketch.
    const int split = snapshot->patches[static_cast<std::size_t>(patch)].place.split;
    for (const int piece : {0, 1, 0}) {
        const std::string number = std::to_string(piece + 1);
        session.click(piece == 1 ? "split sketch piece " + number : "microscope.piece " + number);
        const Json s =
            session.wait_until("piece " + number, [&](const Json &now) { return now["microscope"]["piece"] == piece; });
        expect_shown(s["microscope"], split, piece);
    }
}

TEST_F(MicroscopeTest, OutwardAndBack) {
    int patch = -1;
    for (int p = 0; p < static_cast<int>(snapshot->patches.size()); ++p)
        if (splits_above(*snapshot, p).size() >= 2 &&
            (patch < 0 || area(snapshot->patches[static_cast<std::size_t>(p)].corners) >
                              area(snapshot->patches[static_cast<std::size_t>(patch)].corners)))
            patch = p;
    ASSERT_GE(patch, 0);
    pick(patch);
    const std::vector<int> above = splits_above(*snapshot, patch);
    session.click("microscope.outward");
    const Json s = session.wait_until("outward", [](const Json &now) { return now["microscope"]["outward"] == 1; });
    expect_shown(s["microscope"], above[1], snapshot->splits[static_cast<std::size_t>(above[0])].place.piece);
    session.click("microscope.inward");
    session.wait_until("inward", [](const Json &now) { return now["microscope"]["outward"] == 0; });
}

TEST_F(MicroscopeTest, AClickOnACurveIsAClickOnItsPatch) {
    // Curves are dense where cuts are: what is meant is the patch.
    const auto curve = std::ranges::find_if(*snapshot->curves, [&](const SnapshotCurve &c) {
        return c.receiver == 0 && c.points.size() == 2 && (c.points[1] - c.points[0]).norm() > 0.3;
    });
    ASSERT_NE(curve, snapshot->curves->end());
    const Point at = on_screen((curve->points[0] + curve->points[1]) / 2);
    session.move(at);
    session.wait_until("a curve", [](const Json &s) { return s["hovered_curve"].is_number(); });
    session.click(at);
    session.settled();
    EXPECT_TRUE(session.state()["pinned_curve"].is_null());
    EXPECT_EQ(session.state()["microscope"]["surface"], 0);
    session.key("t");
    session.wait_until("closed", [](const Json &s) { return s["inspector"] == "none"; });
    session.settled();
    session.click(on_screen((curve->points[0] + curve->points[1]) / 2)); // the pane is wider now
    session.wait_until("pinned", [](const Json &s) { return s["pinned_curve"].is_number(); });
}

class RoomMicroscopeTest : public MicroscopeTest {
protected:
    RoomMicroscopeTest() : MicroscopeTest(BasisFamily::parametric, "cornell-box", 2) {}
};

TEST_F(RoomMicroscopeTest, WhereNothingIsSplitItOffersTheLargestCut) {
    const auto light =
        std::ranges::find_if(snapshot->surfaces, [](const auto &s) { return s.exitance.maxCoeff() > 0; });
    ASSERT_NE(light, snapshot->surfaces.end());
    const Vec2 p = centroid(light->outline);
    session.click(on_screen(light->origin + p.x() * light->u + p.y() * light->v));
    session.wait_until("no split", [](const Json &s) {
        return !s["microscope"].contains("share") && s["widgets"].contains("microscope.largest");
    });
    session.click("microscope.largest");
    const Json s = session.wait_until("a cut", [](const Json &now) { return now["microscope"].contains("share"); });
    double largest_area = 0, found = -1;
    for (std::size_t i = 0; i < snapshot->splits.size(); ++i)
        if (const SnapshotSplit &split = snapshot->splits[i];
            split.kind == SplitKind::cut && area(split.corners) > largest_area) {
            largest_area = area(split.corners);
            found = static_cast<double>(i);
        }
    ASSERT_GE(found, 0);
    const SplitFilters own = split_filters(*snapshot, static_cast<int>(found));
    EXPECT_EQ(s["microscope"]["kind"], "cut");
    EXPECT_NEAR(s["microscope"]["loss"].get<double>(), largest(own.loss), 1e-12);
}

TEST_F(MicroscopeTest, TheMouseReadsTheMaps) {
    const int patch = cut_patch();
    pick(patch);
    const SnapshotPlace place = snapshot->patches[static_cast<std::size_t>(patch)].place;
    const SplitFilters own = split_filters(*snapshot, place.split);
    const PieceFilters &piece = own.pieces[static_cast<std::size_t>(place.piece)];
    for (const auto &[map, matrix] : {std::pair<std::string, const Eigen::MatrixXd &>{"push", piece.push},
                                      {"pull", piece.pull},
                                      {"difference", piece.difference},
                                      {"loss", own.loss}}) {
        const Box box = session.widget("map " + map);
        for (const auto &[row, column] : {std::pair{5, 2}, {15, 13}}) {
            session.move({box.x + (column + 0.5) * box.width / 16, box.y + (row + 0.5) * box.height / 16});
            const std::string place_words = map + " " + std::to_string(row) + " " + std::to_string(column) + " ";
            const Json s = session.wait_until(place_words, [&](const Json &now) {
                return now["microscope"]["reading"].get<std::string>().starts_with(place_words);
            });
            const double value = std::stod(s["microscope"]["reading"].get<std::string>().substr(place_words.size()));
            EXPECT_NEAR(value, matrix(row, column), 0.006 * std::abs(matrix(row, column)) + 1e-12) << place_words;
        }
    }
}

TEST_F(MicroscopeTest, TheScreenShowsTheFilters) {
    // Bright squares for 0, and both ends of the scale; in the difference map too, for this cut is slanted.
    pick(cut_patch());
    ASSERT_GT(session.state()["microscope"]["difference"].get<double>(), 1e-3);
    session.move({300, 20});
    const Screenshot shot = session.shot();
    for (const char *map : {"map push", "map pull", "map difference"}) {
        const Box box = session.widget(map);
        EXPECT_GT(share_of(shot, box, {236, 229, 224}, 12), 0.1) << map;
        const auto has = [&](auto ends) {
            for (int y = box.y; y < box.y + box.height; ++y)
                for (int x = box.x; x < box.x + box.width; ++x)
                    if (ends(shot.at(x, y)))
                        return true;
            return false;
        };
        EXPECT_TRUE(has([](const Colour &c) { return c[0] > c[2] + 60; })) << map << ": nothing above 0";
        EXPECT_TRUE(has([](const Colour &c) { return c[2] > c[0] + 60; })) << map << ": nothing below 0";
    }
}

TEST_F(PlanarMicroscopeTest, EveryCutKeepsTheRelationAndLosesNothing) {
    pick(cut_patch());
    const Json m = session.state()["microscope"];
    EXPECT_EQ(m["basis"], "planar");
    EXPECT_LE(m["difference"].get<double>(), 1e-12);
    EXPECT_LE(m["loss"].get<double>(), 1e-12);
    // And is drawn as 0: one colour, however small the rounding is that is left.
    session.move({300, 20});
    const Screenshot shot = session.shot();
    for (const char *map : {"map difference", "map loss"})
        EXPECT_GT(share_of(shot, session.widget(map), {236, 229, 224}, 2), 0.7) << map;
    EXPECT_LT(share_of(shot, session.widget("map push"), {236, 229, 224}, 2), 0.7);
}

TEST(Microscope, SaysWhenNothingHasBeenSplit) {
    Session session({"skew-blockers"});
    session.key("t");
    Json s = session.wait_until("the microscope", [](const Json &now) { return now["inspector"] == "filters"; });
    session.settled();
    EXPECT_FALSE(session.state()["microscope"].contains("share"));
    for (int k = 0; k < 3; ++k)
        session.key("Right");
    session.wait_until("the largest cut by itself", [](const Json &now) {
        return now["position"] == 9 && now["microscope"].contains("share") && now["microscope"]["kind"] == "cut";
    });
    session.settled();
    session.key("Escape");
    session.wait_until("closed", [](const Json &now) { return now["inspector"] == "none"; });
}

} // namespace
} // namespace penumbra::gui
