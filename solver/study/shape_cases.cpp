#include "study/case_groups.h"

#include "study/lit_floor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace penumbra {

namespace {

const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

/// A unit floor whose lamp, a rectangle wide x deep, hangs above its middle.
HardCase lamp_above(const std::string &name, const std::string &what, double wide, double deep, double height) {
    return {name, what, [=](const TrialSetting &setting) {
                const Vec3 corner(0.5 - wide / 2, 0.5 - deep / 2, height);
                return compare_with_lambert(
                    {parallelogram(o, x, y, 0.5), parallelogram(corner, deep * y, wide * x, 0, 1)}, grid(o, x, y),
                    setting);
            }};
}

std::vector<Measurement> sliver_receiver(const TrialSetting &setting) {
    const Vec3 thin = 1e-6 * y;
    return compare_with_lambert(
        {parallelogram(o, x, thin, 0.5), parallelogram(Vec3(0.1, -0.2, 0.5), 0.4 * y, 0.4 * x, 0, 1)}, grid(o, x, thin),
        setting);
}

std::vector<Measurement> grazing(const TrialSetting &setting) {
    const double height = std::tan(0.01 * std::numbers::pi / 180);
    const Face lamp = parallelogram(-x + 0.9 * height * z, y, 0.2 * height * z, 0, 1);
    return compare_with_lambert({parallelogram(o, x, y, 0.5), lamp}, grid(o, x, y), setting);
}

/// `n` corners round the middle of the floor, every other one at half the radius.
std::vector<Vec3> star(int n, double radius, double height) {
    std::vector<Vec3> corners;
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * k / n, r = k % 2 == 0 ? radius : radius / 2;
        corners.emplace_back(0.5 + r * std::cos(a), 0.5 + r * std::sin(a), height);
    }
    return corners;
}

std::vector<Measurement> concave_receiver(const TrialSetting &setting) {
    const Face ell{{o, x, x + 0.4 * y, 0.4 * (x + y), 0.4 * x + y, y}, 0.5};
    std::vector<Vec3> points = grid(o, x, y);
    std::erase_if(points, [](const Vec3 &p) { return p.x() > 0.4 && p.y() > 0.4; });
    return compare_with_lambert({ell, parallelogram(Vec3(0.1, 0.2, 0.5), 0.4 * y, 0.4 * x, 0, 1)}, points, setting);
}

std::vector<Measurement> star_emitter(const TrialSetting &setting) {
    std::vector<Vec3> corners = star(64, 0.4, 0.5);
    std::ranges::reverse(corners);
    return compare_with_lambert({parallelogram(o, x, y, 0.5), Face{corners, 0, 1}}, grid(o, x, y), setting);
}

std::vector<Measurement> star_receiver(const TrialSetting &setting) {
    // Points well within the inner corners' circle.
    return compare_with_lambert(
        {Face{star(64, 0.8, 0), 0.5}, parallelogram(Vec3(0.1, 0.2, 0.5), 0.4 * y, 0.4 * x, 0, 1)},
        grid(Vec3(0.3, 0.3, 0), 0.4 * x, 0.4 * y), setting);
}

/// A floor and a lamp, turned about a skew axis and carried off by `shift`.
std::vector<Measurement> moved(double angle, const Vec3 &shift, const TrialSetting &setting) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    Faces faces{parallelogram(o, x, y, 0.5), parallelogram(Vec3(0.1, 0.2, 0.5), 0.4 * y, 0.4 * x, 0, 1)};
    for (Face &face : faces)
        for (Vec3 &corner : face.corners)
            corner = turn * corner + shift;
    return compare_with_lambert(faces, grid(shift, turn * x, turn * y), setting);
}

} // namespace

std::vector<HardCase> shape_cases() {
    return {
        {"sliver-receiver", "A receiver a million times as long as wide has Lambert's radiosity", sliver_receiver},
        lamp_above("sliver-emitter", "An emitter a million times as long as wide gives Lambert's radiosity", 1, 1e-6,
                   0.5),
        lamp_above("tiny-emitter", "An emitter of a millionth of the floor's size gives Lambert's radiosity", 1e-6,
                   1e-6, 0.5),
        lamp_above("huge-emitter", "An emitter of a thousand times the floor's size gives Lambert's radiosity", 1e3,
                   1e3, 0.5),
        {"grazing-light", "Light that comes in at 0.01 degree gives Lambert's radiosity", grazing},
        {"concave-receiver", "A concave receiver has Lambert's radiosity", concave_receiver},
        {"star-emitter", "An emitter with 64 corners, half of them concave, gives Lambert's radiosity", star_emitter},
        {"star-receiver", "A receiver with 64 corners, half of them concave, has Lambert's radiosity", star_receiver},
        {"turned", "A scene that is turned about a skew axis has Lambert's radiosity",
         [](const TrialSetting &setting) { return moved(0.7, o, setting); }},
        {"far-off", "A scene a hundred thousand sizes from the origin has Lambert's radiosity",
         [](const TrialSetting &setting) { return moved(0.7, 1e5 * Vec3(1, -1, 1), setting); }},
    };
}

} // namespace penumbra
