#include "scene/merge_triangles.h"

#include "geometry/plane_frame.h"
#include "geometry/simple.h"
#include "scene/mend.h"
#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <unordered_map>

namespace penumbra {

namespace {

constexpr int none = -1, several = -2;

std::uint64_t key(int a, int b) { return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b); }

struct Mesh {
    std::span<const Vec3> points;
    std::span<const MeshTriangle> triangles;
    double rounding = 0;                          ///< how far corners may be from where they were modelled
    std::unordered_map<std::uint64_t, int> owner; ///< of a directed edge: its triangle, or `several`

    const Vec3 &point(int i) const { return points[static_cast<std::size_t>(i)]; }
    const MeshTriangle &triangle(int t) const { return triangles[static_cast<std::size_t>(t)]; }
    int owner_of(int a, int b) const {
        const auto found = owner.find(key(a, b));
        return found == owner.end() ? none : found->second;
    }
    Vec3 normal(int a, int b, int c) const { return (point(b) - point(a)).cross(point(c) - point(a)); }
};

bool has_area(const Mesh &mesh, const MeshTriangle &t) {
    const auto [a, b, c] = t.corners;
    const double longest = std::max({(mesh.point(b) - mesh.point(a)).norm(), (mesh.point(c) - mesh.point(b)).norm(),
                                     (mesh.point(a) - mesh.point(c)).norm()});
    return a != b && b != c && c != a && mesh.normal(a, b, c).norm() > mesh.rounding * longest;
}

Mesh connected(std::span<const Vec3> points, std::span<const MeshTriangle> triangles) {
    // Eight roundings: exporters compute in single precision, too.
    constexpr double eight_roundings = 8.0 / (1 << 24);
    Mesh mesh{points, triangles, 0, {}};
    for (const Vec3 &x : points)
        mesh.rounding = std::max(mesh.rounding, eight_roundings * x.cwiseAbs().maxCoeff());
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        const MeshTriangle &triangle = mesh.triangle(t);
        if (!has_area(mesh, triangle))
            continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [at, is_new] = mesh.owner.emplace(key(triangle.corners[i], triangle.corners[(i + 1) % 3]), t);
            if (!is_new)
                at->second = several;
        }
    }
    return mesh;
}

int apex(const MeshTriangle &t, int a, int b) {
    return *std::ranges::find_if(t.corners, [&](int c) { return c != a && c != b; });
}

/// Whether moving corners by no more than the rounding brings both into one plane, facing the same way. The volume of
/// abcd changes with a corner's move by the area of the face opposite.
bool coplanar(const Mesh &mesh, int a, int b, int c, int d) {
    const Vec3 abc = mesh.normal(a, b, c), bad = mesh.normal(b, a, d);
    const double volume = std::abs(abc.dot(mesh.point(d) - mesh.point(a)));
    const double areas = abc.norm() + bad.norm() + mesh.normal(a, c, d).norm() + mesh.normal(b, c, d).norm();
    return abc.dot(bad) > 0 && volume <= mesh.rounding * areas;
}

/// A simple closed chain of corners around the triangles taken so far.
struct Growth {
    std::unordered_map<int, int> next, before;
    std::vector<int> taken;

    void join(int a, int b) {
        next[a] = b;
        before[b] = a;
    }
    void drop(int a) {
        join(before[a], next[a]);
        next.erase(a);
        before.erase(a);
    }
    bool has_side(int a, int b) const {
        const auto found = next.find(a);
        return found != next.end() && found->second == b;
    }
};

/// Takes the triangle with apex c on the side a, b; false when the chain would touch itself.
bool take(Growth &growth, int a, int b, int c) {
    if (!growth.next.contains(c)) {
        growth.join(a, c);
        growth.join(c, b);
        return true;
    }
    if (growth.next.size() == 3)
        return false;
    if (growth.next[b] == c)
        growth.drop(b);
    else if (growth.before[a] == c)
        growth.drop(a);
    else
        return false;
    return true;
}

/// Grows from `seed` over neighbours. A triangle that would make the chain touch itself is tried again when a second of
/// its sides becomes one of the chain's: a partly grown disk can always be completed so (two-dimensional disks are
/// extendably shellable).
Growth grow(const Mesh &mesh, int seed, std::vector<bool> &is_taken) {
    Growth growth;
    const auto [a0, b0, c0] = mesh.triangle(seed).corners;
    growth.join(a0, b0);
    growth.join(b0, c0);
    growth.join(c0, a0);
    growth.taken = {seed};
    std::deque<std::array<int, 2>> sides{{a0, b0}, {b0, c0}, {c0, a0}};
    for (; !sides.empty() && growth.next.size() < most_corners; sides.pop_front()) {
        const auto [a, b] = sides.front();
        const int inside = mesh.owner_of(a, b), t = mesh.owner_of(b, a);
        if (!growth.has_side(a, b) || inside < 0 || t < 0 || is_taken[static_cast<std::size_t>(t)] ||
            mesh.triangle(t).material != mesh.triangle(seed).material)
            continue;
        const int c = apex(mesh.triangle(t), a, b);
        if (!coplanar(mesh, a, b, apex(mesh.triangle(inside), a, b), c) || !take(growth, a, b, c))
            continue;
        is_taken[static_cast<std::size_t>(t)] = true;
        growth.taken.push_back(t);
        for (const auto &side : {std::array{a, c}, std::array{c, b}})
            if (growth.has_side(side[0], side[1]))
                sides.push_back(side);
    }
    return growth;
}

std::vector<int> chain(Growth &growth, int seed_corner) {
    const int start = growth.next.contains(seed_corner) ? seed_corner : growth.next.begin()->first;
    std::vector<int> corners;
    for (int at = start; corners.empty() || at != start; at = growth.next[at])
        corners.push_back(at);
    return corners;
}

/// A spiral of triangles overlaps itself, and many small bends add up.
bool is_flat_and_simple(const Mesh &mesh, const std::vector<int> &corners) {
    std::vector<Vec3> loop;
    Vec3 low = mesh.point(corners[0]), high = low;
    for (const int c : corners) {
        loop.push_back(mesh.point(c));
        low = low.cwiseMin(loop.back());
        high = high.cwiseMax(loop.back());
    }
    const double size = (high - low).norm();
    if (!(newell(loop).norm() > same_within * size * size))
        return false;
    PlaneFrame plane = plane_frame(loop);
    plane.origin = Vec3::Zero();
    for (const Vec3 &x : loop)
        plane.origin += x / static_cast<double>(loop.size());
    Polygon outline;
    for (const Vec3 &x : loop) {
        if (std::abs(plane.height(x)) > 0.5 * flat_within * size)
            return false;
        outline.push_back(plane.to_plane(x));
    }
    return is_simple(outline);
}

} // namespace

std::vector<MergedFace> merge_triangles(std::span<const Vec3> points, std::span<const MeshTriangle> triangles) {
    const Mesh mesh = connected(points, triangles);
    std::vector<bool> is_taken(triangles.size());
    std::vector<MergedFace> faces;
    const auto add_alone = [&](int t) {
        const auto &corners = mesh.triangle(t).corners;
        faces.push_back({{corners.begin(), corners.end()}, mesh.triangle(t).material, t});
    };
    for (int seed = 0; seed < static_cast<int>(triangles.size()); ++seed) {
        if (is_taken[static_cast<std::size_t>(seed)])
            continue;
        is_taken[static_cast<std::size_t>(seed)] = true;
        if (!has_area(mesh, mesh.triangle(seed))) {
            add_alone(seed);
            continue;
        }
        Growth growth = grow(mesh, seed, is_taken);
        std::vector<int> corners = chain(growth, mesh.triangle(seed).corners[0]);
        if (growth.taken.size() == 1 || is_flat_and_simple(mesh, corners))
            faces.push_back({std::move(corners), mesh.triangle(seed).material, seed});
        else
            std::ranges::for_each(growth.taken, add_alone);
    }
    std::ranges::stable_sort(faces, {}, &MergedFace::first);
    return faces;
}

} // namespace penumbra
