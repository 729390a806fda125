#include "render/pick_curve.h"

#include "render/pick.h"
#include "render/surface_role.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra {
namespace {

/// The eye's frame; a point in front of the eye has a place in the picture [pixels from the middle, y up].
class Screen {
public:
    Screen(const Camera &camera, double height)
        : view_(view_matrix(camera)), pixels_(height / 2 / std::tan(glm::radians(camera.fov_y) / 2)) {}
    glm::dvec3 seen(const Vec3 &p) const { return view_ * glm::dvec4(p.x(), p.y(), p.z(), 1); }
    glm::dvec2 place(const glm::dvec3 &seen) const { return glm::dvec2(seen) * (pixels_ / -seen.z); }

private:
    glm::dmat4 view_;
    double pixels_;
};

struct Candidate {
    double distance = 0; ///< pixels
    CurvePick pick;
};

/// Of a segment between two points as the eye sees them, the part of the way at which its picture passes nearest to
/// `at`.
double nearest_part(const Screen &screen, const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec2 &at,
                    double &distance) {
    const glm::dvec2 from = screen.place(a), way = screen.place(b) - from;
    const double length2 = glm::dot(way, way);
    const double s = length2 > 0 ? std::clamp(glm::dot(at - from, way) / length2, 0.0, 1.0) : 0;
    distance = glm::distance(from + s * way, at);
    // Equal steps in the picture are none along the segment: the far end is foreshortened.
    const double near = s / -b.z, far = (1 - s) / -a.z;
    return near + far > 0 ? near / (near + far) : 0;
}

bool is_hidden(const Snapshot &snapshot, const Camera &camera, double aspect, const Screen &screen, double height,
               const CurvePick &pick) {
    const glm::dvec2 place = screen.place(screen.seen(pick.point));
    const auto seen = penumbra::pick(snapshot, camera, aspect, 2 * place.x / (height * aspect), 2 * place.y / height);
    if (!seen)
        return false;
    const Vec3 eye(camera.eye.x, camera.eye.y, camera.eye.z);
    return (seen->point - eye).norm() < (1 - 1e-3) * (pick.point - eye).norm();
}

bool faces(const SnapshotSurface &s, const Camera &camera) {
    return s.normal.dot(Vec3(camera.eye.x, camera.eye.y, camera.eye.z) - s.origin) > 0;
}

} // namespace

std::optional<CurvePick> pick_curve(const Snapshot &snapshot, const Camera &camera, double aspect, double x, double y,
                                    double height, double reach, const CurveFilter &filter) {
    if (!snapshot.curves)
        return std::nullopt;
    const Screen screen(camera, height);
    const glm::dvec2 at(x * height * aspect / 2, y * height / 2);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < snapshot.curves->size(); ++i) {
        const SnapshotCurve &curve = (*snapshot.curves)[i];
        if (!filter.shows(curve) || !faces(snapshot.surfaces[static_cast<std::size_t>(curve.receiver)], camera))
            continue;
        Candidate best{reach, {static_cast<int>(i), {}}};
        bool found = false;
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
            const glm::dvec3 a = screen.seen(curve.points[k]), b = screen.seen(curve.points[k + 1]);
            if (a.z >= 0 || b.z >= 0) // a segment that passes the eye is picked where it does not
                continue;
            double distance = 0;
            const double part = nearest_part(screen, a, b, at, distance);
            if (distance > best.distance)
                continue;
            found = true;
            best.distance = distance;
            best.pick.point = curve.points[k] + part * (curve.points[k + 1] - curve.points[k]);
        }
        if (found)
            candidates.push_back(best);
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::distance);
    for (const Candidate &candidate : candidates)
        if (!is_hidden(snapshot, camera, aspect, screen, height, candidate.pick))
            return candidate.pick;
    return std::nullopt;
}

} // namespace penumbra
