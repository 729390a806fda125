#include "iteration/linking_words.h"

#include "core/percent.h"
#include "iteration/take_snapshot.h"

#include <array>

namespace penumbra {

namespace {

std::string words(LinkReason reason) {
    switch (reason) {
    case LinkReason::new_pair:
        return "the first time";
    case LinkReason::handed_down:
        return "links of an element above it failed";
    case LinkReason::order_too_low:
        return "the order had become too low";
    case LinkReason::too_bright:
        return "it had become too bright for a constant";
    case LinkReason::source_too_coarse:
        return "finer parts of the source had come to matter";
    case LinkReason::limit:
        return "it is kept at the depth limit, and fitted as well as can be";
    }
    return {};
}

} // namespace

std::string linking_words(const Scene &scene, const Forest &forest, const LinkEvent &event) {
    const Interaction &made = *event.made;
    const Element &receiver = forest[made.receiver];
    const std::string pair = scene.words_for(receiver.surface) + ", element " + std::to_string(made.receiver.index) + ": ";
    const std::string source = scene.words_for(made.source);
    if (made.links.empty())
        return pair + "nothing of " + source + " reaches it any more; the link to it is gone";
    double form_factor = 0;
    for (const Link &link : made.links)
        form_factor += link.kernel(0, 0);
    static constexpr std::array kinds{"all of it seen", "near it", "partly hidden"};
    return pair + "linked to " + (made.links.size() == 1 ? "" : std::to_string(made.links.size()) + " elements of ") + source + ", " +
           kinds[static_cast<std::size_t>(link_kind(made.kind))] + ", form factor " + percent(form_factor) +
           (made.weak ? ", as a constant, being weak" : ", order " + std::to_string(made.order) + " of " +
                                                            std::to_string(receiver.basis.order())) +
           "; " + words(event.reason);
}

} // namespace penumbra
