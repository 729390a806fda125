// The links of one receiver element as one block of memory that the gather reads from end to end.
#pragma once

#include "core/cancel.h"
#include "effects/plan.h"
#include "transport/interaction.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace penumbra {

/// A copy of the kernels of an element's interactions in arrays, sorted by shape, then by source surface, else in the
/// interactions' order: what a gather needs and no more (of a pair of constants 12 bytes, where the interaction itself takes some
/// hundreds). Immutable.
class LinkBatch {
public:
    using Interactions = std::vector<std::shared_ptr<const Interaction>>;

    /// Of channels that are multiples of others nothing is multiplied: radiosities must be such multiples, too.
    LinkBatch(const Forest &forest, const Interactions &interactions, const Channels &channels = {});

    /// Whether it was made from these very interactions.
    bool made_from(const Interactions &interactions) const { return interactions_ == interactions; }
    std::size_t n_links() const { return sources_.size(); }
    /// Bytes of kernels and source numbers: what one gather reads of it.
    std::size_t bytes() const;

    /// sum over the links of K b: coefficients of the irradiance, added to `irradiance` (functions of the receiver x
    /// channels). Always in the same order.
    void add_irradiance(const Coefficients &radiosity, Eigen::Ref<Coefficients> irradiance) const;
    /// The same of the links from one surface alone. Gives their number.
    std::size_t add_irradiance_from(SurfaceId source, const Coefficients &radiosity,
                                    Eigen::Ref<Coefficients> irradiance) const;

private:
    /// Links one after the other whose kernels have the same shape.
    struct Run {
        int order; ///< of the interactions
        Eigen::Index rows, columns;
        std::size_t n_links, first_link, first_value;
    };
    /// The part of a run that comes from one surface.
    struct Part {
        SurfaceId source;
        Run links;
    };
    void add(const Run &run, const Coefficients &radiosity, Eigen::Ref<Coefficients> irradiance) const;
    template <std::size_t C>
    void add_channels(const Run &run, const Coefficients &radiosity, Eigen::Ref<Coefficients> irradiance) const;

    ElementBasis receiver_;
    Channels channels_;
    std::vector<double> kernels_;       ///< column by column
    std::vector<std::int32_t> sources_; ///< first coefficient of each link's source
    std::vector<Run> runs_;
    std::vector<Part> parts_;
    Interactions interactions_; ///< kept alive, so that no other can take an old one's address
};

/// Batches of all receivers, by element. Those whose interactions are the ones they were made from stay; the others are
/// made anew, in parallel. A receiver without interactions has none. Gives by element whether it was changed.
std::vector<char> renew(std::vector<std::shared_ptr<const LinkBatch>> &batches, const Forest &forest,
                        const std::vector<LinkBatch::Interactions> &interactions, const Channels &channels,
                        const Cancel *cancel);

/// Bytes that all links take: kernels and misfits (interaction.h), and the batches' copies.
std::int64_t link_bytes(const std::vector<LinkBatch::Interactions> &interactions,
                        const std::vector<std::shared_ptr<const LinkBatch>> &batches);

} // namespace penumbra
