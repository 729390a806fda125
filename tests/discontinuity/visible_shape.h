// The combinatorial shape of what a receiver's point sees of a source, read off shadows projected from that point
// alone: no critical surface is constructed. Slow and simple on purpose.
#pragma once

#include "scene/scene.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

/// Corners of the visible part, by name: a corner of the source or of a blocker, or two edges that cross. Corners that
/// coincide have one name, and so have edges in one line: which of them bounds the part is no matter of its shape.
using VisibleShape = std::set<std::string>;

class ShapeReader {
public:
    /// All surfaces but the two block.
    ShapeReader(const Scene &scene, SurfaceId source, SurfaceId receiver);
    /// Empty when nothing is seen, or x is covered or behind the source.
    VisibleShape at(const Vec2 &x) const;
    /// Whether x lies on the receiver, covered or not.
    bool on_receiver(const Vec2 &x) const;

private:
    struct Corner {
        Vec3 at;
        std::string name, edge; ///< the edge that leaves it
    };
    struct Face {
        std::string name;
        std::vector<Corner> corners;
    };
    struct Edge {
        Vec2 p, q;
        std::string name, p_name, q_name;
    };
    struct Figure {
        bool source;
        std::vector<Edge> edges;
        Polygon outline;
    };
    std::string name_of(const Vec3 &corner);
    std::string name_of_line(const Vec3 &a, const Vec3 &b);
    Face named(SurfaceId surface);
    /// The face where (y - origin) . normal >= least; its new edge is called after the face and `name`.
    static Face clip(const Face &face, const Vec3 &origin, const Vec3 &normal, double least, const std::string &name);
    Figure project(const Face &face, const Vec3 &x, bool source) const;
    bool covered(const Vec2 &x) const;
    static bool inside(const Polygon &outline, const Vec2 &p);
    static bool is_corner(const std::vector<Figure> &figures, const Vec2 &at);

    const Scene &scene_;
    SurfaceId source_, receiver_;
    std::vector<Vec3> known_;
    std::vector<std::pair<Vec3, Vec3>> lines_; ///< by an edge in each
    Face lamp_;
    std::vector<Face> faces_;
    std::vector<Vec3> frame_; ///< corners of a square about the source, counter-clockwise: shadows end there
};

} // namespace penumbra
