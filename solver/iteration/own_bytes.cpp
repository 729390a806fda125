#include "iteration/own_bytes.h"

#include "iteration/state.h"

#include <algorithm>

namespace penumbra {

namespace {

/// Of an element's outline, sides and basis, beyond its own size.
constexpr std::int64_t beside_element = 400;

} // namespace

std::int64_t own_bytes(const State &state, const State *before) {
    std::vector<LinkBatch::Interactions> interactions;
    std::vector<std::shared_ptr<const LinkBatch>> batches;
    for (std::size_t e = 0; e < state.interactions.size(); ++e) {
        const LinkBatch::Interactions *old = before && e < before->interactions.size() ? &before->interactions[e] : nullptr;
        auto &fresh = interactions.emplace_back();
        for (const auto &interaction : state.interactions[e])
            if (!old || std::ranges::find(*old, interaction) == old->end())
                fresh.push_back(interaction);
    }
    for (std::size_t e = 0; e < state.batches.size(); ++e)
        if (!before || e >= before->batches.size() || before->batches[e] != state.batches[e])
            batches.push_back(state.batches[e]);
    const auto n = static_cast<std::int64_t>(state.forest.elements.size());
    return link_bytes(interactions, batches) + n * (static_cast<std::int64_t>(sizeof(Element)) + beside_element) +
           static_cast<std::int64_t>(sizeof(double)) *
               (state.irradiance.size() + state.radiosity.size() + state.shot.size());
}

} // namespace penumbra
