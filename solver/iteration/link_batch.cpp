#include "iteration/link_batch.h"

#include "core/check.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <tuple>

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

struct Placed {
    const Link *link;
    SurfaceId source;
    int order;

    auto key() const { return std::tuple(link->kernel.rows(), link->kernel.cols(), source); }
};

} // namespace

LinkBatch::LinkBatch(const Forest &forest, const Interactions &interactions) : interactions_(interactions) {
    if (!interactions.empty())
        receiver_ = forest[interactions.front()->receiver].basis;
    std::vector<Placed> links;
    std::size_t n_values = 0;
    for (const auto &interaction : interactions)
        for (const Link &link : interaction->links) {
            links.push_back({&link, interaction->source, interaction->order});
            n_values += static_cast<std::size_t>(link.kernel.size());
        }
    std::ranges::stable_sort(links, {}, &Placed::key);
    kernels_.reserve(n_values);
    sources_.reserve(links.size());
    for (const auto &[link, source, order] : links) {
        const Run one{order, link->kernel.rows(), link->kernel.cols(), 0, sources_.size(), kernels_.size()};
        const bool another = runs_.empty() || runs_.back().rows != one.rows || runs_.back().columns != one.columns;
        if (another)
            runs_.push_back(one);
        if (another || parts_.back().source != source)
            parts_.push_back({source, one});
        ++runs_.back().n_links;
        ++parts_.back().links.n_links;
        sources_.push_back(forest[link->source].first);
        kernels_.insert(kernels_.end(), link->kernel.data(), link->kernel.data() + link->kernel.size());
    }
}

std::size_t LinkBatch::bytes() const {
    return kernels_.size() * sizeof(double) + sources_.size() * sizeof(std::int32_t);
}

void LinkBatch::add(const Run &run, const Coefficients &radiosity, Rows irradiance) const {
    const double *kernels = kernels_.data() + run.first_value;
    const std::int32_t *sources = sources_.data() + run.first_link;
    if (run.rows * run.columns == 1) {
        add_constants(kernels, sources, run.n_links, radiosity.data(), irradiance);
    } else if (run.rows == 1 || run.rows == irradiance.rows()) {
        adder(run.rows)(kernels, sources, run.n_links, run.columns, radiosity.data(), irradiance);
    } else {
        Coefficients lower = Coefficients::Zero(run.rows, 3);
        adder(run.rows)(kernels, sources, run.n_links, run.columns, radiosity.data(), lower);
        for (int k = 0; k < static_cast<int>(run.rows); ++k)
            irradiance.row(receiver_.place(run.order, k)) += lower.row(k);
    }
}

void LinkBatch::add_irradiance(const Coefficients &radiosity, Rows irradiance) const {
    for (const Run &run : runs_)
        add(run, radiosity, irradiance);
}

std::size_t LinkBatch::add_irradiance_from(SurfaceId source, const Coefficients &radiosity, Rows irradiance) const {
    std::size_t n_links = 0;
    for (const Part &part : parts_)
        if (part.source == source) {
            add(part.links, radiosity, irradiance);
            n_links += part.links.n_links;
        }
    return n_links;
}

std::vector<char> renew(std::vector<std::shared_ptr<const LinkBatch>> &batches, const Forest &forest,
                        const std::vector<LinkBatch::Interactions> &interactions, const Cancel *cancel) {
    std::vector<char> renewed(interactions.size(), 0);
    batches.resize(interactions.size());
    parallel_for(interactions.size(), [&](std::size_t e) {
        if (cancel)
            cancel->check();
        const bool up_to_date =
            batches[e] ? batches[e]->made_from(interactions[e]) : interactions[e].empty();
        if (up_to_date)
            return;
        renewed[e] = 1;
        batches[e] = interactions[e].empty() ? nullptr : std::make_shared<const LinkBatch>(forest, interactions[e]);
    });
    return renewed;
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
