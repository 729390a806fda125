#include "study/case_groups.h"

#include "study/replay.h"

#include <cmath>
#include <limits>

namespace penumbra {

namespace {

const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

/// A floor, a lamp and a card that reflects between the two.
Faces shaded_floor() {
    return {parallelogram(o, x, y, 0.5), parallelogram(Vec3(0.1, 0.2, 1), 0.3 * y, 0.3 * x, 0, 1),
            parallelogram(Vec3(0.4, 0.3, 0.25), 0.25 * x, Vec3(0.1, 0.4, 0.1), 0.5)};
}

/// Symmetric in x = 1/2.
Faces symmetric_floor() {
    return {parallelogram(o, x, y, 0.5), parallelogram(Vec3(0.3, 0.2, 1), 0.3 * y, 0.4 * x, 0, 1),
            parallelogram(Vec3(0.35, 0.3, 0.25), 0.3 * x, Vec3(0, 0.4, 0.1), 0)};
}

/// The scene and its image, solved each for itself, and once on the mesh and links of the first.
HardCase image(const std::string &name, const std::string &what, const Faces &faces, const Similarity &map,
               double replayed_bound) {
    return {
        name, what, [=](const TrialSetting &setting) {
            const Trial here = solve(faces, setting), there = solve(mapped(faces, map), setting);
            const Trial settled = replay(here, faces, Similarity::Identity()), replayed = replay(here, faces, map);
            const Vec3 normal = (map.linear() * z).normalized();
            // Off the lines on which elements meet: there rounding decides which of them is asked.
            const auto points = grid(Vec3(0.011, 0.007, 0), 0.973 * x, 0.967 * y);
            const auto difference = [&](const Trial &image, const Trial &from) {
                return largest_error(from, points, z, [&](const Vec3 &p) { return radiosity(image, map * p, normal); });
            };
            auto out = soundness(there);
            out.push_back({"difference, each solved for itself", difference(there, here), setting.options.threshold});
            out.push_back({"difference on the same mesh and links", difference(replayed, settled), replayed_bound});
            return out;
        }};
}

/// A power of two scales without rounding.
HardCase scaled(const std::string &name, int exponent) {
    return {name,
            "A scene that is 2^" + std::to_string(exponent) + " times as large has the same radiosity, to the last bit",
            [exponent](const TrialSetting &setting) {
                const Similarity map(Eigen::UniformScaling<double>(std::ldexp(1.0, exponent)));
                const Trial plain = solve(shaded_floor(), setting), other = solve(mapped(shaded_floor(), map), setting);
                const auto &a = plain.state->radiosity, &b = other.state->radiosity;
                auto out = soundness(other);
                out.push_back(
                    {"largest difference of a coefficient",
                     a.rows() == b.rows() ? (a - b).cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity(),
                     0});
                return out;
            }};
}

} // namespace

std::vector<HardCase> moved_cases() {
    const Similarity turned(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    const Similarity off = Eigen::Translation3d(1e5 * Vec3(1, -1, 1)) * turned;
    const Similarity mirror = Eigen::Translation3d(x) * Similarity(Eigen::Scaling(-1.0, 1.0, 1.0));
    return {
        scaled("scaled-up", 20),
        scaled("scaled-down", -20),
        image("million-times-larger", "A scene a million times as large has the same radiosity", shaded_floor(),
              Similarity(Eigen::UniformScaling<double>(1e6)), 1e-9),
        image("million-times-smaller", "A scene a millionth as large has the same radiosity", shaded_floor(),
              Similarity(Eigen::UniformScaling<double>(1e-6)), 1e-9),
        image("turned-shadow", "A scene that is turned about a skew axis has the same radiosity", shaded_floor(),
              turned, 1e-9),
        image("far-off-shadow", "A scene a hundred thousand sizes from the origin has the same radiosity",
              shaded_floor(), off, 1e-6),
        image("mirror", "A scene that is its own mirror image has radiosity that is its own mirror image",
              symmetric_floor(), mirror, 1e-9),
    };
}

} // namespace penumbra
