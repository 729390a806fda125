#include "iteration/allowance.h"

#include "measure/error_estimate.h"

#include <cmath>

namespace penumbra {

Allowance::Allowance(const Setting &setting, const State &state) : mean_square_(setting.options.tolerance.has_value()) {
    const double threshold = state.counters.threshold;
    if (!mean_square_) {
        total_ = threshold / (1 + threshold) * state.peak;
        return;
    }
    const Scene &scene = *setting.scene;
    n_nodes_ = area_ = 0;
    for (const Element &e : state.forest.elements)
        if (e.leaf() && scene.reflects(e.surface)) {
            ++n_nodes_;
            area_ += e.basis.area();
        }
    if (area_ > 0)
        total_ = threshold * std::sqrt(reflected_square(scene, state.forest, state.radiosity) / area_);
}

double Allowance::measured(const Interaction &interaction, const State &state, const Rgb &reflectance) const {
    if (!mean_square_)
        return (reflectance * interaction.largest_misfit(state.forest, state.radiosity)).maxCoeff();
    return std::sqrt((reflectance.square() * interaction.mean_square_misfit(state.forest, state.radiosity)).sum());
}

} // namespace penumbra
