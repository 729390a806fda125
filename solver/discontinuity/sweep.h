// What a fan of sight lines meets: the lines of one wedge, through all facets.
#pragma once

#include "discontinuity/interval_set.h"
#include "discontinuity/source_view.h"
#include "discontinuity/wedge.h"

#include <span>
#include <vector>

namespace penumbra {

/// How a convex facet lies to the wedge's plane, and the segment pq that both have in common (none when n < 2).
struct Crossing {
    bool left = false, right = false; ///< corners beside the plane, on its sides +1 and -1
    int n = 0;
    Vec3 p = Vec3::Zero(), q = Vec3::Zero();

    bool through() const { return n >= 2 && left && right; }
    bool along_edge() const { return n >= 2 && left != right; }
    void add(const Vec3 &x, const Vec3 &direction);
};

Crossing cross_facet(const Wedge &wedge, const Facet &facet);

/// A facet's edge that lies in the wedge's plane while the facet stays on one side of it: sight lines of the interval
/// graze it.
struct Graze {
    Interval lines;
    Vec3 p = Vec3::Zero(), q = Vec3::Zero();
    int side; ///< of the facet, +1 or -1
    SurfaceId surface;
};

/// Sight lines that reach beyond the apex stop at the source; those of a source's corner stop at the apex.
enum class Reach { to_apex, beyond_apex };

struct Sweep {
    IntervalSet open; ///< sight lines that no facet crosses; not yet closed where grazes face each other
    std::vector<Graze> grazes;
};

/// Sweeps the lines in `candidates` over the facets, except those that touch the apex (`at_apex`, ascending indices):
/// these meet a fan in single lines, and what they hide about the apex is told by sectors.h.
Sweep sweep(const SourceView &view, const Wedge &wedge, Reach reach, std::span<const std::size_t> at_apex,
            IntervalSet candidates);

/// Whether the grazed edge lies on the line pq.
bool on_line(const Graze &graze, const Vec3 &p, const Vec3 &q);

/// Closes the lines that graze the same edge from both sides: the fold between two faces, seen from within or without,
/// that is no silhouette.
void close_folds(Sweep &sweep);

} // namespace penumbra
