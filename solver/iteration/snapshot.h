// A picture of the solution between two phases, in plain arrays: all that a window or a file needs to know of it.
// Immutable once made; coordinates are the scene's own frame [its length unit], radiosity is in W/m2.
#pragma once

#include "core/counters.h"
#include "core/options.h"
#include "core/vec.h"
#include "effects/ledger.h"
#include "geometry/bilinear_quad.h"
#include "hierarchy/forest.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace penumbra {

enum class Phase { start, refined, gathered, pushed_pulled };
std::string_view name(Phase phase);

struct SnapshotSurface {
    Vec3 origin, u, v, normal;  ///< plane frame; a point is origin + x u + y v
    std::vector<Vec2> outline;  ///< counter-clockwise, in the frame
    std::vector<std::vector<Vec2>> covers; ///< convex polygons that lie on it and darken it
    Rgb reflectance, exitance;
    std::string name;
};

/// Which piece of which split an element is.
struct SnapshotPlace {
    std::int32_t split = -1;            ///< of snapshot.splits; -1: of none, it is a root
    std::int32_t piece = 0;
};

/// A leaf: a convex polygon of its surface's plane, on which B(u,v) = sum over i, j of coefficients[first + i*order + j]
/// L_i(u) L_j(v), with L_k the Legendre polynomials orthonormal on [0,1] and (u,v) the parameters of the bilinear quad
/// x(u,v) = (1-u)(1-v) q0 + u(1-v) q1 + uv q2 + (1-u)v q3. In the parametric basis the quad is the polygon (two of its
/// corners coincide in a triangle), in the planar one the box about it, and there coefficients with i + j >= order are 0.
struct SnapshotPatch {
    std::int32_t surface = 0;
    std::int32_t order = 1;
    std::int32_t first = 0;             ///< of its order^2 coefficients
    std::array<Vec2, 4> quad;
    std::vector<Vec2> corners;          ///< of the polygon, counter-clockwise
    std::vector<SideKind> sides;        ///< side k runs from corner k to the next
    float depth = 0;                    ///< halvings of both directions
    bool fresh = false;                 ///< made in this iteration
    bool at_limit = false;              ///< failed the oracle at the depth limit
    SnapshotPlace place{};
    /// What the oracle's test points say that the fits of the patch miss, as the root of the integral over it of the
    /// square, the three channels together [W/m2 times length]; misses of different sources are taken for independent, and
    /// of links to elements above it has its area's share. Negative: nothing was tested.
    double estimate = -1;
};

struct SnapshotPiece {
    std::vector<Vec2> corners;          ///< counter-clockwise
    std::shared_ptr<const TwoScale> filters; ///< between the element that was split and this piece of it
};

/// An element that was split. Each of its pieces is a patch, or was split in its turn.
struct SnapshotSplit {
    std::int32_t surface = 0;
    SplitKind kind = SplitKind::uniform;
    std::vector<Vec2> corners;          ///< of the element, counter-clockwise
    std::vector<SnapshotPiece> pieces;
    SnapshotPlace place{};              ///< of the element
};

/// An edge that lines of sight touch; a corner has both ends in one place.
struct SnapshotEdge {
    Vec3 a, b;
    std::int32_t surface = -1;          ///< whose it is; -1: not known

    bool is_corner() const { return a == b; }
};

struct SnapshotCurve {
    std::int32_t kind = 0, order = 2;   ///< as CurveKind
    std::int32_t source = 0, receiver = 0;
    std::vector<std::int32_t> blockers;
    std::vector<Vec3> points;           ///< polyline on the receiver
    std::vector<SnapshotEdge> touched{}; ///< what all lines of sight from the curve to the source touch; see curve.h
};

struct SnapshotLink {
    Vec3 receiver, source;              ///< centres of the two elements
    std::int32_t kind = 0;              ///< 0 clear, 1 near or touching, 2 partly hidden
    std::int32_t linking = -1;          ///< of snapshot.linkings, which made it; -1: it was there before
};

/// A split of the last refinement (split_event.h).
struct SnapshotEvent {
    SnapshotPatch element;              ///< as it was before, with the polynomial that its pieces have taken over
    std::int32_t split = -1;            ///< of snapshot.splits; a cut in two steps has split one of the pieces, too
    bool cut = false;                   ///< along a line, not uniformly
    std::int32_t curve = -1;            ///< of snapshot.curves, that the line follows; -1: none
    std::int32_t source = -1;           ///< whose light is missed most; -1: not known
    double misfit = 0, threshold = 0;   ///< fractions of the peak
    int n_pieces = 0;                   ///< patches in the element's place
    int n_coefficients = 0;             ///< of each of them, and of the element
    std::vector<SnapshotLink> links;    ///< that the element had and its pieces were linked anew for
    std::string sentence;
};

/// An element and a source that the last refinement linked (split_event.h).
struct SnapshotLinking {
    std::vector<Vec3> receiver;         ///< corners of the element
    std::vector<SnapshotLink> replaced; ///< in whose place its links are
    std::string sentence;
};

struct Snapshot {
    std::uint64_t version = 0;          ///< another one for each snapshot that is made in this process
    std::string scene;
    Options options;
    Phase phase = Phase::start;
    Counters counters;
    std::vector<SnapshotSurface> surfaces;
    std::vector<SnapshotPatch> patches; ///< of all surfaces, dark and emitting ones too
    std::vector<SnapshotSplit> splits;  ///< of all surfaces, an element's before its pieces'
    std::vector<Rgb> coefficients;
    std::shared_ptr<const std::vector<SnapshotCurve>> curves; ///< of all emitters, then of reflectors in the order in which they were needed
    std::vector<SnapshotLink> links;
    double peak = 0;                    ///< largest reflected radiosity B - E, largest channel [W/m2]
    double error = -1;                  ///< relative L2 error against the exact direct solution; negative: not known
    bool reconstructed = false;         ///< patches hold quadratics made for the eye (quadratic.h), not the solution's constants
    std::string sentence;               ///< what the last phase did, in words
    /// After a refinement, its splits in order; else null.
    std::shared_ptr<const std::vector<SnapshotEvent>> events;
    std::int32_t n_shown_events = -1;   ///< the mesh is that after so many of them (after_splits.h); -1: after all
    std::shared_ptr<const std::vector<SnapshotLinking>> linkings; ///< as `events`, which come before all of these
    std::int32_t n_shown_linkings = -1; ///< links are those after so many of them; -1: after all, or none while splits are shown
    std::vector<LedgerEntry> effects;   ///< what was decided about each, up to now
};

/// Whether the polynomial's quad is a box about the patch (planar basis), not the patch itself.
bool is_box(const SnapshotPatch &patch);
/// Quads and triangles that tile the patch.
std::vector<BilinearQuad> tiles(const SnapshotPatch &patch);
Vec2 to_plane(const SnapshotSurface &surface, const Vec3 &point);
/// Whether a point of its plane is inside its outline, by the even-odd rule.
bool holds(const SnapshotSurface &surface, const Vec2 &p);
/// Whether a point of its plane lies under one of its covers.
bool is_covered(const SnapshotSurface &surface, const Vec2 &p);

/// Radiosity of a patch at its parameters u, v in [0,1].
Rgb radiosity_at(const Snapshot &snapshot, const SnapshotPatch &patch, double u, double v);
/// Radiosity of a patch at a point of its surface's plane (inside the patch).
Rgb radiosity(const Snapshot &snapshot, const SnapshotPatch &patch, const Vec2 &p);
/// The polynomial's own derivative there in a direction of the plane [W/m2 per length]; 0 where the map from the
/// parameters has no inverse (the apex of a triangle).
Rgb radiosity_slope(const Snapshot &snapshot, const SnapshotPatch &patch, const Vec2 &p, const Vec2 &direction);

} // namespace penumbra
