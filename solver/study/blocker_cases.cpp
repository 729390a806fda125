#include "study/case_groups.h"

#include "measure/direct.h"
#include "study/lit_floor.h"
#include "study/point_factor.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

Face floor() { return parallelogram(o, x, y, 0.5); }
Face lamp() { return parallelogram(Vec3(0.1, 0.2, 1), 0.3 * y, 0.3 * x, 0, 1); }

/// The floor's error against what each of its points sees of the lamp, exactly.
std::vector<Measurement> compare_with_direct(const Face &blocker, const TrialSetting &setting) {
    const Trial trial = solve({floor(), lamp(), blocker}, setting);
    const Scene &scene = *trial.scene;
    const Blockers blockers(scene);
    const auto exact = [&](const Vec3 &p) {
        const Vec2 at = scene.surfaces[0].frame.to_plane(scene.own.to_solver(p));
        return direct_radiosity(scene, blockers, SurfaceId(0), at).maxCoeff();
    };
    // On the wall's foot radiosity jumps: there it has no value.
    std::vector<Vec3> points = grid(o, x, y);
    std::erase_if(points,
                  [](const Vec3 &p) { return std::abs(p.x() - 0.5) < 1e-9 && std::abs(p.y() - 0.5) < 0.2 + 1e-9; });
    std::vector<Measurement> out = soundness(trial);
    out.push_back(
        {"error against the exact direct light", largest_error(trial, points, z, exact), setting.options.threshold});
    return out;
}

/// A square at height h above the floor, so low that it hides nothing outside its own outline and all inside.
std::vector<Measurement> flat_blocker(double h, const TrialSetting &setting) {
    const auto inside = [](const Vec3 &p) { return std::max(std::abs(p.x() - 0.5), std::abs(p.y() - 0.5)) < 0.2; };
    std::vector<Vec3> lit = grid(o, x, y);
    std::erase_if(lit, inside);
    const Face blocker = parallelogram(Vec3(0.3, 0.3, h), 0.4 * x, 0.4 * y, 0);
    auto out = compare_with_lambert({floor(), lamp(), blocker}, lit, setting);
    const Trial trial = solve({floor(), lamp(), blocker}, setting);
    const double brightest = 0.5 * point_factor(Vec3(0.25, 0.35, 0), z, lamp().corners);
    out.push_back({"light under it, of the brightest",
                   largest_radiosity(trial, grid(Vec3(0.3, 0.3, 0), 0.4 * x, 0.4 * y), z) / brightest,
                   setting.options.threshold});
    return out;
}

HardCase upright(const std::string &name, const std::string &what, const Vec3 &from, const Vec3 &along,
                 const Vec3 &rise) {
    return {name, what, [=](const TrialSetting &setting) {
                return compare_with_direct(parallelogram(from, along, rise, 0), setting);
            }};
}

} // namespace

std::vector<HardCase> blocker_cases() {
    const std::string exact = " leaves the floor the light that each point sees";
    return {
        {"blocker-on-the-floor", "A blocker that lies on the floor darkens what it covers and nothing else",
         [](const TrialSetting &setting) { return flat_blocker(0, setting); }},
        {"blocker-a-hair-above", "And so does one that lies a billionth above it",
         [](const TrialSetting &setting) { return flat_blocker(1e-9, setting); }},
        upright("blocker-standing", "A blocker that stands on the floor" + exact, Vec3(0.5, 0.3, 0), 0.4 * y, 0.3 * z),
        upright("blocker-piercing", "A blocker that pierces the floor" + exact, Vec3(0.5, 0.3, -0.2), 0.4 * y, 0.5 * z),
        upright("cut-along-a-side", "A blocker that stands on the floor's side" + exact, Vec3(0, 0, 0), 0.9 * y,
                0.3 * z),
        upright("cut-through-corners", "A blocker whose plane meets two of the floor's corners" + exact,
                Vec3(0.5, 0.5, 0.1), Vec3(0.3, 0.3, 0), 0.3 * z),
    };
}

} // namespace penumbra
