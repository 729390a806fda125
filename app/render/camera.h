// The eye, and the ways of moving it. Coordinates are the scene's own frame.
#pragma once

#include "iteration/snapshot.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>

namespace penumbra {

struct Camera {
    glm::dvec3 eye{3, -4, 3};
    glm::dvec3 target{0, 0, 0}; ///< what the eye looks at and orbits about
    glm::dvec3 up{0, 0, 1};     ///< unit; the scene's up, not tilted with the view
    double fov_y = 30;          ///< full vertical angle [degrees]
    bool operator==(const Camera &) const = default;
};

/// Smallest box around all surfaces.
struct Bounds {
    glm::dvec3 low{0}, high{0};
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    double size() const { return glm::length(high - low); }
};
Bounds bounds(const Snapshot &snapshot);

/// Three-quarter view from above, at which all surfaces just fill a frame of this aspect (width / height). A room with
/// a ceiling is seen level instead, through its open side (or the back of its largest wall).
Camera default_view(const Snapshot &snapshot, double aspect, const Vec3 &up = Vec3::UnitZ());
/// The view that the scene's file asks for, or else the default one. A file's view is meant for frames of 4:3 and wider;
/// a narrower one shows it from farther away.
Camera first_view(const Scene &scene, const Snapshot &snapshot, double aspect);
/// What a file or an option names.
Camera camera_from(const View &view, const Scene &scene);
enum class Subject { lit_and_lamps, all_but_lamps }; ///< surfaces that reflect or emit; those that do not emit
/// The same direction of view, moved and pulled back so that the subject just fills the frame.
Camera fit(const Camera &camera, const Snapshot &snapshot, double aspect, Subject subject = Subject::lit_and_lamps);

/// Turns about `pivot` by `yaw` around up and by `pitch` around the view's right [radians]; the pitch stops short of
/// the poles. With the target as pivot the usual orbit.
Camera orbit(const Camera &camera, double yaw, double pitch, const glm::dvec3 &pivot);
/// Moves eye and target together, so that what lies at the depth of `anchor` follows the mouse by dx, dy pixels
/// (y down) in a frame of `height` pixels.
Camera pan(const Camera &camera, double dx, double dy, double height, const glm::dvec3 &anchor);
/// Moves toward `point` (factor < 1) or away from it (factor > 1): distances to it are multiplied by `factor`, and it
/// stays where it is in the picture.
Camera zoom(const Camera &camera, double factor, const glm::dvec3 &point);

/// The same eye, its angle widened so that all that a frame of one aspect shows from side to side is in a narrower one,
/// too. Unchanged for wider ones.
Camera hold_width(const Camera &camera, double from_aspect, double to_aspect);

glm::dmat4 view_matrix(const Camera &camera);
/// Perspective whose near and far planes just hold the box.
glm::dmat4 projection_matrix(const Camera &camera, double aspect, const Bounds &bounds);

/// Direction (unit) from the eye through a point of the frame: x, y in [-1, 1], y up.
glm::dvec3 view_ray(const Camera &camera, double aspect, double x, double y);
/// Where a point lies in the frame, the reverse of view_ray; none behind the eye.
std::optional<glm::dvec2> place_in_frame(const Camera &camera, double aspect, const glm::dvec3 &point);

} // namespace penumbra
