// What a refinement says it did, replayed over the mesh before.
#include "iteration/split_event.h"

#include "core/percent.h"
#include "discontinuity/curve.h"
#include "geometry/polygon.h"
#include "iteration/after_splits.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "reference/faces.h"
#include "reference/form_factors.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
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
            EXPECT_TRUE(event.misfit > event.threshold || event.sentence.find(" falls below black by ") != std::string::npos)
                << event.sentence;
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

/// Links by their ends, to the last bit.
using Links = std::multiset<std::array<double, 6>>;

Links links_of(const std::vector<SnapshotLink> &links) {
    Links out;
    for (const SnapshotLink &l : links)
        out.insert({l.receiver.x(), l.receiver.y(), l.receiver.z(), l.source.x(), l.source.y(), l.source.z()});
    return out;
}

void take(const std::vector<SnapshotLink> &some, Links &from) {
    for (const auto &link : links_of(some)) {
        const auto found = from.find(link);
        ASSERT_NE(found, from.end()) << "a link goes that was not there";
        from.erase(found);
    }
}

std::vector<SnapshotLink> made_by(const Snapshot &snapshot, int linking) {
    std::vector<SnapshotLink> out;
    std::ranges::copy_if(snapshot.links, std::back_inserter(out), [&](const SnapshotLink &l) { return l.linking == linking; });
    return out;
}

/// Solves by a threshold, or to a tolerance, which also links anew what has become too coarse.
void expect_honest_links(const std::string &scene, const Options &options, int n_iterations, int &n_seen, int &n_replaced) {
    SCOPED_TRACE(scene);
    Solver solver(std::make_shared<const Scene>(open_scene(scene)), options);
    for (int iteration = 0; iteration < n_iterations && !solver.ended(); ++iteration) {
        const auto before = solver.snapshot();
        EXPECT_EQ(n_linkings(*before), 0);
        solver.sub_step();
        const auto after = solver.snapshot();
        Links links = links_of(before->links);
        EXPECT_EQ(links_of(after_splits(*after, 0)->links), links) << "before the first split all is as it was";
        for (int k = 0; k < n_events(*after); ++k) {
            take((*after->events)[static_cast<std::size_t>(k)].links, links);
            const auto partial = after_splits(*after, k + 1);
            EXPECT_EQ(links_of(partial->links), links) << "after split " << k + 1;
            EXPECT_EQ(partial->counters.links, static_cast<std::int64_t>(links.size()));
        }
        EXPECT_EQ(links_of(after_linkings(*after, 0)->links), links);
        const int n = n_linkings(*after), every = std::max(1, n / 20);
        std::set<std::uint64_t> versions{before->version, after->version};
        int n_versions = 2;
        for (int k = 0; k < n; ++k) {
            const SnapshotLinking &linking = (*after->linkings)[static_cast<std::size_t>(k)];
            take(linking.replaced, links);
            if (::testing::Test::HasFatalFailure())
                return;
            links.merge(links_of(made_by(*after, k)));
            n_replaced += !linking.replaced.empty();
            EXPECT_GE(linking.receiver.size(), 3u);
            if (k % every != 0 && k + 1 != n)
                continue;
            const auto partial = after_linkings(*after, k + 1);
            EXPECT_EQ(links_of(partial->links), links) << "after linking " << k + 1;
            EXPECT_EQ(partial->counters.links, static_cast<std::int64_t>(links.size()));
            EXPECT_EQ(partial->sentence, linking.sentence);
            EXPECT_EQ(mesh_of(*partial), mesh_of(*after));
            EXPECT_EQ(std::ranges::count_if(partial->patches, &SnapshotPatch::fresh), 0);
            versions.insert(partial->version);
            ++n_versions;
        }
        EXPECT_EQ(static_cast<int>(versions.size()), n_versions);
        EXPECT_EQ(links, links_of(after->links)) << "after the last one all is there";
        n_seen += n;
        solver.sub_step();
        EXPECT_EQ(solver.state()->events, nullptr);
        EXPECT_EQ(n_linkings(*solver.snapshot()), 0) << "a gather links nothing";
        solver.sub_step();
    }
}

TEST(LinkEvents, ReplayTheLinks) {
    int n_seen = 0, n_replaced = 0;
    for (const char *scene : {"slanted-edge", "cornell-box", "table"}) {
        Options options;
        options.threshold = 0.03;
        options.max_depth = 3; // where links are made anew, finer
        expect_honest_links(scene, options, 5, n_seen, n_replaced);
        expect_honest_links(scene, Options().to_tolerance(0.02), 12, n_seen, n_replaced);
    }
    EXPECT_GT(n_seen, 100);
    EXPECT_GT(n_replaced, 5);
}

TEST(LinkEvents, SayWhatWasLinked) {
    // A lamp of 2 x 1 over a floor of the same shape, in front of which a wall begins to shine one iteration later.
    const double a = 2, b = 1, c = 1.2;
    const auto scene = reference::scene_of({{{Vec3(0, 0, 0), Vec3(a, 0, 0), Vec3(a, b, 0), Vec3(0, b, 0)}},
                                            {{Vec3(0, 0, c), Vec3(0, b, c), Vec3(a, b, c), Vec3(a, 0, c)}, Rgb::Zero(), Rgb::Ones()},
                                            {{Vec3(0, b, 0), Vec3(a, b, 0), Vec3(a, b, c), Vec3(0, b, c)}}});
    Options options;
    options.threshold = 0.5; // nothing is split
    options.effects[Effect::order] = Switch::on; // nor left out
    Solver solver(scene, options);
    const auto sentences = [&] {
        solver.sub_step();
        const auto snapshot = solver.snapshot();
        std::vector<std::string> out;
        for (const SnapshotLinking &linking : *snapshot->linkings)
            out.push_back(linking.sentence);
        solver.sub_step();
        solver.sub_step();
        return out;
    };
    const auto has = [](const std::vector<std::string> &all, const std::string &start, double form_factor, const std::string &end) {
        return std::ranges::any_of(all, [&](const std::string &s) {
            return s.starts_with(start) && s.find("form factor " + percent(form_factor)) != std::string::npos && s.ends_with(end);
        });
    };
    const double across = reference::parallel_rectangles(a, b, c), to_wall = reference::perpendicular_rectangles(a, b, c);
    const std::vector<std::string> first = sentences();
    ASSERT_EQ(first.size(), 2u);
    EXPECT_TRUE(has(first, "face 0, element 0: linked to face 1, ", across, "; the first time")) << first[0];
    const std::vector<std::string> second = sentences();
    EXPECT_TRUE(has(second, "face 0, element 0: linked to face 2, ", to_wall, "; the first time")) << second[0];
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
