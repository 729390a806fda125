#include "study/trial.h"

#include "iteration/probe.h"
#include "iteration/solver.h"
#include "scene/build_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double least_radiosity(const Trial &trial) {
    double least = 0;
    for (const Element &e : trial.state->forest.elements) {
        if (!e.leaf())
            continue;
        const auto b = trial.state->radiosity.middleRows(e.first, e.basis.n_functions());
        for (const BilinearQuad &tile : e.basis.tiles())
            for (int i = 0; i < 5; ++i)
                for (int j = 0; j < 5; ++j) {
                    const Vec2 p = tile.at((i + 0.5) / 5, (j + 0.5) / 5);
                    if (!is_covered(trial.scene->surface(e.surface), p))
                        least = std::min(least, (e.basis.evaluate(p).transpose() * b).minCoeff());
                }
    }
    return least;
}

} // namespace

Scene build_scene(const Faces &faces, const std::string &called) {
    RawScene raw;
    raw.name = called;
    for (const Face &face : faces) {
        const int number = static_cast<int>(raw.faces.size());
        const std::string name = std::to_string(number);
        raw.materials.push_back({"material " + name, Rgb::Constant(face.reflectance), Rgb::Constant(face.exitance)});
        raw.faces.push_back({"face " + name, called + ":" + name, number, false, face.corners});
    }
    return build_scene(std::move(raw));
}

Face parallelogram(const Vec3 &corner, const Vec3 &a, const Vec3 &b, double reflectance, double exitance) {
    return {{corner, corner + a, corner + a + b, corner + b}, reflectance, exitance};
}

Faces room(const Vec3 &far, double reflectance, double exitance) {
    const Vec3 x = far.x() * Vec3::UnitX(), y = far.y() * Vec3::UnitY(), z = far.z() * Vec3::UnitZ(), o = Vec3::Zero();
    const auto wall = [&](const Vec3 &corner, const Vec3 &a, const Vec3 &b) {
        return parallelogram(corner, a, b, reflectance, exitance);
    };
    return {wall(o, x, y), wall(z, y, x), wall(o, z, x), wall(y, x, z), wall(o, y, z), wall(x, z, y)};
}

Trial solve(const Faces &faces, const TrialSetting &setting, int more) {
    if (setting.on_solve)
        setting.on_solve(faces);
    const auto scene = std::make_shared<const Scene>(build_scene(faces, "trial"));
    Solver solver(scene, setting.options, setting.cancel);
    solver.run(setting.cancel);
    for (int k = 0; k < more; ++k)
        solver.step(setting.cancel);
    return {setting, scene, solver.state(), solver.snapshot()};
}

std::vector<Measurement> soundness(const Trial &trial) {
    const double peak = trial.state->peak, least = least_radiosity(trial);
    return {{"values that are not finite", static_cast<double>((!trial.state->radiosity.array().isFinite()).count()), 0,
             true},
            {"fall below black, of the peak", least < 0 ? -least / peak : 0, trial.setting.options.threshold, true},
            {"fixed point missed", trial.state->counters.converged ? 0.0 : 1.0, 0, true}};
}

std::vector<Vec3> grid(const Vec3 &corner, const Vec3 &a, const Vec3 &b) {
    std::vector<Vec3> points;
    for (const int n : {40, 41})
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                points.push_back(corner + (i + 0.5) / n * a + (j + 0.5) / n * b);
    return points;
}

double radiosity(const Trial &trial, const Vec3 &x, const Vec3 &normal) {
    const auto found = radiosity_at(*trial.snapshot, x, normal, 1e-6 * trial.scene->own.size);
    return found ? found->maxCoeff() : std::numeric_limits<double>::quiet_NaN();
}

double largest_error(const Trial &trial, const std::vector<Vec3> &points, const Vec3 &normal,
                     const std::function<double(const Vec3 &)> &exact) {
    double error = 0, most = 0;
    for (const Vec3 &x : points) {
        const double b = exact(x), off = std::abs(radiosity(trial, x, normal) - b);
        error = std::isfinite(off) ? std::max(error, off) : infinite;
        most = std::max(most, std::abs(b));
    }
    return most > 0 ? error / most : infinite;
}

double largest_radiosity(const Trial &trial, const std::vector<Vec3> &points, const Vec3 &normal) {
    double most = 0;
    for (const Vec3 &x : points) {
        const double b = std::abs(radiosity(trial, x, normal));
        most = std::isfinite(b) ? std::max(most, b) : infinite;
    }
    return most;
}

} // namespace penumbra
