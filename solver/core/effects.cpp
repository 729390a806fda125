#include "core/effects.h"

#include "core/named.h"

namespace penumbra {

namespace {

struct Naming {
    std::string_view name, unit;
};

constexpr std::array<Naming, n_effects> namings{{{"emission", "pairs"},
                                                 {"two-sided", "pairs"},
                                                 {"hidden-pairs", "links"},
                                                 {"visibility", "clips"},
                                                 {"discontinuities.ve-ev", "traced_pairs"},
                                                 {"discontinuities.eee", "traced_pairs"},
                                                 {"discontinuities.contact", "traced_pairs"},
                                                 {"discontinuities.secondary", "traced_reflectors"},
                                                 {"interreflection", "pairs"},
                                                 {"colour", "products"},
                                                 {"order", "link_coefficients"}}};

} // namespace

std::string_view name(Switch value) {
    return value == Switch::automatic ? "auto" : value == Switch::on ? "on" : "off";
}

std::optional<Switch> switch_from_name(std::string_view text) { return named(all_switches, text); }

std::string_view name(Effect effect) { return namings[static_cast<std::size_t>(effect)].name; }

std::string_view unit(Effect effect) { return namings[static_cast<std::size_t>(effect)].unit; }

std::span<const Effect> effects_from_name(std::string_view text) {
    const std::span<const Effect> all(all_effects);
    if (text == "discontinuities")
        return all.subspan(static_cast<std::size_t>(Effect::curves_ve_ev), 4);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (name(all[i]) == text)
            return all.subspan(i, 1);
    return {};
}

std::string words(const EffectChange &change) {
    return std::string(name(change.effect)) + " " + std::string(name(change.to));
}

std::string text_of(const EffectChange &change) {
    return std::string(name(change.effect)) + "=" + std::string(name(change.to));
}

std::optional<EffectChange> effect_change_from(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
        return std::nullopt;
    const auto effects = effects_from_name(text.substr(0, equals));
    const auto to = switch_from_name(text.substr(equals + 1));
    if (effects.size() != 1 || !to || *to == Switch::automatic)
        return std::nullopt;
    return EffectChange{effects.front(), *to};
}

} // namespace penumbra
