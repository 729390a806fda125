// What a solution is asked for, in scale-free units.
#pragma once

#include "core/effects.h"

#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

/// The paper's four strategies, (a) to (d) of its section 5.
enum class Strategy { uniform_constant, discontinuity_constant, uniform_wavelet, discontinuity_wavelet };

inline constexpr Strategy all_strategies[] = {Strategy::uniform_constant, Strategy::discontinuity_constant,
                                              Strategy::uniform_wavelet, Strategy::discontinuity_wavelet};

/// `uniform-constant` and so on; the public names.
std::string_view name(Strategy strategy);
std::optional<Strategy> strategy_from_name(std::string_view name);
/// In words, for labels: "Uniform meshing, constant basis".
std::string_view title(Strategy strategy);

constexpr bool cuts_along_curves(Strategy s) {
    return s == Strategy::discontinuity_constant || s == Strategy::discontinuity_wavelet;
}
constexpr bool is_constant(Strategy s) {
    return s == Strategy::uniform_constant || s == Strategy::discontinuity_constant;
}

/// The paper's products of Legendre polynomials of a quad's parameters, or polynomials of the plane on convex polygons.
enum class BasisFamily { parametric, planar };
std::string_view name(BasisFamily family);
std::optional<BasisFamily> basis_family_from_name(std::string_view name);

/// Where strategies that cut may cut: along discontinuity curves alone, or where no curve is worth it along the straight
/// line that lowers the error most, too (the paper's outlook, section 6; Campbell & Fussell 1990).
enum class CutChoice { curves, best };

inline constexpr CutChoice all_cut_choices[] = {CutChoice::curves, CutChoice::best};

/// `curves`, `best`; the public names.
std::string_view name(CutChoice choice);
std::optional<CutChoice> cut_choice_from_name(std::string_view name);

/// In which order a gather uses what it has found (iteration/relaxation.h).
enum class GatherOrder { jacobi, gauss_seidel, southwell };

inline constexpr GatherOrder all_gather_orders[] = {GatherOrder::jacobi, GatherOrder::gauss_seidel,
                                                    GatherOrder::southwell};

/// `jacobi`, `gauss-seidel`, `southwell`; the public names.
std::string_view name(GatherOrder order);
std::optional<GatherOrder> gather_order_from_name(std::string_view name);

/// At which the paper's figures come out: about its counts of patches for all four strategies, and its three for (d).
inline constexpr double paper_threshold = 0.03;

inline constexpr int deepest = 20; ///< of --max-depth

struct Options {
    Strategy strategy = Strategy::discontinuity_wavelet;
    BasisFamily basis = BasisFamily::parametric;
    /// Polynomials of degree < order in each parameter (planar: of total degree < order), 1 to 4; the two constant
    /// strategies, and links whose effect `order` is off, take 1 whatever stands here.
    int order = 4;
    /// Largest misfit that the oracle lets pass, as a fraction of the largest reflected radiosity B - E.
    double threshold = 0.02;
    /// Relative L2 error of B - E asked for, over the reflecting surfaces and all channels. Where given the solver finds its
    /// own thresholds (iteration/tolerance_control.h), and `threshold` is not looked at. 0: as little as can be had; it goes
    /// on until it is stopped.
    std::optional<double> tolerance;
    /// Halvings of both directions below a surface's convex part; the paper's experiment allows 6.
    int max_depth = 6;
    int max_iterations = 100;
    CutChoice cut = CutChoice::curves;
    /// A curve is cut along if that lowers the fit's root mean square error on the node, taken as the root of what the
    /// squares lose, by more than this share of the misfit that the oracle lets pass. 0: every curve is a candidate.
    double least_gain = 0.07;
    EffectSwitches effects;
    /// Each step goes on with a constant on each surface, solved for directly (iteration/coarse_correction.h).
    Switch coarse_correction = Switch::automatic;
    GatherOrder gather = GatherOrder::jacobi;
    /// 0: all cores.
    int threads = 0;

    /// The same, asked for an accuracy: no depth limit but the one that halving keeps apart from rounding.
    Options to_tolerance(double value) const {
        Options out = *this;
        out.tolerance = value;
        out.max_depth = deepest;
        return out;
    }
    /// The same, asked by the oracle's threshold; where an accuracy was asked for before, with the paper's depth limit again.
    Options to_threshold(double value) const {
        Options out = *this;
        out.threshold = value;
        if (tolerance)
            out.max_depth = Options().max_depth;
        out.tolerance.reset();
        return out;
    }

    bool operator==(const Options &) const = default;

    int effective_order() const { return is_constant(strategy) || effects[Effect::order] == Switch::off ? 1 : order; }
};

} // namespace penumbra
