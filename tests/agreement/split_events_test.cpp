// What a refinement says it did, replayed over the mesh before.
#include "iteration/split_event.h"

#include "discontinuity/curve.h"
#include "geometry/polygon.h"
#include "iteration/after_splits.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace penumbra {
namespace {

/// A patch's surface and corners, to the last bit.
using Shape = std::pair<int, std::vector<std::pair<double, double>>>;
using Mesh = std::multiset<Shape>;

Shape shape(int surface, const std::vector<Vec2> &corners) {
    Shape s{surface, {}};
    for (const Vec2 &p : corners)
        s.second.emplace_back(p.x(), p.y());
    return s;
}

Mesh mesh_of(const Snapshot &snapshot) {
    Mesh mesh;
    for (const SnapshotPatch &p : snapshot.patches)
        mesh.insert(shape(p.surface, p.corners));
    return mesh;
}

/// Takes an element out of the mesh and puts its pieces there, those of a piece that was cut at once in its place.
void replay(const Snapshot &snapshot, int split, Mesh &mesh) {
    const SnapshotSplit &s = snapshot.splits[static_cast<std::size_t>(split)];
    const auto found = mesh.find(shape(s.surface, s.corners));
    ASSERT_NE(found, mesh.end()) << "split " << split << " is of no patch that is there";
    mesh.erase(found);
    double whole = 0;
    for (const SnapshotPiece &piece : s.pieces) {
        mesh.insert(shape(s.surface, piece.corners));
        whole += area(piece.corners);
    }
    EXPECT_NEAR(whole, area(s.corners), 1e-12 * area(s.corners));
    for (std::size_t c = 0; c < s.pieces.size(); ++c)
        for (std::size_t i = 0; i < snapshot.splits.size(); ++i) {
            const SnapshotSplit &below = snapshot.splits[i];
            const bool at_once = std::ranges::none_of(*snapshot.events, [&](const SnapshotEvent &e) { return e.split == static_cast<int>(i); });
            if (at_once && below.place.split == split && below.place.piece == static_cast<int>(c))
                replay(snapshot, static_cast<int>(i), mesh);
        }
}

/// The largest difference, over the patches of `one`, of the radiosities at their centroids.
double difference(const Snapshot &one, const Snapshot &other) {
    double most = 0;
    for (const SnapshotPatch &p : one.patches) {
        const Vec2 at = centroid(p.corners);
        const auto around = std::ranges::find_if(other.patches, [&](const SnapshotPatch &q) {
            if (q.surface != p.surface)
                return false;
            for (std::size_t k = 0; k < q.corners.size(); ++k) {
                const Vec2 side = q.corners[(k + 1) % q.corners.size()] - q.corners[k], off = at - q.corners[k];
                if (side.x() * off.y() - side.y() * off.x() < 0)
                    return false;
            }
            return true;
        });
        if (around == other.patches.end())
            return 1e300;
        most = std::max(most, (radiosity(one, p, at) - radiosity(other, *around, at)).abs().maxCoeff());
    }
    return most;
}

struct Case {
    std::string scene;
    Strategy strategy;
    BasisFamily basis;
};

void expect_honest_events(const Case &c) {
    SCOPED_TRACE(c.scene + " " + std::string(name(c.strategy)) + " " + std::string(name(c.basis)));
    Options options;
    options.strategy = c.strategy;
    options.basis = c.basis;
    options.threshold = 0.03;
    options.max_depth = 4;
    Solver solver(std::make_shared<const Scene>(open_scene(c.scene)), options);
    int n_seen = 0, n_cuts = 0;
    for (int iteration = 0; iteration < 5 && !solver.ended(); ++iteration) {
        const auto before = solver.snapshot();
        EXPECT_EQ(n_events(*before), 0);
        solver.sub_step();
        const auto after = solver.snapshot();
        const Counters &counters = solver.counters();
        ASSERT_EQ(n_events(*after), counters.splits);
        EXPECT_EQ(std::ranges::count_if(*after->events, &SnapshotEvent::cut), counters.cuts);

        Mesh mesh = mesh_of(*before);
        const auto start = after_splits(*after, 0);
        EXPECT_EQ(mesh_of(*start), mesh);
        EXPECT_EQ(start->counters.patches, before->counters.patches);
        EXPECT_EQ(start->counters.coefficients, before->counters.coefficients);
        std::set<std::uint64_t> versions{before->version, after->version, start->version};
        const int n = n_events(*after), every = std::max(1, n / 7);
        for (int k = 0; k < n; ++k) {
            const SnapshotEvent &event = (*after->events)[static_cast<std::size_t>(k)];
            replay(*after, event.split, mesh);
            if (::testing::Test::HasFatalFailure())
                return;
            EXPECT_EQ(mesh.count(shape(event.element.surface, event.element.corners)), 0u);
            EXPECT_GT(event.misfit, event.threshold);
            EXPECT_DOUBLE_EQ(event.threshold, counters.threshold);
            n_cuts += event.cut;
            if ((k + 1) % every != 0 && k + 1 != n)
                continue;
            const auto partial = after_splits(*after, k + 1);
            EXPECT_EQ(mesh_of(*partial), mesh) << "after split " << k + 1;
            EXPECT_EQ(partial->counters.splits, k + 1);
            EXPECT_EQ(partial->sentence, event.sentence);
            EXPECT_EQ(std::ranges::count_if(partial->patches, &SnapshotPatch::fresh), event.n_pieces);
            // Before the gather all pieces have their parent's light; a bilinear piece of a cut quad as nearly as it can.
            const bool exact = c.basis == BasisFamily::planar || is_constant(c.strategy) || n_cuts == 0;
            EXPECT_LT(difference(*after, *partial), (exact ? 1e-9 : 0.01) * std::max(1.0, after->peak));
            versions.insert(partial->version);
        }
        EXPECT_EQ(mesh, mesh_of(*after));
        EXPECT_EQ(versions.size(), 3u + static_cast<std::size_t>(n == 0 ? 0 : n / every + (n % every != 0)));
        n_seen += n;
        solver.sub_step();
        EXPECT_EQ(n_events(*solver.snapshot()), 0) << "a gather splits nothing";
        EXPECT_EQ(mesh_of(*solver.snapshot()), mesh);
        solver.sub_step();
    }
    EXPECT_GT(n_seen, 3);
    EXPECT_EQ(n_cuts > 0, cuts_along_curves(c.strategy));
}

TEST(SplitEvents, ReplayTheRefinement) {
    for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar})
        for (const Strategy strategy : all_strategies) {
            expect_honest_events({"slanted-edge", strategy, basis});
            expect_honest_events({"cornell-box", strategy, basis});
        }
}

TEST(SplitEvents, HaveTheLinksOfTheirPiecesAndOfTheirElement) {
    Options options;
    options.threshold = 0.03;
    Solver solver(std::make_shared<const Scene>(open_scene("cornell-box")), options);
    int n_seen = 0;
    for (int iteration = 0; iteration < 4; ++iteration) {
        const auto before = solver.state();
        solver.sub_step();
        const auto state = solver.state();
        const auto after = solver.snapshot();
        std::vector<int> links(state->interactions.size());
        for (std::size_t e = 0; e < links.size(); ++e)
            for (const auto &interaction : state->interactions[e])
                links[e] += static_cast<int>(interaction->links.size());
        std::vector<int> made(links.size());
        for (const LinkEvent &event : state->events->links)
            made[event.receiver.at()] += event.n_links;
        for (std::size_t e = before->interactions.size(); e < links.size(); ++e)
            EXPECT_EQ(made[e], links[e]) << "a new element has new links alone";
        int kept = 0, now = 0;
        for (std::size_t e = 0; e < before->interactions.size(); ++e) {
            EXPECT_LE(made[e], links[e]);
            kept += links[e];
        }
        const auto start = after_splits(*after, 0);
        for (const SnapshotEvent &event : *after->events)
            now += static_cast<int>(event.links.size());
        EXPECT_EQ(static_cast<int>(start->links.size()), kept + now);
        EXPECT_EQ(start->counters.links, kept + now);
        EXPECT_EQ(after->links.size(), static_cast<std::size_t>(std::accumulate(links.begin(), links.end(), 0)));
        EXPECT_EQ(after_splits(*after, n_events(*after))->links.size(), after->links.size());
        n_seen += n_events(*after);
        solver.sub_step();
        EXPECT_EQ(solver.state()->events, nullptr);
        solver.sub_step();
    }
    EXPECT_GT(n_seen, 10);
}

void expect_words(const std::string &scene) {
    SCOPED_TRACE(scene);
    Options options;
    options.threshold = 0.01;
    Solver solver(std::make_shared<const Scene>(open_scene(scene)), options);
    std::set<CurveKind> kinds;
    for (int iteration = 0; iteration < 4; ++iteration) {
        solver.sub_step();
        const auto snapshot = solver.snapshot();
        for (const SnapshotEvent &event : *snapshot->events) {
            const auto called = [&](int surface) {
                const std::string &name = snapshot->surfaces[static_cast<std::size_t>(surface)].name;
                return name.empty() ? "surface " + std::to_string(surface) : name;
            };
            EXPECT_TRUE(event.sentence.starts_with(called(event.element.surface) + ", element ")) << event.sentence;
            const bool dark = event.sentence.find(" falls below black by ") != std::string::npos;
            EXPECT_EQ(dark, event.misfit <= event.threshold) << event.sentence;
            EXPECT_NE(dark, event.sentence.find("what " + called(event.source) + " brings") != std::string::npos) << event.sentence;
            EXPECT_NE(event.sentence.find("> 1 %"), std::string::npos) << event.sentence;
            if (event.curve < 0) {
                EXPECT_NE(event.sentence.find("; split in four"), std::string::npos) << event.sentence;
                continue;
            }
            const SnapshotCurve &curve = (*snapshot->curves)[static_cast<std::size_t>(event.curve)];
            const auto kind = static_cast<CurveKind>(curve.kind);
            kinds.insert(kind);
            EXPECT_EQ(curve.receiver, event.element.surface);
            const auto tail = event.sentence.substr(event.sentence.find("; ") + 2);
            EXPECT_TRUE(tail.starts_with("cut along the " + std::string(name(kind)) + " curve of ")) << tail;
            for (const SnapshotEdge &edge : curve.touched)
                EXPECT_NE(tail.find(edge.surface < 0 ? "a blocker" : called(edge.surface)), std::string::npos) << tail;
        }
        solver.sub_step();
        solver.sub_step();
    }
    EXPECT_TRUE(kinds.contains(CurveKind::ev) || kinds.contains(CurveKind::ve));
}

TEST(SplitEvents, SayWhatHappened) {
    for (const char *scene : {"slanted-edge", "cornell-box", "table"})
        expect_words(scene);
}

} // namespace
} // namespace penumbra
