#include "study/case_groups.h"

#include <algorithm>
#include <array>
#include <limits>

namespace penumbra {

namespace {

const Vec3 hall(1, 1.5, 0.75);

HardCase furnace(const std::string &name, const std::string &what, const Vec3 &far, double reflectance, double bound) {
    return {
        name, what, [=](const TrialSetting &setting) {
            const Trial trial = solve(room(far, reflectance, 1), setting);
            const double expected = 1 / (1 - reflectance);
            std::vector<Measurement> out = soundness(trial);
            double most = 0;
            for (const auto &[corner, a, b, normal] :
                 {std::array<Vec3, 4>{Vec3::Zero(), far.x() * Vec3::UnitX(), far.y() * Vec3::UnitY(), Vec3::UnitZ()},
                  std::array<Vec3, 4>{Vec3::Zero(), far.y() * Vec3::UnitY(), far.z() * Vec3::UnitZ(), Vec3::UnitX()},
                  std::array<Vec3, 4>{Vec3::Zero(), far.z() * Vec3::UnitZ(), far.x() * Vec3::UnitX(), Vec3::UnitY()}})
                most = std::max(
                    most, largest_error(trial, grid(corner, a, b), normal, [&](const Vec3 &) { return expected; }));
            out.push_back({"error against E / (1 - rho)", most, bound});
            return out;
        }};
}

std::vector<Measurement> dark_room(const TrialSetting &setting) {
    const Trial trial = solve(room(hall, 0.8), setting);
    std::vector<Measurement> out = soundness(trial);
    out.push_back({"largest coefficient [W/m2]", trial.state->radiosity.cwiseAbs().maxCoeff(), 0});
    out.push_back({"iterations", static_cast<double>(trial.state->counters.iteration), 1});
    return out;
}

/// A room with a lamp in its middle, at the fixed point and long after. The steps stop when what is to come is below a
/// tenth of the threshold.
std::vector<Measurement> long_after(const TrialSetting &setting) {
    Faces faces = room(hall, 0.5);
    faces.push_back(parallelogram(Vec3(0.4, 0.6, 0.5), 0.3 * Vec3::UnitY(), 0.2 * Vec3::UnitX(), 0, 1));
    const Trial then = solve(faces, setting), later = solve(faces, setting, 1000);
    const auto &a = then.state->radiosity, &b = later.state->radiosity;
    const double drift = a.rows() == b.rows() ? (a - b).cwiseAbs().maxCoeff() / then.state->peak
                                              : std::numeric_limits<double>::infinity();
    std::vector<Measurement> out = soundness(later);
    out.push_back({"drift in 1000 steps, of the peak", drift, 0.1 * setting.options.threshold});
    return out;
}

} // namespace

std::vector<HardCase> closed_room_cases() {
    return {
        furnace("furnace-black", "In a room of black walls that all glow, radiosity is what they emit", hall, 0, 1e-12),
        furnace("furnace-bright",
                "In a room of walls that all glow and reflect 0.9, radiosity is ten times what they emit", hall, 0.9,
                Options().threshold),
        furnace("tube",
                "And in a tube a hundred times as long as wide, whose walls reflect a half, twice what they emit",
                Vec3(100, 1, 1), 0.5, Options().threshold),
        {"long-after", "Steps after the fixed point change nothing but what was still to come", long_after},
        {"dark-room", "A closed room without light is dark, exactly and at once", dark_room},
    };
}

} // namespace penumbra
