#include "study/lit_floor.h"

#include "geometry/plane_frame.h"
#include "measure/direct.h"
#include "study/point_factor.h"

namespace penumbra {

std::vector<Measurement> compare_with_lambert(const Faces &faces, const Face &lamp, const std::vector<Vec3> &points,
                                              const TrialSetting &setting) {
    const Trial trial = solve(faces, setting);
    const Face &floor = faces[0];
    const Vec3 up = plane_frame(floor.corners).normal;
    const auto exact = [&](const Vec3 &x) {
        return floor.reflectance * lamp.exitance * point_factor(x, up, lamp.corners);
    };
    std::vector<Measurement> out = soundness(trial);
    out.push_back(
        {"error against Lambert's closed form", largest_error(trial, points, up, exact), setting.options.threshold});
    return out;
}

std::vector<Measurement> compare_with_lambert(const Faces &faces, const std::vector<Vec3> &points,
                                              const TrialSetting &setting) {
    return compare_with_lambert(faces, faces[1], points, setting);
}

std::vector<Measurement> compare_with_direct(const Faces &faces, const Faces &as_seen, const std::vector<Vec3> &points,
                                             const TrialSetting &setting) {
    const Trial trial = solve(faces, setting);
    const Scene scene = build_scene(as_seen, "as seen");
    const Blockers blockers(scene);
    const auto exact = [&](const Vec3 &p) {
        const Vec2 at = scene.surfaces[0].frame.to_plane(scene.own.to_solver(p));
        return direct_radiosity(scene, blockers, SurfaceId(0), at).maxCoeff();
    };
    std::vector<Measurement> out = soundness(trial);
    out.push_back({"error against the exact direct light",
                   largest_error(trial, points, plane_frame(faces[0].corners).normal, exact), setting.options.threshold});
    return out;
}

} // namespace penumbra
