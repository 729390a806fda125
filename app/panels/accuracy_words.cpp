#include "panels/accuracy_words.h"

#include "core/percent.h"

namespace penumbra {

std::string accuracy_words(const Snapshot &snapshot) {
    if (!snapshot.options.tolerance)
        return {};
    const Counters &c = snapshot.counters;
    const std::string asked = percent(*snapshot.options.tolerance);
    if (c.converged)
        return "The " + asked + " asked for is reached.";
    if (c.exhausted)
        return "The " + asked + " asked for is out of reach: this is the most accurate state.";
    if (c.iteration == 0)
        return "On the way to " + asked + ".";
    if (c.estimated_error >= 0)
        return "Above the " + asked + " asked for: refinement goes on.";
    return "On the way to " + asked + ": the error is measured when nothing fails the threshold in force.";
}

} // namespace penumbra
