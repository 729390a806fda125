// One element under the magnifying glass: how it came about, what it holds, and who brings it light.
#pragma once

#include "hierarchy/forest.h"
#include "iteration/link_xray.h"

#include <optional>
#include <string>
#include <vector>

namespace penumbra {

/// An element on the way from the root to the one that was picked.
struct ElementStage {
    int element = 0;
    double depth = 0;
    int born = 0;                      ///< iteration that made it; 0: the start
    SplitKind split = SplitKind::none; ///< how it was split; none: it is the one that was picked
    int n_children = 0;
    int split_in = 0;                  ///< iteration
};

/// What becomes of a link's fit when the oracle judges it next.
enum class LinkVerdict { passes, weak, order_too_low, source_too_coarse, too_bright_for_weak, splits, descends, at_limit };

/// All links from one surface that reach the element: its own, or those of an element above it.
struct LinkReport {
    int receiver = 0;  ///< element that they lead to
    int levels_up = 0; ///< from the one that was picked
    int source = 0;    ///< surface
    int kind = 0;      ///< 0 clear, 1 near or touching, 2 partly hidden
    int n_links = 0, order = 1, full_order = 1; ///< of the fit, and of the receiver's basis
    bool weak = false; ///< a constant, not tested
    Rgb at_centre, mean; ///< what they bring to the picked element, at its centre and over its area, reflected [W/m2]
    double misfit = 0, passes = 0; ///< of the fit, and what may be missed there, in the oracle's norm [W/m2]
    double share = 0;  ///< misfit over passes
    double dark = 0;   ///< it misses most of those that bring a leaf this far below black [W/m2]; 0: it need not fail for that
    double at_most = 0, weak_below = 0; ///< what they can bring or vary by; what is too little to be tested [W/m2]
    LinkVerdict verdict = LinkVerdict::passes;
    std::string words; ///< "passes: misses 0.4 % of the peak < 2 %"
    Vec3 centre;       ///< of the receiver [scene's own frame]
    std::vector<Vec3> outline; ///< of the receiver
    std::vector<Vec3> sources; ///< centres of the linked elements
};

/// What is asked: the leaf of a surface that holds a point, and one of the surfaces that light it.
struct ElementQuestion {
    int surface = 0;
    Vec3 point = Vec3::Zero();                ///< scene's own frame
    std::optional<int> source; ///< whose links are X-rayed
    XrayLine line = XrayLine::centre;

    bool operator==(const ElementQuestion &) const = default;
};

struct ElementReport {
    ElementQuestion question;
    int element = 0, surface = 0;
    std::string surface_name;
    BasisFamily basis = BasisFamily::parametric;
    int order = 1, n_cuts = 0;
    double depth = 0, area = 0;        ///< of the element [scene's length unit, squared]
    bool at_limit = false;
    std::vector<Vec3> outline;         ///< its corners [scene's own frame]
    Eigen::MatrixX3d coefficients;     ///< of the radiosity: functions x channels [W/m2]
    std::vector<ElementStage> history; ///< from the root
    std::vector<LinkReport> links;     ///< who brings most first
    double peak = 0, threshold = 0;    ///< of the state: largest reflected radiosity [W/m2]; in force
    bool mean_square = false;          ///< misfits are root mean squares (a tolerance is asked for)
    std::optional<LinkXray> xray;      ///< of question.source, where it lights the element
};

/// Judged by the state's own radiosity, as the next refinement would. Cancellable. tests/agreement/element_report_test.cpp.
ElementReport element_report(const Setting &setting, const State &state, const ElementQuestion &question,
                             const Cancel *cancel);

/// "floor, element 42: order 4, cut twice, depth 3"
std::string heading(const ElementReport &report);
/// "Iteration 2: element 7, of depth 1, was split in four."
std::vector<std::string> history_words(const ElementReport &report);

} // namespace penumbra
