#include "effect_verbs.h"

#include "truth_verbs.h"
#include "verbs.h"

namespace penumbra {

namespace {

void use(AppState &state, const EffectSwitches &effects, const std::string &sentence) {
    Options options = state.options;
    options.effects = effects;
    start_again(state, options);
    state.message = {sentence, false};
}

} // namespace

std::span<const LedgerEntry> effects_ledger(const AppState &state) {
    const auto snapshot = state.active_solution();
    return snapshot ? std::span(snapshot->effects) : std::span<const LedgerEntry>();
}

void set_effect(AppState &state, Effect effect, Switch value) {
    if (state.options.effects[effect] == value)
        return;
    EffectSwitches effects = state.options.effects;
    effects[effect] = value;
    use(state, effects,
        value == Switch::automatic ? "Whether " + std::string(name(effect)) + " is simulated is left to the scene; starting anew."
                                   : "Starting anew with " + words({effect, value}) + ".");
}

void decide_by_scene(AppState &state) { use(state, {}, "What is simulated is left to the scene; starting anew."); }

bool all_by_scene(const AppState &state) { return state.options.effects == EffectSwitches(); }

EffectChange opposite(const LedgerEntry &entry) {
    return {entry.effect, entry.decision == Decision::off ? Switch::on : Switch::off};
}

void show_change(AppState &state, const EffectChange &change) {
    if (state.look.shading == Shading::error && state.look.change == change) {
        state.look.change.reset();
        state.look.shading = Shading::polynomial;
        state.message = {"The light again.", false};
        return;
    }
    state.look.change = change;
    state.truth.range_locked = false;
    show_errors(state, ErrorKind::signed_error);
    if (!at_end(state)) {
        state.playing = false;
        go_to(state, far_ahead);
    }
    state.message = {"This solution minus the one with " + words(change) + ": brown where this one is brighter, blue where it is darker.",
                     false};
}

} // namespace penumbra
