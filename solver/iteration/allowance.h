// How much the oracle lets pass, and in what norm.
#pragma once

#include "iteration/state.h"

#include <cmath>

namespace penumbra {

/// With a threshold the misfit of what one surface brings to a node is its maximum over the test points, and the same for
/// every node: threshold / (1 + threshold) of the peak, which may itself be too large by the threshold. With a tolerance
/// it is the root mean square over the test points, and every node may have the same share of the squared error: its
/// root mean square weighs as sqrt(|A_p| / A), A the area of the reflecting surfaces, and n nodes of the same share
/// together miss by sqrt(n) of it; so that the threshold in force is about the relative L2 error of the whole.
/// Before anything was gathered it is half of what a guess at the peak, or the mean, would allow.
class Allowance {
public:
    Allowance(const Setting &setting, const State &state);

    /// Misfit that passes at a node [W/m2].
    double misfit(const Element &p) const { return mean_square_ ? total_ / std::sqrt(n_nodes_ * p.basis.area() / area_) : total_; }
    /// Light that brings less, or detail of sources that does, does not matter by its share of this [W/m2].
    double anywhere() const { return total_; }
    bool mean_square() const { return mean_square_; }
    /// Of what the interaction misses, reflected, in the norm above [W/m2].
    double measured(const Interaction &interaction, const State &state, const Rgb &reflectance) const;

private:
    bool mean_square_;
    double total_ = 0; ///< with a tolerance: threshold times the root mean square of B - E
    double n_nodes_ = 1, area_ = 1;
};

} // namespace penumbra
