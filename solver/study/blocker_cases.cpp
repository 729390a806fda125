#include "study/case_groups.h"

#include "study/lit_floor.h"
#include "study/point_factor.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

Face floor() { return parallelogram(o, x, y, 0.5); }
Face lamp() { return parallelogram(Vec3(0.1, 0.2, 1), 0.3 * y, 0.3 * x, 0, 1); }

/// `shown` are what stands in the light, `blocker` is the same in one piece: the floor's error against what each of its
/// points sees of the lamp, exactly.
std::vector<Measurement> compare_with_direct(const Faces &shown, const Face &blocker, const TrialSetting &setting) {
    Faces faces{floor(), lamp()};
    faces.insert(faces.end(), shown.begin(), shown.end());
    // On the wall's foot radiosity jumps: there it has no value.
    std::vector<Vec3> points = grid(o, x, y);
    std::erase_if(points,
                  [](const Vec3 &p) { return std::abs(p.x() - 0.5) < 1e-9 && std::abs(p.y() - 0.5) < 0.2 + 1e-9; });
    return penumbra::compare_with_direct(faces, {floor(), lamp(), blocker}, points, setting);
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

/// A square in two halves, side by side in one plane.
std::vector<Measurement> two_in_one_plane(const TrialSetting &setting) {
    const Vec3 corner(0.3, 0.3, 0.3);
    const Face whole = parallelogram(corner, 0.4 * x, 0.4 * y, 0);
    const Faces halves{parallelogram(corner, 0.2 * x, 0.4 * y, 0),
                       parallelogram(corner + 0.2 * x, 0.2 * x, 0.4 * y, 0)};
    std::vector<Measurement> out = compare_with_direct(halves, whole, setting);
    const Trial one = solve({floor(), lamp(), whole}, setting),
                two = solve({floor(), lamp(), halves[0], halves[1]}, setting);
    out.push_back({"difference from one in one piece",
                   largest_error(two, grid(o, x, y), z, [&](const Vec3 &p) { return radiosity(one, p, z); }),
                   setting.options.threshold});
    return out;
}

/// So thin that it takes away less than 1e-5 of the light of any point.
std::vector<Measurement> wire(const TrialSetting &setting) {
    return compare_with_lambert({floor(), lamp(), parallelogram(Vec3(0, 0.4, 0.5), x, 1e-6 * y, 0)}, grid(o, x, y),
                                setting);
}

HardCase upright(const std::string &name, const std::string &what, const Vec3 &from, const Vec3 &along,
                 const Vec3 &rise) {
    return {name, what, [=](const TrialSetting &setting) {
                return compare_with_direct({parallelogram(from, along, rise, 0)}, parallelogram(from, along, rise, 0),
                                           setting);
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
        {"two-blockers-in-one-plane", "Two blockers side by side in one plane shade as one", two_in_one_plane},
        {"wire", "A wire of a millionth of the floor's size leaves the floor Lambert's radiosity", wire},
        upright("cut-along-a-side", "A blocker that stands on the floor's side" + exact, Vec3(0, 0, 0), 0.9 * y,
                0.3 * z),
        upright("cut-through-corners", "A blocker whose plane meets two of the floor's corners" + exact,
                Vec3(0.5, 0.5, 0.1), Vec3(0.3, 0.3, 0), 0.3 * z),
    };
}

} // namespace penumbra
