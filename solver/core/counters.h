// Work done, in plain numbers.
#pragma once

#include "core/effects.h"

#include <cstdint>

namespace penumbra {

/// Work that a step did. Sums of integers, so that they do not depend on the order of threads.
struct Work {
    std::int64_t kernel_evaluations = 0; ///< G at a pair of points, or one closed-form polygon integral
    std::int64_t clips = 0;              ///< a source clipped by the cone of one blocker, for one receiver point
    std::int64_t rays = 0;
    std::int64_t pairs = 0; ///< of a surface's convex part and another surface, looked at for a link
    /// An emitter and a receiver, traced for curves: VE with EV, EEE and contacts each count. A reflector and a receiver
    /// count once.
    std::int64_t traced_pairs = 0, traced_reflectors = 0;
    std::int64_t products = 0; ///< of a kernel's coefficient and a channel's radiosity, in the gather
    std::int64_t link_evaluations = 0;   ///< links whose kernel was multiplied by a radiosity in the gather
    std::int64_t sampled_visibility = 0; ///< partly hidden evaluations that were sampled instead of clipped
    /// Curves that came within rounding of something when a node was split: ends that the cut moved onto a corner, and
    /// curves not cut along because they run along the cut or along a side.
    std::int64_t snapped_cuts = 0;
    /// Curves in failing nodes that were not worth a cut there (Options::least_gain).
    std::int64_t left_out_curves = 0;
    /// Work that an effect's switch, had it been on, would have asked for, in its unit (effects/ledger.h); less what was taken
    /// for spared before and had to be done after all.
    ByEffect<std::int64_t> spared;

    Work &operator+=(const Work &o) {
        kernel_evaluations += o.kernel_evaluations;
        clips += o.clips;
        rays += o.rays;
        pairs += o.pairs;
        traced_pairs += o.traced_pairs;
        traced_reflectors += o.traced_reflectors;
        products += o.products;
        link_evaluations += o.link_evaluations;
        sampled_visibility += o.sampled_visibility;
        snapped_cuts += o.snapped_cuts;
        left_out_curves += o.left_out_curves;
        for (const Effect e : all_effects)
            spared[e] += o.spared[e];
        return *this;
    }
};

/// State of the solution after a phase, and what the phases of the present iteration cost.
struct Counters {
    int iteration = 0;
    int patches = 0;          ///< leaves of surfaces with reflectance > 0
    std::int64_t coefficients = 0; ///< basis functions on these leaves (one set serves the three channels)
    std::int64_t links = 0;
    std::int64_t lower_links = 0; ///< of a lower order than the one asked for, on either side
    std::int64_t link_coefficients = 0; ///< K_ij of all links: what one gather multiplies with
    std::int64_t spared_link_coefficients = 0; ///< that these links would have besides, were all orders the full ones
    std::int64_t link_bytes = 0;        ///< memory that they take, with the gather's copies; known once gathered
    int channels = 3;         ///< that are solved for; the others are multiples of these
    int curves = 0;           ///< known so far: of emitters, and of reflectors whose light needed them
    int untraced_pairs = 0;   ///< reflectors and receivers whose curves were wanted, but too much stands between the two
    int nodes_at_limit = 0;   ///< nodes that failed the oracle at the depth limit and were kept
    int splits = 0;           ///< nodes split in this iteration
    int cuts = 0;             ///< of these, cut: along a curve, or in the best straight line
    bool refined = false;     ///< anything was split or linked in this iteration
    Work work;                ///< of this iteration
    Work total_work;          ///< of all iterations so far
    double refine_s = 0, gather_s = 0, push_pull_s = 0;
    double seconds = 0;       ///< of all iterations so far
    double measure_s = 0;     ///< of this iteration, for the error's estimate
    double threshold = 0;     ///< in force: the oracle's
    double estimated_error = -1; ///< relative L2 error of B - E, about; negative: not measured in this state
    double error_limit = -1; ///< upper confidence limit of that
    double error_bound = -1;  ///< that it does not exceed, with the confidence of ErrorEstimate; negative: not measured
    bool exhausted = false;   ///< steps lead nowhere: the tolerance is out of reach, or radiosity is not finite
    double change = 0;        ///< largest change of a radiosity in this iteration, as a fraction of the largest B - E
    bool settled = false;     ///< no refinement in this iteration, and a change below 0.1 threshold (1 - rho_max)
    bool converged = false;   ///< settled; with a tolerance also measured, and below it
};

} // namespace penumbra
