#include "discontinuity/sight_cells.h"

#include "discontinuity/fold.h"
#include "discontinuity/receiver_line.h"
#include "geometry/convex_pieces.h"
#include "visibility/shaft.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace penumbra {

namespace {

/// A cell is halved while it has more pairs and triples than this ...
constexpr std::size_t few_triples = 40, few_pairs = 400;
/// ... and there are at most so many edges that it pays to look which of them overlap.
constexpr std::size_t few_edges = 64;
constexpr int most_halvings = 14;

constexpr double slack = 4 * coincidence;

/// Where in the source's plane a thing is seen from a cell: bounds in four directions.
struct SeenAt {
    std::array<Interval, 4> bounds;

    static std::array<double, 4> along(const Vec2 &p) {
        constexpr double diagonal = 0.70710678118654752;
        return {p.x(), p.y(), diagonal * (p.x() + p.y()), diagonal * (p.x() - p.y())};
    }
    static SeenAt nothing() {
        SeenAt none;
        none.bounds.fill({Interval{}.high, Interval{}.low});
        return none;
    }
    void add(const Vec2 &p, double around) {
        const auto at = along(p);
        for (std::size_t k = 0; k < 4; ++k)
            bounds[k] = {std::min(bounds[k].low, at[k] - around), std::max(bounds[k].high, at[k] + around)};
    }
    bool meets(const SeenAt &o) const {
        for (std::size_t k = 0; k < 4; ++k)
            if (bounds[k].low > o.bounds[k].high || o.bounds[k].low > bounds[k].high)
                return false;
        return true;
    }
};

} // namespace

class CellDivision {
public:
    CellDivision(const Scene &scene, const SourceView &view, SightCells &out)
        : view_(view), out_(out), receiver_(scene.surface(view.receiver)) {
        for (const Facet &part : view.source_parts)
            source_.insert(source_.end(), part.corners.begin(), part.corners.end());
        source_seen_ = SeenAt::nothing();
        for (const Vec3 &c : source_)
            source_seen_.add(view.source_plane.to_plane(c), slack);
        for (const SightEdge &edge : view.edges)
            folds_.push_back(Fold::make(edge, view.facets));
    }

    void run() {
        Contents all;
        for (std::size_t i = 0; i < view_.facets.size(); ++i)
            all.facets.push_back(i);
        for (std::size_t i = 0; i < view_.edges.size(); ++i)
            all.edges.push_back(i);
        for (std::size_t i = 0; i < view_.corners.size(); ++i)
            all.corners.push_back(i);
        const PlaneFrame &source = view_.source_plane, &own = receiver_.frame;
        const HalfPlane front{source.normal.dot(own.u), source.normal.dot(own.v), source.height(own.origin)};
        Polygon inside, outside;
        for (const Polygon &part : receiver_.parts) {
            split(part, front, inside, outside);
            if (inside.size() > 2)
                divide(inside, all, 0);
        }
        out_.corners_and_edges_ = SightCells::gathered(std::move(corners_and_edges_));
        out_.edges_in_plane_ = SightCells::gathered(std::move(edges_in_plane_));
        out_.triples_ = SightCells::gathered(std::move(triples_));
        out_.planes_ = SightCells::gathered(std::move(planes_));
    }

private:
    struct Contents {
        std::vector<std::size_t> facets, edges, corners;
        std::vector<SeenAt> edges_seen, corners_seen; ///< as edges and corners
    };
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    /// What of the contents a cell has; none when all is hidden from it.
    std::optional<Contents> contents_of(std::span<const Vec3> cell, const Contents &from) const {
        const Shaft shaft(cell, receiver_.frame, source_, view_.source_plane);
        Contents here;
        for (const std::size_t f : from.facets) {
            const Facet &facet = view_.facets[f];
            if (facet.surface != view_.source && shaft.misses(facet.corners, slack))
                continue;
            if (spans_shaft(facet.corners, facet.frame, cell, source_))
                return std::nullopt;
            here.facets.push_back(f);
        }
        for (const std::size_t e : from.edges) {
            const SightEdge &edge = view_.edges[e];
            if (folds_[e] && folds_[e]->hides_from(cell))
                continue;
            const Vec3 p = edge.from(), q = edge.to();
            const auto [low, high] = shaft.part_inside(p, q, slack);
            if (low > high)
                continue;
            const SeenAt seen = seen_at(cell, p + low * (q - p), p + high * (q - p));
            if (!seen.meets(source_seen_))
                continue;
            here.edges.push_back(e);
            here.edges_seen.push_back(seen);
        }
        for (const std::size_t c : from.corners) {
            const Vec3 &at = view_.corners[c].at;
            if (const auto [low, high] = shaft.part_inside(at, at, slack); low > high)
                continue;
            const SeenAt seen = seen_at(cell, at, at);
            if (!seen.meets(source_seen_))
                continue;
            here.corners.push_back(c);
            here.corners_seen.push_back(seen);
        }
        return here;
    }

    /// The hull of where p and q are seen from the cell's corners: a point of pq is seen within it from all of the cell.
    SeenAt seen_at(std::span<const Vec3> cell, const Vec3 &p, const Vec3 &q) const {
        const PlaneFrame &plane = view_.source_plane;
        SeenAt seen = SeenAt::nothing();
        for (const Vec3 &x : cell)
            for (const Vec3 &point : {p, q}) {
                const double hx = plane.height(x), h = std::max(0.0, plane.height(point));
                if (hx - h <= 1e-3 * hx) // as far from the source as the eye: anywhere
                    return source_seen_;
                const double scale = hx / (hx - h);
                seen.add(plane.to_plane(x + scale * (point - x)), scale * slack);
            }
        return seen;
    }

    void divide(const Polygon &outline, const Contents &from, int halvings) {
        out_.check_cancel();
        std::vector<Vec3> cell;
        for (const Vec2 &p : outline)
            cell.push_back(receiver_.frame.to_space(p));
        const std::optional<Contents> here = contents_of(cell, from);
        if (!here)
            return;
        std::vector<Pair> overlapping;
        std::size_t n_triples = 0;
        const bool many = here->edges.size() > few_edges;
        if (!many || halvings == most_halvings) {
            overlapping = overlapping_edges(*here);
            n_triples = for_each_triple(*here, overlapping, [](std::size_t, std::size_t, std::size_t) {});
        }
        if (halvings < most_halvings && (many || n_triples > few_triples || overlapping.size() > few_pairs)) {
            Polygon one, other;
            split(outline, halving_line(outline), one, other);
            for (const Polygon *half : {&one, &other})
                if (half->size() > 2)
                    divide(*half, *here, halvings + 1);
            return;
        }
        record(outline, cell, *here, overlapping);
    }

    static HalfPlane halving_line(const Polygon &outline) {
        Vec2 low = outline[0], high = outline[0];
        for (const Vec2 &p : outline) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        const Vec2 middle = (low + high) / 2, size = high - low;
        return size.x() > size.y() ? HalfPlane{1, 0, -middle.x()} : HalfPlane{0, 1, -middle.y()};
    }

    bool may_meet(const Contents &c, std::size_t i, std::size_t j) const {
        const SightEdge &e = view_.edges[c.edges[i]], &f = view_.edges[c.edges[j]];
        return !(e.of_source && f.of_source) && c.edges_seen[i].meets(c.edges_seen[j]) &&
               !share_facet(e.facets, f.facets);
    }

    /// Places in the cell's list, the smaller first, ascending.
    std::vector<Pair> overlapping_edges(const Contents &c) const {
        std::vector<Pair> pairs;
        for (std::uint32_t i = 0; i < c.edges.size(); ++i)
            for (std::uint32_t j = i + 1; j < c.edges.size(); ++j)
                if (may_meet(c, i, j))
                    pairs.emplace_back(i, j);
        return pairs;
    }

    /// Calls visit for any three edges of which each two overlap and lie in no plane; returns how many.
    template <class Visit>
    std::size_t for_each_triple(const Contents &c, const std::vector<Pair> &pairs, const Visit &visit) const {
        const std::size_t n = c.edges.size();
        std::vector<char> skew(n * n, 0);
        for (const auto &[i, j] : pairs)
            skew[i * n + j] = !in_one_plane(view_.edges[c.edges[i]], view_.edges[c.edges[j]]);
        std::size_t count = 0;
        for (const auto &[i, j] : pairs)
            for (std::size_t k = j + 1; skew[i * n + j] && k < n; ++k)
                if (skew[i * n + k] && skew[j * n + k]) {
                    ++count;
                    visit(i, j, k);
                }
        return count;
    }

    void record(const Polygon &outline, std::span<const Vec3> cell, const Contents &c,
                const std::vector<Pair> &overlapping) {
        const auto id = static_cast<std::uint32_t>(out_.cells_.size());
        out_.cells_.push_back({outline, c.facets});
        const auto key = [&](std::size_t a, std::size_t b = 0, std::size_t d = 0) {
            return SightCells::Key{
                {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(d)}, id};
        };
        for (std::size_t i = 0; i < c.corners.size(); ++i)
            for (std::size_t j = 0; j < c.edges.size(); ++j) {
                const SightCorner &corner = view_.corners[c.corners[i]];
                const SightEdge &edge = view_.edges[c.edges[j]];
                if (!(corner.of_source && edge.of_source) && c.corners_seen[i].meets(c.edges_seen[j]) &&
                    !share_facet(corner.facets, edge.facets))
                    corners_and_edges_.push_back(key(c.corners[i], c.edges[j]));
            }
        for (const auto &[i, j] : overlapping)
            if (in_one_plane(view_.edges[c.edges[i]], view_.edges[c.edges[j]]))
                edges_in_plane_.push_back(key(c.edges[i], c.edges[j]));
        for_each_triple(c, overlapping, [&](std::size_t i, std::size_t j, std::size_t k) {
            triples_.push_back(key(c.edges[i], c.edges[j], c.edges[k]));
        });
        for (const std::size_t f : c.facets)
            if (const Facet &facet = view_.facets[f]; crosses(facet, cell) && crosses(facet, source_))
                planes_.push_back(key(f));
    }

    /// Whether the facet's plane meets the hull of the points.
    static bool crosses(const Facet &facet, std::span<const Vec3> points) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vec3 &p : points) {
            low = std::min(low, facet.frame.height(p));
            high = std::max(high, facet.frame.height(p));
        }
        return low <= slack + 2 * facet.bend && high >= -slack - 2 * facet.bend;
    }

    const SourceView &view_;
    SightCells &out_;
    const Surface &receiver_;
    std::vector<Vec3> source_; ///< corners of its parts
    SeenAt source_seen_;
    std::vector<std::optional<Fold>> folds_; ///< by edge
    std::vector<SightCells::Key> corners_and_edges_, edges_in_plane_, triples_, planes_;
};

SightCells::SightCells(const Scene &scene, const SourceView &view, const Cancel *cancel)
    : plane_(view.receiver_plane), cancel_(cancel) {
    CellDivision(scene, view, *this).run();
}

std::vector<Encounter> SightCells::gathered(std::vector<Key> keys) {
    std::ranges::sort(keys);
    std::vector<Encounter> encounters;
    const Key *before = nullptr;
    for (const Key &key : keys) {
        if (!before || before->touched != key.touched)
            encounters.push_back({{key.touched[0], key.touched[1], key.touched[2]}, {}});
        encounters.back().cells.push_back(key.cell);
        before = &key;
    }
    return encounters;
}

std::vector<std::size_t> SightCells::facets(const Encounter &encounter) const {
    std::vector<std::size_t> all;
    for (const std::size_t cell : encounter.cells)
        all.insert(all.end(), cells_[cell].facets.begin(), cells_[cell].facets.end());
    std::ranges::sort(all);
    const auto twins = std::ranges::unique(all);
    all.erase(twins.begin(), twins.end());
    return all;
}

const SightCell *SightCells::at(const Vec2 &p) const {
    const auto found = std::ranges::find_if(
        cells_, [&](const SightCell &cell) { return penumbra::contains(cell.outline, p, coincidence); });
    return found == cells_.end() ? nullptr : &*found;
}

IntervalSet SightCells::line_inside(const Encounter &encounter, const Vec3 &foot, const Vec3 &along) const {
    const Vec2 foot2 = plane_.to_plane(foot), along2(along.dot(plane_.u), along.dot(plane_.v));
    IntervalSet parts;
    for (const std::size_t cell : encounter.cells)
        parts.unite(inside(cells_[cell].outline, foot2, along2), coincidence);
    return parts;
}

bool SightCells::contains(const Encounter &encounter, const Vec2 &p) const {
    return std::ranges::any_of(encounter.cells, [&](std::size_t cell) {
        return penumbra::contains(cells_[cell].outline, p, coincidence);
    });
}

} // namespace penumbra
