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

/// A sum over the channels that are solved for, and what it is in all three.
template <std::size_t C>
Eigen::RowVector3d expanded(const std::array<double, C> &solved, const Channels &channels) {
    if constexpr (C == 3)
        return {solved[0], solved[1], solved[2]};
    Eigen::RowVector3d all;
    std::size_t n = 0;
    for (std::size_t c = 0; c < 3; ++c)
        if (channels.of[c] == static_cast<int>(c))
            all[static_cast<Eigen::Index>(c)] = solved[n++];
    for (std::size_t c = 0; c < 3; ++c)
        all[static_cast<Eigen::Index>(c)] = channels.factor[c] * all[channels.of[c]];
    return all;
}

template <std::size_t C>
std::array<std::ptrdiff_t, C> solved_channels(const Channels &channels) {
    std::array<std::ptrdiff_t, C> solved{};
    std::size_t n = 0;
    for (int c = 0; c < 3; ++c)
        if (channels.of[static_cast<std::size_t>(c)] == c)
            solved[n++] = c;
    return solved;
}

/// A run of links of R rows, for C channels. A kernel's column is a vector: one sum for each row and channel, in loops that
/// the compiler makes vector instructions of.
template <std::size_t R, std::size_t C>
void add_run(const double *kernel, const std::int32_t *sources, std::size_t n_links, Eigen::Index columns,
             const double *radiosity, const Channels &channels, Rows irradiance) {
    const auto solved = solved_channels<C>(channels);
    std::array<std::array<double, R>, C> sums{};
    for (std::size_t l = 0; l < n_links; ++l) {
        const double *b = radiosity + 3 * static_cast<std::ptrdiff_t>(sources[l]);
        for (Eigen::Index j = 0; j < columns; ++j, kernel += R, b += 3) {
            for (std::size_t i = 0; i < R; i += line)
                __builtin_prefetch(kernel + ahead + i);
            for (std::size_t c = 0; c < C; ++c)
                for (std::size_t i = 0; i < R; ++i)
                    sums[c][i] += kernel[i] * b[C == 3 ? static_cast<std::ptrdiff_t>(c) : solved[c]];
        }
    }
    for (std::size_t i = 0; i < R; ++i) {
        std::array<double, C> row;
        for (std::size_t c = 0; c < C; ++c)
            row[c] = sums[c][i];
        irradiance.row(static_cast<Eigen::Index>(i)) += expanded(row, channels);
    }
}

/// Pairs of constants: sums of every other link, so that none waits for the one before.
template <std::size_t C>
void add_constants(const double *kernel, const std::int32_t *sources, std::size_t n_links, const double *radiosity,
                   const Channels &channels, Rows irradiance) {
    const auto solved = solved_channels<C>(channels);
    std::array<double, C> even{}, odd{};
    const auto add = [&](std::size_t l, std::array<double, C> &sum) {
        const double *b = radiosity + 3 * static_cast<std::ptrdiff_t>(sources[l]);
        for (std::size_t c = 0; c < C; ++c)
            sum[c] += kernel[l] * b[C == 3 ? static_cast<std::ptrdiff_t>(c) : solved[c]];
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
    for (std::size_t c = 0; c < C; ++c)
        even[c] += odd[c];
    irradiance.row(0) += expanded(even, channels);
}

template <std::size_t C>
auto adder(Eigen::Index rows) {
    switch (rows) {
    case 1: return add_run<1, C>;
    case 3: return add_run<3, C>;
    case 4: return add_run<4, C>;
    case 6: return add_run<6, C>;
    case 9: return add_run<9, C>;
    case 10: return add_run<10, C>;
    default: PENUMBRA_CHECK(rows, ==, 16); return add_run<16, C>;
    }
}

struct Placed {
    const Link *link;
    SurfaceId source;
    int order;

    auto key() const { return std::tuple(link->kernel.rows(), link->kernel.cols(), source); }
};

} // namespace

LinkBatch::LinkBatch(const Forest &forest, const Interactions &interactions, const Channels &channels)
    : channels_(channels), interactions_(interactions) {
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

template <std::size_t C>
void LinkBatch::add_channels(const Run &run, const Coefficients &radiosity, Rows irradiance) const {
    const double *kernels = kernels_.data() + run.first_value, *b = radiosity.data();
    const std::int32_t *sources = sources_.data() + run.first_link;
    if (run.rows * run.columns == 1) {
        add_constants<C>(kernels, sources, run.n_links, b, channels_, irradiance);
    } else if (run.rows == 1 || run.rows == irradiance.rows()) {
        adder<C>(run.rows)(kernels, sources, run.n_links, run.columns, b, channels_, irradiance);
    } else {
        Coefficients lower = Coefficients::Zero(run.rows, 3);
        adder<C>(run.rows)(kernels, sources, run.n_links, run.columns, b, channels_, lower);
        for (int k = 0; k < static_cast<int>(run.rows); ++k)
            irradiance.row(receiver_.place(run.order, k)) += lower.row(k);
    }
}

void LinkBatch::add(const Run &run, const Coefficients &radiosity, Rows irradiance) const {
    switch (channels_.n_solved()) {
    case 1: return add_channels<1>(run, radiosity, irradiance);
    case 2: return add_channels<2>(run, radiosity, irradiance);
    default: return add_channels<3>(run, radiosity, irradiance);
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
                        const std::vector<LinkBatch::Interactions> &interactions, const Channels &channels,
                        const Cancel *cancel) {
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
        batches[e] = interactions[e].empty() ? nullptr : std::make_shared<const LinkBatch>(forest, interactions[e], channels);
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
