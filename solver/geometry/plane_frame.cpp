#include "geometry/plane_frame.h"

namespace penumbra {

Vec3 newell(std::span<const Vec3> polygon) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return sum;
}

PlaneFrame plane_frame(std::span<const Vec3> polygon) {
    PlaneFrame frame;
    frame.origin = polygon[0];
    frame.normal = newell(polygon).normalized();
    Vec3 longest = Vec3::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (edge.squaredNorm() > longest.squaredNorm())
            longest = edge;
    }
    frame.u = (longest - longest.dot(frame.normal) * frame.normal).normalized();
    frame.v = frame.normal.cross(frame.u);
    return frame;
}

} // namespace penumbra
