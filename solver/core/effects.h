// What the light of a scene may call for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace penumbra {

/// What is decided from the scene unless somebody decides.
enum class Switch { automatic, on, off };

inline constexpr Switch all_switches[] = {Switch::automatic, Switch::on, Switch::off};

/// `auto`, `on`, `off`; the public names.
std::string_view name(Switch value);
std::optional<Switch> switch_from_name(std::string_view name);

/// Parts of the simulation that not every scene calls for. On: all of its work is done; off: none of it, whatever that
/// leaves out of the picture; automatic: as much as the scene calls for (effects/plan.h).
enum class Effect {
    emission,         ///< any light at all
    two_sided,        ///< sides of surfaces that light may never reach
    hidden_pairs,     ///< pairs of surfaces that something hides from each other altogether
    visibility,       ///< what stands between two that see each other in part
    curves_ve_ev,     ///< discontinuities: of a corner and an edge, and of the planes of sources and blockers
    curves_eee,       ///< of three edges
    curves_contact,   ///< where blockers stand on a receiver
    curves_secondary, ///< all of these from reflectors
    interreflection,  ///< light from surfaces that do not emit
    colour,           ///< channels that differ by more than a factor
    order             ///< polynomials of the order asked for, on every link
};

inline constexpr Effect all_effects[] = {
    Effect::emission,       Effect::two_sided,        Effect::hidden_pairs,    Effect::visibility,
    Effect::curves_ve_ev,   Effect::curves_eee,       Effect::curves_contact,  Effect::curves_secondary,
    Effect::interreflection, Effect::colour,          Effect::order};
inline constexpr std::size_t n_effects = std::size(all_effects);

/// `emission`, `two-sided` and so on, `discontinuities.ve-ev` ...; the public names.
std::string_view name(Effect effect);
/// The effects of a public name: one, or the four of `discontinuities`; empty when there is none.
std::span<const Effect> effects_from_name(std::string_view name);
/// In what its work is counted: "pairs", "clips" ...; fields of the same names in Work and Counters.
std::string_view unit(Effect effect);

/// A value for each effect.
template <typename Value>
class ByEffect {
public:
    Value &operator[](Effect e) { return values_[static_cast<std::size_t>(e)]; }
    const Value &operator[](Effect e) const { return values_[static_cast<std::size_t>(e)]; }
    bool operator==(const ByEffect &) const = default;

private:
    std::array<Value, n_effects> values_{};
};

using EffectSwitches = ByEffect<Switch>;

/// One switch set otherwise, to see what that changes.
struct EffectChange {
    Effect effect{};
    Switch to{}; ///< on or off
    bool operator==(const EffectChange &) const = default;
};

/// "visibility off"; for people.
std::string words(const EffectChange &change);
/// "visibility=off"; the public form.
std::string text_of(const EffectChange &change);
/// None unless it is one effect, on or off.
std::optional<EffectChange> effect_change_from(std::string_view text);

} // namespace penumbra
