#include "iteration/allowance.h"

#include "measure/direct.h"
#include "measure/error_estimate.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr double first_share = 0.5; // of a guess

/// Before anything was gathered: the light of the emitters in the middle of every root.
struct FirstLight {
    double peak = 0, mean_square = 0; ///< of B - E: largest channel; all channels, over the area
};

FirstLight first_light(const Setting &setting, const State &state) {
    const Scene &scene = *setting.scene;
    FirstLight out;
    double area = 0;
    Work uncounted;
    for (const auto &roots : state.forest.roots)
        for (const ElementId root : roots) {
            const Element &e = state.forest[root];
            if (!scene.reflects(e.surface))
                continue;
            const Rgb reflected = scene.reflectance(e.surface) *
                                  direct_irradiance(scene, *setting.blockers, e.surface, e.basis.centre(), uncounted,
                                                    setting.hidden_pairs.get());
            out.peak = std::max(out.peak, reflected.maxCoeff());
            out.mean_square += e.basis.area() * reflected.square().sum();
            area += e.basis.area();
        }
    if (area > 0)
        out.mean_square /= area;
    return out;
}

} // namespace

Allowance::Allowance(const Setting &setting, const State &state) : mean_square_(setting.options.tolerance.has_value()) {
    const double threshold = state.counters.threshold;
    if (state.peak == 0 && setting.blockers) {
        // Links are judged again by what they bring.
        const FirstLight light = first_light(setting, state);
        total_ = mean_square_ ? threshold * std::sqrt(light.mean_square) : threshold / (1 + threshold) * light.peak;
        total_ *= first_share;
        return;
    }
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
