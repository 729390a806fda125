// How wrong a solution is, from what it leaves out of its equation.
#pragma once

#include "measure/residual.h"

#include <span>
#include <string>
#include <vector>

namespace penumbra {

/// All errors are L2 norms over the reflecting surfaces, the three channels together, relative to ||B_h - E||.
struct ErrorEstimate {
    double error = 0;       ///< ||B - B_h||, about
    double upper = 0;       ///< its upper confidence limit, as far as the points' luck goes
    double residual = 0;    ///< ||r||
    double bound = 0;       ///< the upper confidence limit of ||r|| / (1 - rho_max), which ||B - B_h|| does not exceed
    double bounced = 0;     ///< ||correction||: what B_h + r, gathered once more, still lacks, about
    double mean_square = 0; ///< the square of `error` before it is cut off at 0: noise may leave it negative
    double spread = 0;      ///< from there to its upper confidence limit
    double noise = 0;       ///< of one gather of r, root mean square
    int n_points = 0;
    std::int64_t n_rays = 0;

    static constexpr double confidence = 0.99; ///< one-sided, of both limits
};

/// ||B_h - E||^2 over the reflecting surfaces [(W/m2)^2, solver area], what is covered left out.
double reflected_square(const Scene &scene, const Forest &forest, const Coefficients &radiosity);

/// e = r + correction, correction[b][k] being K (I - K)^-1 r at point k of batch b: light that is missing is also missing
/// where it would be reflected to. ||e||^2 is the mean of e_1 e_2 with r's two gathers in place of r, which takes their
/// own noise out; limits by Student's t over the batches.
ErrorEstimate estimate_error(std::span<const std::vector<ResidualPoint>> batches,
                             std::span<const std::vector<Rgb>> correction, double reflected_square,
                             double largest_reflectance);

/// "0.41 % (at most 1.9 % with 99 % confidence)", of a state that was measured.
std::string error_in_words(const Counters &counters);

} // namespace penumbra
