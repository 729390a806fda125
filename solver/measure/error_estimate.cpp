#include "measure/error_estimate.h"

#include "core/check.h"
#include "core/percent.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra {

namespace {

/// The 99 % quantile of Student's t with n degrees of freedom (the last entry serves all beyond).
double student_t(std::size_t n) {
    constexpr std::array table{31.821, 6.965, 4.541, 3.747, 3.365, 3.143, 2.998, 2.896, 2.821, 2.764,
                               2.718,  2.681, 2.650, 2.624, 2.602, 2.583, 2.567, 2.552, 2.539, 2.528};
    return table[std::clamp<std::size_t>(n, 1, table.size()) - 1];
}

/// Mean of the batches' sums, and how far above it its limit lies.
struct Limited {
    double mean = 0, spread = 0;

    explicit Limited(const std::vector<double> &sums) {
        const double n = static_cast<double>(sums.size());
        for (const double s : sums)
            mean += s / n;
        double variance = 0;
        for (const double s : sums)
            variance += (s - mean) * (s - mean) / (n - 1);
        spread = student_t(sums.size() - 1) * std::sqrt(variance / n);
    }
};

double root(double x) { return std::sqrt(std::max(0.0, x)); }

} // namespace

double reflected_square(const Scene &scene, const Forest &forest, const Coefficients &radiosity) {
    double sum = 0;
    for (const Element &e : forest.elements) {
        if (!e.leaf() || !scene.reflects(e.surface))
            continue;
        const auto b = radiosity.middleRows(e.first, e.basis.n_functions());
        for (const QuadraturePoint &q : e.basis.quadrature(e.basis.order() + 1))
            if (!is_covered(scene.surface(e.surface), q.position)) {
                const Rgb value = (e.basis.evaluate(q).transpose() * b).transpose().array();
                sum += q.area * (value - scene.exitance(e.surface)).square().sum();
            }
    }
    return sum;
}

ErrorEstimate estimate_error(std::span<const std::vector<ResidualPoint>> batches,
                             std::span<const std::vector<Rgb>> correction, double reflected_square,
                             double largest_reflectance) {
    PENUMBRA_CHECK(batches.size(), >, 1u);
    PENUMBRA_CHECK(batches.size(), ==, correction.size());
    ErrorEstimate out;
    std::vector<double> errors, residuals;
    double noise = 0, bounced = 0;
    for (std::size_t b = 0; b < batches.size(); ++b) {
        double error = 0, residual = 0;
        for (std::size_t k = 0; k < batches[b].size(); ++k) {
            const ResidualPoint &p = batches[b][k];
            const Rgb &more = correction[b][k];
            error += p.area * ((p.first + more) * (p.second + more)).sum();
            residual += p.area * (p.first * p.second).sum();
            bounced += p.area * more.square().sum();
            noise += p.area * 0.5 * (p.first - p.second).square().sum();
        }
        errors.push_back(error);
        residuals.push_back(residual);
        out.n_points += static_cast<int>(batches[b].size());
    }
    if (!(reflected_square > 0))
        return out;
    const Limited e(errors), r(residuals);
    const double scale = std::sqrt(reflected_square);
    out.mean_square = e.mean / reflected_square;
    out.spread = e.spread / reflected_square;
    out.error = root(e.mean) / scale;
    out.upper = std::sqrt(std::max(e.mean, 0.0) + e.spread) / scale;
    out.residual = root(r.mean) / scale;
    out.bound = std::sqrt(std::max(r.mean, 0.0) + r.spread) / scale / (1 - largest_reflectance);
    out.bounced = root(bounced / static_cast<double>(batches.size())) / scale;
    out.noise = root(noise / static_cast<double>(batches.size())) / scale;
    return out;
}

std::string error_in_words(const Counters &counters) {
    return percent(counters.estimated_error) + " (at most " + percent(counters.error_bound) + " with " +
           percent(ErrorEstimate::confidence) + " confidence)";
}

} // namespace penumbra
