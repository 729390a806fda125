#include "iteration/measure_error.h"

#include "core/random.h"
#include "iteration/coarse_correction.h"
#include "measure/leaf_at.h"
#include "measure/reflected_gather.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace penumbra {

namespace {

using Batches = std::vector<std::vector<ResidualPoint>>;
using Means = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// K (I - K)^-1 r at the points.
std::vector<std::vector<Rgb>> correction(const Setting &setting, const State &state, const Batches &batches,
                                         const Cancel *cancel) {
    const Scene &scene = *setting.scene;
    std::vector<std::vector<Rgb>> out;
    for (const auto &batch : batches)
        out.emplace_back(batch.size(), Rgb::Zero());
    if (setting.one_bounce())
        return out;
    Means sum = Means::Zero(scene.n_surfaces(), 3);
    Eigen::VectorXd area = Eigen::VectorXd::Zero(scene.n_surfaces());
    for (const auto &batch : batches)
        for (const ResidualPoint &p : batch) {
            sum.row(p.surface.index) += (p.area * 0.5 * (p.first + p.second)).matrix().transpose();
            area[p.surface.index] += p.area;
        }
    const Means mean = (area.array() > 0).select(1 / area.array().max(1e-300), 0).matrix().asDiagonal() * sum;
    const Means constant = mean + bounces_to_come(setting, state, mean);
    Coefficients everywhere = Coefficients::Zero(state.forest.n_coefficients, 3), brought;
    for (const Element &e : state.forest.elements)
        everywhere.row(e.first) = constant.row(e.surface.index);
    push_pull(state.forest, scene, gathered(state, everywhere, cancel), brought);
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (std::size_t k = 0; k < batches[b].size(); ++k) {
            const ResidualPoint &p = batches[b][k];
            out[b][k] = radiosity_at(state.forest, brought, p.surface, p.at) - scene.exitance(p.surface);
        }
    return out;
}

double square(double x) { return x * x; }

/// What an exact gather may be wrong by, of the error that is asked for.
constexpr double gather_share = 0.1;

} // namespace

ErrorEstimate measure_error(const Setting &setting, const State &state, double goal, std::uint64_t seed,
                            const Cancel *cancel, Work &work) {
    constexpr double left_out = 1.1; // by a correction that takes r as constant on each surface; see the header
    constexpr std::size_t most_batches = 512;
    Solution solution{*setting.scene, *setting.blockers, setting.rays.get(), state.forest, state.radiosity};
    const double size = reflected_square(*setting.scene, state.forest, state.radiosity);
    solution.hidden = setting.hidden_pairs.get();
    std::optional<ReflectedGather> gather;
    ResidualSampling sampling;
    const auto gather_exactly = [&] {
        gather.emplace(*setting.scene, *setting.blockers, state.forest, state.radiosity, std::max(1e-6, gather_share * goal));
        solution.gather = &*gather;
        sampling.n_points = 32; // a point costs as much as hundreds of rays, and has no noise
    };
    if (!setting.rays && !setting.one_bounce())
        gather_exactly();
    Batches batches;
    std::int64_t n_rays = 0;
    for (std::uint64_t round = 0;; ++round) {
        sampling.seed = mixed(seed + mixed(round));
        Work done;
        Batches more = sample_residual(solution, {state.forest, state.radiosity}, sampling, cancel, done);
        work += done;
        n_rays += done.rays;
        batches.insert(batches.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
        ErrorEstimate e = estimate_error(batches, correction(setting, state, batches, cancel), size,
                                         setting.largest_reflectance());
        e.n_rays = n_rays;
        if (!setting.one_bounce())
            e.upper *= left_out;
        const bool undecided = e.mean_square < square(goal) && e.upper > goal;
        const bool known = e.spread <= (undecided ? 0.5 : 1) * e.mean_square;
        const bool above = e.mean_square - e.spread > square(goal);
        const bool far_below = e.upper < goal / 30; // below a tenth: more than was asked for, however much
        if (known || above || far_below || batches.size() >= most_batches)
            return e;
        if (e.noise > std::max(e.residual, 0.3 * goal)) {
            // The rays' noise is all that these points show.
            batches.clear();
            gather_exactly();
        } else {
            sampling.n_batches = static_cast<int>(std::max<std::size_t>(batches.size(), 8));
        }
    }
}

} // namespace penumbra
