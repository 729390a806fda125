#include "effects/ledger.h"

#include "core/percent.h"

#include <fmt/format.h>

#include <algorithm>

namespace penumbra {

namespace {

std::string plural(std::int64_t n, const char *one, const char *many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

class Judge {
public:
    Judge(const Scene &scene, const Options &options, const Plan &plan, const Counters &counters)
        : scene_(scene), options_(options), plan_(plan), counters_(counters), work_(counters.total_work) {}

    LedgerEntry entry(Effect effect) const {
        LedgerEntry out{effect, Decision::on, "", spared(effect), done(effect)};
        const Switch asked = options_.effects[effect];
        if (asked != Switch::automatic) {
            out.decision = asked == Switch::on ? Decision::on : Decision::off;
            out.reason = fmt::format("asked for: {}", name(asked));
            return out;
        }
        decide(out);
        return out;
    }

private:
    std::int64_t spared(Effect effect) const {
        return effect == Effect::order ? counters_.spared_link_coefficients : work_.spared[effect];
    }

    std::int64_t done(Effect effect) const {
        switch (effect) {
        case Effect::emission:
        case Effect::two_sided:
        case Effect::interreflection: return work_.pairs;
        case Effect::hidden_pairs: return counters_.links;
        case Effect::visibility: return work_.clips;
        case Effect::curves_ve_ev:
        case Effect::curves_eee:
        case Effect::curves_contact: return work_.traced_pairs;
        case Effect::curves_secondary: return work_.traced_reflectors;
        case Effect::colour: return work_.products;
        case Effect::order: return counters_.link_coefficients;
        }
        return 0;
    }

    std::string share(const LedgerEntry &e) const {
        const double all = static_cast<double>(e.saved + e.done);
        return percent(all > 0 ? static_cast<double>(e.saved) / all : 0);
    }

    void decide(LedgerEntry &out) const {
        switch (out.effect) {
        case Effect::emission: return emission(out);
        case Effect::two_sided: return two_sided(out);
        case Effect::hidden_pairs: return hidden_pairs(out);
        case Effect::visibility: return visibility(out);
        case Effect::curves_ve_ev:
        case Effect::curves_eee:
        case Effect::curves_contact: return curves(out);
        case Effect::curves_secondary: return secondary(out);
        case Effect::interreflection: return interreflection(out);
        case Effect::colour: return colour(out);
        case Effect::order: return order(out);
        }
    }

    template <typename Counts>
    int count(Counts counts) const {
        int n = 0;
        for (int s = 0; s < scene_.n_surfaces(); ++s)
            n += counts(SurfaceId(s));
        return n;
    }

    void off(LedgerEntry &out, std::string reason) const {
        out.decision = Decision::off;
        out.reason = std::move(reason);
    }

    void emission(LedgerEntry &out) const {
        const int n = count([&](SurfaceId s) { return scene_.emits(s); });
        if (n == 0)
            return off(out, "no surface emits: there is nothing to simulate");
        out.reason = plural(n, "surface emits", "surfaces emit");
    }

    void two_sided(LedgerEntry &out) const {
        const int n = count([&](SurfaceId s) { return scene_.reflects(s); });
        const int lit = count([&](SurfaceId s) { return scene_.reflects(s) && plan_.is_lit(s); });
        const int backs = count([&](SurfaceId s) { return scene_.reflects(s) && plan_.is_second_side(s); });
        if (!plan_.emission)
            return off(out, "no light reaches any side");
        if (lit < n) {
            out.decision = Decision::partial;
            out.reason = fmt::format("{} of {} sides that reflect look away from all that shines", n - lit, n);
        } else if (backs == 0) {
            off(out, fmt::format("no face reflects on a second side, and light can come to all {} that reflect", n));
        } else {
            out.reason = fmt::format("light can come to all {} sides, {} of them backs", n, backs);
        }
    }

    void hidden_pairs(LedgerEntry &out) const {
        if (out.saved == 0)
            return off(out, "no two surfaces that face each other are wholly hidden from each other");
        out.decision = Decision::partial;
        out.reason = fmt::format("one blocker hides all: {} not made, {} of all", plural(out.saved, "link", "links"), share(out));
    }

    void visibility(LedgerEntry &out) const {
        if (!plan_.anything_blocks())
            return off(out, "no surface stands between others: the scene lies on one side of each");
        if (!plan_.emission || (out.done == 0 && counters_.iteration > 0))
            return off(out, "nothing stands in the shafts between surfaces that exchange light");
        const auto n_blocking = count([&](SurfaceId s) { return plan_.can_block.empty() || plan_.can_block[s.at()]; });
        out.decision = out.saved > 0 ? Decision::partial : Decision::on;
        out.reason = fmt::format("{} of {} surfaces can stand between others; empty shafts spared {} of the clips", n_blocking,
                                 scene_.n_surfaces(), share(out));
    }

    void curves(LedgerEntry &out) const {
        const char *what = out.effect == Effect::curves_ve_ev ? "an edge and a corner can throw"
                           : out.effect == Effect::curves_eee ? "three edges of two blockers can throw"
                                                              : "blockers that touch a receiver can throw";
        const std::int64_t n = plan_.emission ? emitter_pairs() - out.saved : 0;
        if (n == 0)
            return off(out, fmt::format("no emitter and receiver have curves that {}", what));
        out.decision = out.saved > 0 ? Decision::partial : Decision::on;
        out.reason = fmt::format("{} of {} pairs of an emitter and a receiver may have curves that {}", n, emitter_pairs(), what);
        out.done = n;
    }

    std::int64_t emitter_pairs() const {
        std::int64_t n = 0;
        for (int r = 0; r < scene_.n_surfaces(); ++r)
            for (int s = 0; s < scene_.n_surfaces(); ++s)
                n += r != s && scene_.reflects(SurfaceId(r)) && scene_.emits(SurfaceId(s));
        return n;
    }

    void secondary(LedgerEntry &out) const {
        if (!cuts_along_curves(options_.strategy))
            return off(out, "uniform meshing does not cut");
        if (!plan_.interreflection)
            return off(out, "no light is reflected twice");
        if (out.done == 0)
            return off(out, "no fit has failed because of a reflector's light yet");
        out.decision = Decision::partial;
        out.reason = fmt::format("fits failed because of the light between {}", plural(out.done, "reflector and its receiver", "reflectors and their receivers"));
    }

    void interreflection(LedgerEntry &out) const {
        if (!plan_.emission)
            return off(out, "there is no light to reflect");
        if (!plan_.interreflection)
            return off(out, has_one_bounce(scene_)
                                ? "what light reaches can send none to another surface that reflects: one bounce is all"
                                : "all that is reflected twice and more stays below a twentieth of what is asked for");
        out.reason = fmt::format("light that one surface reflects can reach others; after {} bounces what is left weighs "
                                 "less than a twentieth of what is asked for", plan_.bounces);
    }

    void colour(LedgerEntry &out) const {
        if (!plan_.emission)
            return off(out, "there is no light to have one");
        const int n = plan_.channels.n_solved();
        if (n == 3) {
            out.reason = "the three channels differ by more than a factor";
            return;
        }
        out.decision = n == 1 ? Decision::off : Decision::partial;
        out.reason = fmt::format("{} solved: the others are multiples, or dark", plural(n, "channel is", "channels are"));
    }

    void order(LedgerEntry &out) const {
        if (!plan_.emission)
            return off(out, "there is no light to fit");
        if (counters_.links > 0 && counters_.link_coefficients == counters_.links && options_.effective_order() > 1)
            return off(out, fmt::format("constants do for all {}", plural(counters_.links, "link", "links")));
        out.decision = out.saved > 0 ? Decision::partial : Decision::on;
        out.reason = out.saved > 0
                         ? fmt::format("lower orders do for {} of {} links: {} of the coefficients spared",
                                       counters_.lower_links, counters_.links, share(out))
                         : fmt::format("every link calls for order {}", options_.effective_order());
    }

    const Scene &scene_;
    const Options &options_;
    const Plan &plan_;
    const Counters &counters_;
    const Work &work_;
};

} // namespace

std::string_view name(Decision decision) {
    return decision == Decision::on ? "on" : decision == Decision::off ? "off" : "partial";
}

std::vector<LedgerEntry> ledger(const Scene &scene, const Options &options, const Plan &plan, const Counters &counters) {
    const Judge judge(scene, options, plan, counters);
    std::vector<LedgerEntry> out;
    for (const Effect effect : all_effects)
        out.push_back(judge.entry(effect));
    return out;
}

} // namespace penumbra
