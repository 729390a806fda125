// The relative L2 error of B - E in tables of this folder.
#pragma once

#include "solved.h"

#include "iteration/state.h"
#include "reference/solution.h"

namespace penumbra {

/// Against the exact direct solution where light bounces once, else against a solution with a tenth of the threshold and
/// two more levels, in the parametric basis.
class TrueError {
public:
    TrueError(std::shared_ptr<const Scene> scene, double threshold) : scene_(std::move(scene)) {
        if (has_one_bounce(*scene_))
            return;
        Options options = options_of(Strategy::discontinuity_wavelet, threshold / 10);
        options.max_depth += 2;
        Solver solver(scene_, options);
        solver.run();
        reference_ = solver.state();
    }

    bool one_bounce() const { return !reference_; }
    double of(const Solver &solver) const {
        return reference_ ? reference::root_mean_square_difference(*scene_, *solver.state(), *reference_) /
                                reference::root_mean_square_reflected(*scene_, *reference_)
                          : solver.snapshot(true)->error;
    }

private:
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const State> reference_;
};

} // namespace penumbra
