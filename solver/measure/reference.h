// What radiosity on a scene really is, to be asked point by point.
#pragma once

#include "measure/residual.h"

#include <memory>
#include <vector>

namespace penumbra {

/// A solution that was brought far enough to be gathered from.
struct ConvergedSolution {
    std::shared_ptr<const Forest> forest;
    Coefficients radiosity;
    double error = 0; ///< of a reference made from it, see Reference::error
};

/// B(x) = E + rho (what the emitters bring, each by its exact visible part + what the reflected light of a solution that
/// was brought far enough brings), gathered at each point anew: elements and links at x have no part in it, and an error
/// of the solution that averages out over what x sees is gone. Immutable; may be asked from several threads.
class Reference {
public:
    /// Where light bounces once (iteration/solver.h, has_one_bounce): exact.
    explicit Reference(std::shared_ptr<const Scene> scene);
    Reference(std::shared_ptr<const Scene> scene, ConvergedSolution solution);
    ~Reference();
    Reference(Reference &&) noexcept;

    /// B at a point of a surface's plane [W/m2]; 0 where covered.
    Rgb radiosity_at(SurfaceId surface, const Vec2 &point) const;
    Rgb radiosity_at(SurfaceId surface, const Vec2 &point, Work &work) const;
    /// Its own relative L2 error of B - E over the reflecting surfaces, about: 0 where exact.
    double error() const { return error_; }

private:
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<const Blockers> blockers_;
    std::shared_ptr<const Forest> forest_;
    std::unique_ptr<const ReflectedGather> gather_; ///< null where light bounces once
    double error_ = 0;
};

/// ||B_h - B|| / ||B - E|| in L2 over the reflecting surfaces and the three channels together, B the reference, at n_points
/// stratified random points of B_h's elements (residual.h): for 4096 points mostly within a tenth of the integral's.
double error_against(const Reference &reference, const Scene &scene, const Field &judged, int n_points,
                     const Cancel *cancel = nullptr);

} // namespace penumbra
