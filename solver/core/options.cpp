#include "core/options.h"

#include "core/named.h"

#include <array>

namespace penumbra {

namespace {
struct Naming {
    std::string_view name, title;
};
constexpr std::array<Naming, 4> namings{{{"uniform-constant", "Uniform meshing, constant basis"},
                                         {"discontinuity-constant", "Discontinuity meshing, constant basis"},
                                         {"uniform-wavelet", "Uniform meshing, multiwavelet basis"},
                                         {"discontinuity-wavelet", "Discontinuity meshing, multiwavelet basis"}}};
} // namespace

std::string_view name(Strategy strategy) { return namings[static_cast<std::size_t>(strategy)].name; }

std::string_view name(BasisFamily family) { return family == BasisFamily::planar ? "planar" : "parametric"; }

std::optional<BasisFamily> basis_family_from_name(std::string_view text) {
    for (const BasisFamily f : {BasisFamily::parametric, BasisFamily::planar})
        if (name(f) == text)
            return f;
    return std::nullopt;
}

std::string_view title(Strategy strategy) { return namings[static_cast<std::size_t>(strategy)].title; }

std::string_view name(CutChoice choice) { return choice == CutChoice::curves ? "curves" : "best"; }

std::optional<CutChoice> cut_choice_from_name(std::string_view text) { return named(all_cut_choices, text); }

std::string_view name(GatherOrder order) {
    return order == GatherOrder::jacobi ? "jacobi" : order == GatherOrder::gauss_seidel ? "gauss-seidel" : "southwell";
}

std::optional<GatherOrder> gather_order_from_name(std::string_view text) { return named(all_gather_orders, text); }

std::optional<Strategy> strategy_from_name(std::string_view text) { return named(all_strategies, text); }

} // namespace penumbra
