#include "study/case_groups.h"

#include "study/lit_floor.h"

#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

Faces plain() { return {parallelogram(o, x, y, 0.5), parallelogram(Vec3(0.1, 0.2, 0.5), 0.4 * y, 0.4 * x, 0, 1)}; }

HardCase shared_edge(const std::string &name, const std::string &angle, double degrees) {
    return {name, "A square lit by one that shares an edge with it at " + angle + " has Lambert's radiosity",
            [degrees](const TrialSetting &setting) {
                const double a = degrees * std::numbers::pi / 180;
                const Vec3 rise(std::cos(a), 0, std::sin(a));
                return compare_with_lambert({parallelogram(o, x, y, 0.5), parallelogram(o, y, rise, 0, 1)},
                                            grid(o, x, y), setting);
            }};
}

std::vector<Measurement> at_one_corner(const TrialSetting &setting) {
    return compare_with_lambert({parallelogram(o, x, y, 0.5), parallelogram(x + y, x, z, 0, 1)}, grid(o, x, y),
                                setting);
}

/// The light of a square on one in its plane, `apart` from it.
std::vector<Measurement> in_one_plane(double apart, bool turned_over, const TrialSetting &setting) {
    const Vec3 corner = (1 + apart) * x;
    const Face receiver = turned_over ? parallelogram(corner, y, x, 0.5) : parallelogram(corner, x, y, 0.5);
    const Trial trial = solve({receiver, parallelogram(o, x, y, 0.5, 1)}, setting);
    std::vector<Measurement> out = soundness(trial);
    out.push_back({"radiosity [W/m2]", largest_radiosity(trial, grid(corner, x, y), turned_over ? Vec3(-z) : z), 0});
    return out;
}

std::vector<Measurement> lamp_in_wall(const TrialSetting &setting) {
    const Face lamp = parallelogram(0.3 * y + 0.3 * z, 0.4 * y, 0.4 * z, 0, 1);
    // A black wall: the floor's light is the lamp's alone. A black floor: the wall has none.
    auto out =
        compare_with_lambert({parallelogram(o, x, y, 0.5), lamp, parallelogram(o, y, z, 0)}, grid(o, x, y), setting);
    const Trial trial = solve({parallelogram(o, x, y, 0), lamp, parallelogram(o, y, z, 0.5)}, setting);
    out.push_back({"radiosity of the wall [W/m2]", largest_radiosity(trial, grid(o, y, 0.3 * z), x), 0});
    return out;
}

std::vector<Measurement> duplicates(const TrialSetting &setting) {
    const Faces once = plain();
    const std::vector<Vec3> points = grid(o, x, y);
    std::vector<Measurement> out = compare_with_lambert({once[0], once[1], once[0], once[1]}, points, setting);
    const Trial one = solve(once, setting), two = solve({once[0], once[1], once[0], once[1]}, setting);
    out.push_back({"difference from one of each",
                   largest_error(two, points, z, [&](const Vec3 &p) { return radiosity(one, p, z); }),
                   setting.options.threshold});
    return out;
}

/// Floor and lamp in three parts each, the seam of two of them ending in the middle of the third's side.
std::vector<Measurement> t_junctions(const TrialSetting &setting) {
    const Vec3 corner(0.1, 0.2, 0.5);
    const auto lamp = [&](double from_x, double from_y, double wide, double deep) {
        return parallelogram(corner + from_x * x + from_y * y, deep * y, wide * x, 0, 1);
    };
    const Faces faces{parallelogram(o, 0.5 * x, y, 0.5),
                      parallelogram(0.5 * x, 0.5 * x, 0.4 * y, 0.5),
                      parallelogram(0.5 * x + 0.4 * y, 0.5 * x, 0.6 * y, 0.5),
                      lamp(0, 0, 0.2, 0.4),
                      lamp(0.2, 0, 0.2, 0.1),
                      lamp(0.2, 0.1, 0.2, 0.3)};
    return compare_with_lambert(faces, lamp(0, 0, 0.4, 0.4), grid(o, x, y), setting);
}

} // namespace

std::vector<HardCase> touching_cases() {
    return {
        {"plain", "To compare the others with: a floor under a lamp, nothing hard, has Lambert's radiosity",
         [](const TrialSetting &setting) { return compare_with_lambert(plain(), grid(o, x, y), setting); }},
        shared_edge("edge-90-degrees", "90 degrees", 90),
        shared_edge("edge-10-degrees", "10 degrees", 10),
        shared_edge("edge-1-degree", "1 degree", 1),
        shared_edge("edge-0.01-degree", "0.01 degree", 0.01),
        {"one-corner", "A square lit by one that touches it at a corner has Lambert's radiosity", at_one_corner},
        {"coplanar-neighbours", "Neighbours in one plane bring each other nothing, exactly",
         [](const TrialSetting &setting) { return in_one_plane(0, false, setting); }},
        {"in-the-emitters-plane", "A receiver apart in the emitter's plane is dark, exactly",
         [](const TrialSetting &setting) { return in_one_plane(0.5, false, setting); }},
        {"in-the-emitters-plane-turned", "And so is one that looks the other way",
         [](const TrialSetting &setting) { return in_one_plane(0.5, true, setting); }},
        {"emitter-in-a-wall", "An emitter that lies in a wall lights the floor as if alone, and the wall not at all",
         lamp_in_wall},
        {"t-junctions", "A floor and a lamp in parts that meet in T-junctions give Lambert's radiosity of the whole",
         t_junctions},
        {"duplicates", "Polygons that are there twice give the solution of one of each", duplicates},
    };
}

} // namespace penumbra
