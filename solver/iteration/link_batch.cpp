#include "iteration/link_batch.h"

#include "core/check.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <utility>

namespace penumbra {

namespace {

using Rows = Eigen::Ref<Coefficients>;

/// How far ahead memory is asked for, in values: 2 KiB. What the processor foresees by itself ends at a page's border, and
/// leaves it waiting for half of the time (tests/bench/README.md).
constexpr std::size_t ahead = 256, line = 8;

/// A run of links of R rows. A kernel's column is a vector: one sum for each row and channel, in loops that the compiler
/// makes vector instructions of.
template <std::size_t R>
void add_run(const double *kernel, const std::int32_t *sources, std::size_t n_links, Eigen::Index columns,
             const double *radiosity, Rows irradiance) {
    std::array<double, R> red{}, green{}, blue{};
    for (std::size_t l = 0; l < n_links; ++l) {
        const double *b = radiosity + 3 * static_cast<std::ptrdiff_t>(sources[l]);
        for (Eigen::Index j = 0; j < columns; ++j, kernel += R, b += 3) {
            for (std::size_t i = 0; i < R; i += line)
                __builtin_prefetch(kernel + ahead + i);
            for (std::size_t i = 0; i < R; ++i)
                red[i] += kernel[i] * b[0];
            for (std::size_t i = 0; i < R; ++i)
                green[i] += kernel[i] * b[1];
            for (std::size_t i = 0; i < R; ++i)
                blue[i] += kernel[i] * b[2];
        }
    }
    for (std::size_t i = 0; i < R; ++i)
        irradiance.row(static_cast<Eigen::Index>(i)) += Eigen::RowVector3d(red[i], green[i], blue[i]);
}

/// Pairs of constants: sums of every other link, so that none waits for the one before.
void add_constants(const double *kernel, const std::int32_t *sources, std::size_t n_links, const double *radiosity,
                   Rows irradiance) {
    Eigen::RowVector3d even = Eigen::RowVector3d::Zero(), odd = even;
    const auto add = [&](std::size_t l, Eigen::RowVector3d &sum) {
        sum += kernel[l] * Eigen::RowVector3d::Map(radiosity + 3 * static_cast<std::ptrdiff_t>(sources[l]));
    };
    std::size_t l = 0;
    for (; l + line <= n_links; l += line) {
        __builtin_prefetch(kernel + ahead + l);
        __builtin_prefetch(sources + ahead + l);
        for (std::size_t i = 0; i < line; i += 2) {
            add(l + i, even);
            add(l + i + 1, odd);
        }
    }
    for (; l < n_links; ++l)
        add(l, even);
    irradiance.row(0) += even + odd;
}

auto adder(Eigen::Index rows) {
    switch (rows) {
    case 1: return add_run<1>;
    case 3: return add_run<3>;
    case 4: return add_run<4>;
    case 6: return add_run<6>;
    case 9: return add_run<9>;
    case 10: return add_run<10>;
    default: PENUMBRA_CHECK(rows, ==, 16); return add_run<16>;
    }
}

std::pair<Eigen::Index, Eigen::Index> shape(const Link *link) { return {link->kernel.rows(), link->kernel.cols()}; }

} // namespace

LinkBatch::LinkBatch(const Forest &forest, const Interactions &interactions) : interactions_(interactions) {
    std::vector<const Link *> links;
    std::size_t n_values = 0;
    for (const auto &interaction : interactions)
        for (const Link &link : interaction->links) {
            links.push_back(&link);
            n_values += static_cast<std::size_t>(link.kernel.size());
        }
    std::ranges::stable_sort(links, {}, shape);
    kernels_.reserve(n_values);
    sources_.reserve(links.size());
    for (const Link *link : links) {
        const auto [rows, columns] = shape(link);
        if (runs_.empty() || runs_.back().rows != rows || runs_.back().columns != columns)
            runs_.push_back({rows, columns, 0});
        ++runs_.back().n_links;
        sources_.push_back(forest[link->source].first);
        kernels_.insert(kernels_.end(), link->kernel.data(), link->kernel.data() + link->kernel.size());
    }
}

std::size_t LinkBatch::bytes() const {
    return kernels_.size() * sizeof(double) + sources_.size() * sizeof(std::int32_t);
}

void LinkBatch::add_irradiance(const Coefficients &radiosity, Rows irradiance) const {
    const double *kernel = kernels_.data();
    const std::int32_t *source = sources_.data();
    for (const Run &run : runs_) {
        if (run.rows * run.columns == 1)
            add_constants(kernel, source, run.n_links, radiosity.data(), irradiance);
        else
            adder(run.rows)(kernel, source, run.n_links, run.columns, radiosity.data(), irradiance);
        kernel += run.n_links * static_cast<std::size_t>(run.rows * run.columns);
        source += run.n_links;
    }
}

void renew(std::vector<std::shared_ptr<const LinkBatch>> &batches, const Forest &forest,
           const std::vector<LinkBatch::Interactions> &interactions, const Cancel *cancel) {
    batches.resize(interactions.size());
    parallel_for(interactions.size(), [&](std::size_t e) {
        if (cancel)
            cancel->check();
        if (interactions[e].empty())
            batches[e] = nullptr;
        else if (!batches[e] || !batches[e]->made_from(interactions[e]))
            batches[e] = std::make_shared<const LinkBatch>(forest, interactions[e]);
    });
}

std::int64_t link_bytes(const std::vector<LinkBatch::Interactions> &interactions,
                        const std::vector<std::shared_ptr<const LinkBatch>> &batches) {
    std::size_t bytes = 0;
    for (const auto &here : interactions)
        for (const auto &interaction : here)
            for (const Link &link : interaction->links)
                bytes += sizeof(Link) + static_cast<std::size_t>(link.kernel.size() + link.misfit.size()) * sizeof(double);
    for (const auto &batch : batches)
        bytes += batch ? batch->bytes() : 0;
    return static_cast<std::int64_t>(bytes);
}

} // namespace penumbra
