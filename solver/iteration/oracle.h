// Whether links bring their light well enough, and what becomes of those that do not.
#pragma once

#include "iteration/allowance.h"
#include "iteration/below_black.h"

#include <vector>

namespace penumbra {

enum class Verdict {
    keep,   ///< it stays as it is
    relink, ///< links anew between the same element and surface
    fail    ///< the element's functions do not fit what is brought: it is split, or kept at a limit
};

struct Judgement {
    Verdict verdict = Verdict::keep;
    std::vector<ElementId> sources; ///< of the new links, unless kept
    double misfit = 0;              ///< over what passes at the element (Allowance); 0 where nothing was tested
    bool weak = false;              ///< it brings, or varies by, too little to be tested
    bool afresh = false;            ///< its orders have become too low: nothing of the links is taken over
    double dark = 0;     ///< it is one of those that bring a leaf this far below black [W/m2]; else 0
    double damping = 1;  ///< of the detail that it brings, with which the leaf would not be, did the others bring none
};

/// After Gortler et al. (1993), of what one surface brings to an element (DESIGN section 3), judged by the state's present
/// radiosity. Keeps both arguments; elements and interactions may be added to the state meanwhile.
class Oracle {
public:
    Oracle(const Setting &setting, const State &state);

    /// Of all interactions, as they stand in the state. Light is not negative: a leaf that is by more than passes shows that
    /// fits, each of which may have passed, miss too much together. Those fail that bring the most below black where it is
    /// darkest, until what the others bring passes; of those that have no detail left the sources are split.
    std::vector<std::vector<Judgement>> judge_all() const;
    /// What links from that surface may leave out.
    Leeway leeway(ElementId receiver, SurfaceId source) const;
    const Allowance &allowance() const { return allowance_; }
    /// Largest radiosity of its leaves, at corners and in the mean [W/m2].
    const Rgb &brightness(SurfaceId s) const { return brightness_[s.at()]; }
    /// The most that an interaction can bring, or that constants can miss of it, reflected [W/m2], and where it is weak.
    double most_brought(const Interaction &interaction) const;
    double weak_below() const;

private:
    Judgement judge(const Interaction &interaction) const;
    void judge_what_is_below_black(std::vector<std::vector<Judgement>> &judgements) const;
    void split_sources(const Interaction &interaction, Judgement &judgement) const;
    void fail_darkest(ElementId leaf, const Darkness &dark, double aim, std::vector<std::vector<Judgement>> &judgements) const;
    Rgb largest_radiosity(SurfaceId s) const;
    double slack(ElementId receiver, SurfaceId source) const;

    const Setting &setting_;
    const State &state_;
    const Scene &scene_;
    Allowance allowance_;
    std::vector<double> detail_;  ///< by element: dropped_detail
    std::vector<Rgb> brightness_; ///< by surface
};

} // namespace penumbra
