// Everything that can block light: the convex parts of all surfaces.
#pragma once

#include "core/ids.h"
#include "scene/scene.h"

#include <memory>
#include <span>
#include <vector>

namespace penumbra {

/// A convex polygon that blocks light from both sides.
struct Blocker {
    SurfaceId surface;
    std::vector<Vec3> corners; ///< counter-clockwise seen from the front
    PlaneFrame frame;
    int solid = -1;            ///< the closed convex solid whose outward face it is, or -1
};

/// A closed convex polyhedron whose faces all look outwards: from outside, only faces turned towards the eye matter.
struct Solid {
    std::vector<SurfaceId> faces;
};

/// The blockers of a scene with a bounding-volume hierarchy (Embree) that proposes candidates. Immutable.
class Blockers {
public:
    /// Surfaces that `can_block` says no of stand among the blockers, too, but are never proposed (empty: it says yes of all).
    explicit Blockers(const Scene &scene, std::span<const char> can_block = {});
    ~Blockers();
    Blockers(const Blockers &) = delete;
    Blockers &operator=(const Blockers &) = delete;

    const std::vector<Blocker> &all() const { return blockers_; }
    const Blocker &operator[](int i) const { return blockers_[static_cast<std::size_t>(i)]; }
    /// Indices of the blockers whose bounding boxes, inflated by far more than single precision loses, meet the box;
    /// ascending. A superset of what meets it.
    std::vector<int> near_box(const Vec3 &low, const Vec3 &high) const;
    /// Whether the blocker lies in the surface's plane: no point there is hidden by it.
    bool edge_on(int blocker, SurfaceId seen_from) const;
    /// Of those that are never proposed, how many have boxes that meet this one; but for those of the receiver's
    /// plane and the source: what would be clipped by, had they been proposed.
    int n_left_out_near(const Vec3 &low, const Vec3 &high, SurfaceId receiver, SurfaceId source) const;
    /// Whether all points (in solver coordinates) lie outside or on the border of the solid, judged by one of its faces.
    bool outside(int solid, std::span<const Vec3> points) const;

private:
    struct Tree;
    std::vector<Blocker> blockers_;
    std::vector<int> left_out_; ///< never proposed
    std::vector<Solid> solids_;
    const Scene &scene_;
    std::unique_ptr<Tree> tree_;
};

/// Closed convex solids of the scene: sets of surfaces in which every edge belongs to exactly two faces, in opposite
/// directions, and all corners lie behind all faces.
std::vector<Solid> find_solids(const Scene &scene);

} // namespace penumbra
