// A small scene, made in memory, solved, and looked at in its own frame.
#pragma once

#include "core/cancel.h"
#include "iteration/state.h"
#include "study/measurement.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace penumbra {

/// A polygon, counter-clockwise seen from its front.
struct Face {
    std::vector<Vec3> corners;
    double reflectance = 0; ///< of all channels, in [0, 1)
    double exitance = 0;    ///< of all channels [W/m2]
};
using Faces = std::vector<Face>;

/// The parallelogram from its corner; the front is that of a x b.
Face parallelogram(const Vec3 &corner, const Vec3 &a, const Vec3 &b, double reflectance, double exitance = 0);
/// The six walls of a box from 0 to `far`, looking inwards.
Faces room(const Vec3 &far, double reflectance, double exitance = 0);

struct TrialSetting {
    Options options;
    const Cancel *cancel = nullptr;
    std::function<void(const Faces &)> on_solve{}; ///< is shown what solve() is about to solve; may throw
};

/// Checked as a file would be; surface i is face i.
Scene build_scene(const Faces &faces, const std::string &name);

struct Trial {
    TrialSetting setting;
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const State> state;
    std::shared_ptr<const Snapshot> snapshot;
};

/// Solves to the fixed point or Options::max_iterations, and then goes on for `more` steps. Throws Cancelled, and BadInput where a reader would.
Trial solve(const Faces &faces, const TrialSetting &setting, int more = 0);

/// Not finite values (none), how far below 0 any radiosity falls (at 5 x 5 points of each leaf's tiles that no cover
/// hides, as a fraction of the largest reflected radiosity; at most the threshold) and whether the fixed point was
/// missed (0 or 1; it may not be).
std::vector<Measurement> soundness(const Trial &trial);

/// Points of the parallelogram: the centres of 40 x 40 and of 41 x 41 equal cells, so that they lie both on and beside
/// the lines through its middle.
std::vector<Vec3> grid(const Vec3 &corner, const Vec3 &a, const Vec3 &b);

/// Radiosity of the largest channel at a point of a surface (own frame) [W/m2]; not a number where no leaf is.
double radiosity(const Trial &trial, const Vec3 &x, const Vec3 &normal);

/// Largest |B_h - B| at the points as a fraction of the largest |B| there; infinite where no leaf is or B is dark.
double largest_error(const Trial &trial, const std::vector<Vec3> &points, const Vec3 &normal,
                     const std::function<double(const Vec3 &)> &exact);

/// Largest |B| at the points [W/m2].
double largest_radiosity(const Trial &trial, const std::vector<Vec3> &points, const Vec3 &normal);

} // namespace penumbra
