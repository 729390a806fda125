// What one point of a surface sees of each emitter, as a picture: its exact visible part, and what stands before it.
#pragma once

#include "geometry/polygon.h"
#include "scene/scene.h"
#include "visibility/blockers.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace penumbra {

/// A polygon in a picture: convex parts for filling, and its outline as far as it lies in the picture.
struct KeyholeFigure {
    std::int32_t surface = 0;
    std::vector<Polygon> parts; ///< counter-clockwise, from whichever side they are seen
    std::vector<std::pair<Vec2, Vec2>> edges;
};

/// Where the border of a visible part turns.
struct KeyholeCorner {
    Vec2 at;         ///< in the picture
    Vec3 on_emitter; ///< scene's own frame
};

/// One emitter as the point sees it, in perspective: a point y lies at (r . right, r . up) / (r . ahead) with r = y -
/// x, `ahead` towards the emitter's centre. The picture turns as little as it can while the point moves: an emitter
/// that is looked at straight has the scene's up upward (a level one, the x axis to the right).
struct KeyholeEmitter {
    Vec2 low, high;                      ///< the picture's frame: the emitter with a margin, square
    KeyholeFigure whole;                 ///< the emitter with nothing before it, above the receiver's horizon
    std::vector<Polygon> visible;        ///< convex, disjoint: what is seen of it
    std::vector<KeyholeCorner> corners;  ///< of the visible part
    std::vector<KeyholeFigure> blockers; ///< what may stand between, far before near
    double share = 0;                    ///< visible area over area; what is covered is no part of the emitter
    Rgb irradiance = Rgb::Zero();        ///< from it [W/m2]
};

struct Keyhole {
    SurfaceId surface;
    Vec3 point;                           ///< scene's own frame
    std::vector<KeyholeEmitter> emitters; ///< that the point is in front of, the brightest first; empty under a cover
};

/// Looks from anywhere in one scene. Immutable; keeps the scene.
class KeyholeEye {
public:
    explicit KeyholeEye(std::shared_ptr<const Scene> scene);

    /// From the point of the surface's plane nearest to `point` (scene's own frame). Visible parts, shares and
    /// irradiances are exact, as in direct.h; tests/agreement checks them against rays and the corners against
    /// visible_shape.h.
    Keyhole look(SurfaceId surface, const Vec3 &point) const;
    /// The reflecting surface that holds the point (own frame) to within `slack` of the scene's size, the one whose
    /// plane is nearest; none where there is no such surface.
    SurfaceId surface_at(const Vec3 &point, double slack) const;

private:
    std::shared_ptr<const Scene> scene_;
    Blockers blockers_;
};

} // namespace penumbra
