#include "study/case_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

const Vec3 hall(1, 1.5, 0.75);

/// One wall of each pair: corner, two sides and normal.
std::array<std::array<Vec3, 4>, 3> three_walls(const Vec3 &far) {
    const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    return {{{o, far.x() * x, far.y() * y, z}, {o, far.y() * y, far.z() * z, x}, {o, far.z() * z, far.x() * x, y}}};
}

/// All walls glow with 1 W/m2 and reflect alike.
struct Furnace {
    Trial trial;
    double exact;

    Furnace(const Vec3 &far, double reflectance, const TrialSetting &setting)
        : trial(solve(room(far, reflectance, 1), setting)), exact(1 / (1 - reflectance)) {}
};

HardCase furnace(const std::string &name, const std::string &what, const Vec3 &far, double reflectance, double bound) {
    return {name, what, [=](const TrialSetting &setting) {
                const Furnace furnace(far, reflectance, setting);
                std::vector<Measurement> out = soundness(furnace.trial);
                double most = 0;
                for (const auto &[corner, a, b, normal] : three_walls(far))
                    most = std::max(most, largest_error(furnace.trial, grid(corner, a, b), normal,
                                                        [&](const Vec3 &) { return furnace.exact; }));
                out.push_back({"error against E / (1 - rho)", most, bound});
                return out;
            }};
}

/// Plain steps would take thousands and more. Where three walls meet, what each of them brings has many values at once,
/// and the largest misfit of its fit stays at some percent on every level (DESIGN section 3); the root mean square
/// falls.
HardCase near_white(const std::string &name, double reflectance) {
    return {name,
            "In a room of walls that all glow and reflect " + name.substr(name.find('-') + 1) +
                ", radiosity is E / (1 - rho), after at most 200 steps",
            [=](const TrialSetting &setting) {
                TrialSetting patient = setting;
                patient.options.max_iterations = 1000;
                const Furnace furnace(hall, reflectance, patient);
                std::vector<Measurement> out = soundness(furnace.trial);
                double sum = 0;
                int n = 0;
                for (const auto &[corner, a, b, normal] : three_walls(hall))
                    for (const Vec3 &p : grid(corner, a, b)) {
                        const double off = radiosity(furnace.trial, p, normal) / furnace.exact - 1;
                        sum += off * off;
                        ++n;
                    }
                out.push_back(
                    {"root mean square error against E / (1 - rho)", std::sqrt(sum / n), setting.options.threshold});
                out.push_back(
                    {"steps to the fixed point", static_cast<double>(furnace.trial.state->counters.iteration), 200});
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
        near_white("furnace-0.999", 0.999),
        near_white("furnace-0.999999", 0.999999),
        {"long-after", "Steps after the fixed point change nothing but what was still to come", long_after},
        {"dark-room", "A closed room without light is dark, exactly and at once", dark_room},
    };
}

} // namespace penumbra
