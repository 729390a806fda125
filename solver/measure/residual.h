// What a solution leaves out of the equation that it solves, at points that it never saw.
#pragma once

#include "core/cancel.h"
#include "core/counters.h"
#include "hierarchy/push_pull.h"
#include "visibility/blockers.h"
#include "visibility/ray_scene.h"

#include <cstdint>
#include <vector>

namespace penumbra {

class HiddenPairs;
class ReflectedGather;

/// A solution B_h and the scene that it is of.
struct Solution {
    const Scene &scene;
    const Blockers &blockers;
    const RayScene *rays; ///< null: `gather` instead, or no reflector's light reaches another
    const Forest &forest;
    const Coefficients &radiosity;
    const ReflectedGather *gather = nullptr; ///< takes the rays' place where given
    const HiddenPairs *hidden = nullptr;     ///< null: looked for at every point
};

/// Radiosity on the elements of the same scene.
struct Field {
    const Forest &forest;
    const Coefficients &radiosity;
};

/// A point of a reflecting surface, not covered.
struct ResidualPoint {
    SurfaceId surface;
    Vec2 at;            ///< in the surface's plane
    double area = 0;    ///< that it stands for: the sum of area f over the points is an unbiased estimate of the integral of f
    Rgb solution = Rgb::Zero(); ///< B_h - E [W/m2], of the field that is judged
    Rgb first = Rgb::Zero(), second = Rgb::Zero(); ///< two gathers of r = E + rho integral of G V B - B_h, with the same mean and noise of their own
};

struct ResidualSampling {
    int n_batches = 8;   ///< each a set of points of its own, independent of the others
    int n_points = 64;   ///< in each batch
    int n_strata = 16;   ///< of each of the two coordinates of a ray's direction: n_strata^2 rays a gather
    std::uint64_t seed = 0;
};

/// Fresh random points, nothing gathered yet: half of them fall by area, half by leaves of `judged`, and of these half by
/// those that a limit keeps, if there are any: most of the error may lie in slivers of a few of them. Batch after batch,
/// n_points or fewer each (points under covers are left out).
std::vector<std::vector<ResidualPoint>> draw_points(const Scene &scene, const Field &judged,
                                                    const ResidualSampling &sampling);

/// What `judged` (B_h) lacks at fresh random points of what the light of `solution` (B) makes of them; with B = B_h, the
/// residual of B_h. Gathered are the exact visible part of every emitter (direct.h), and B - E of what rays meet,
/// cosine-weighted and one in each stratum of directions, or, without noise, by solution.gather: links have no part in
/// either. Cancellable.
std::vector<std::vector<ResidualPoint>> sample_residual(const Solution &solution, const Field &judged,
                                                        const ResidualSampling &sampling, const Cancel *cancel,
                                                        Work &work);

/// Irradiance of reflected light (B_h - E) at a point, by n_strata^2 rays. `seed` and `stream` choose them.
Rgb reflected_irradiance(const Solution &solution, SurfaceId surface, const Vec2 &point, int n_strata,
                         std::uint64_t seed, std::uint64_t stream, Work &work);

} // namespace penumbra
