#include "paper_lines.h"

#include <algorithm>
#include <iterator>

namespace penumbra {

namespace {

constexpr const char *system = "b\u209a = e\u209a + \u03a3 K(q\u2192p) b over all q";
constexpr const char *expansion = "B(u,v) \u2248 \u03a3 b\u2098 N\u2098(u,v), m = 1 \u2026 M\u00d7M";
constexpr const char *push =
    "b\u207d\u00b9\u207e\u2098 = \u03a3\u2099 c\u207d\u2070\u2192\u00b9\u207e\u2098\u2099 b\u207d\u2070\u207e\u2099";
constexpr const char *kernel = "\u03ba(x,y) = \u03c1 cos \u03b8x cos \u03b8y V(x,y) / (\u03c0 r\u00b2)";
constexpr const char *light = "B(x) = E(x) + \u03a3 \u222b \u03ba(x,y) B(y) dy over all surfaces";
constexpr const char *corner_and_edge =
    "x in the plane of a corner v and an edge ab: det(a \u2212 v, b \u2212 v, x \u2212 v) = 0";
constexpr const char *heckbert = "Heckbert 1992; Lischinski et al. 1992";

constexpr PaperLine lines[] = {
    {"solve.play", system, "equation (3)"},
    {"solve.step", system, "equation (3)"},
    {"solve.sub_step", "refine the mesh, or gather, or push and pull", "section 3, equations (3), (6) and (7)"},
    {"solve.end", system, "equation (3)"},

    {"strategy.a", "quad-tree, M = 1", "section 5, figure 5"},
    {"strategy.b", "cuts, M = 1", "section 5, figure 6"},
    {"strategy.c", "quad-tree, M = 4", "section 5, figure 7"},
    {"strategy.d", "cuts, M = 4", "section 5, figure 8"},
    {"strategy.meshing", "\u03a9\u2080 = \u03a9\u2081 \u222a \u03a9\u2082", "section 3, figure 2"},
    {"strategy.basis", expansion, "equation (4)"},
    {"strategy.reconstructed", "quadratics through values of B at nodes of each patch", "Lischinski et al. 1993", true},
    {"meshing.uniform", "dilation by 2: A(u\u2032,v\u2032) = 1/4", "below equation (7)"},
    {"meshing.discontinuity", "\u03a9\u2080 = \u03a9\u2081 \u222a \u03a9\u2082", "section 3, figure 2"},
    {"basis.constant", "B(u,v) \u2248 b\u2081, M = 1", "equation (4)"},
    {"basis.multiwavelet", expansion, "equation (4)"},

    {"view.four", "(a), (b), (c), (d)", "section 5, figures 5 to 8"},
    {"view.keyhole", "V(x,y) for all y of each light", "equation (2)"},
    {"view.profile", light, "equation (1)"},
    {"view.filters", push, "equations (6) and (7)"},
    {"view.cost", "M = 4: up to 16 times the effort for each patch", "section 5"},
    {"layers.mesh", "\u03a9\u2080, \u03a9\u2081, \u03a9\u2082 \u2026", "section 3, figure 2"},
    {"layers.curves", "B or a derivative of it jumps", "section 1, figure 1"},
    {"layers.links", "K(q\u2192p)", "equation (3)"},
    {"layers.polynomial", expansion, "equation (4)"},
    {"layers.flat", "the mean of B(u,v) over a patch: b\u2081", "equation (4)"},
    {"layers.false_colour", light, "equation (1)"},
    {"layers.error", "\u03a3 b\u2098 N\u2098 \u2212 B", "B of equation (1)"},
    {"error.signed", "\u03a3 b\u2098 N\u2098 \u2212 B", "B of equation (1)"},
    {"error.relative", "|\u03a3 b\u2098 N\u2098 \u2212 B| / max (B \u2212 E)", "B and E of equation (1)"},
    {"error.patch", "\u2016\u03a3 b\u2098 N\u2098 \u2212 B\u2016 of the patch / \u2016B \u2212 E\u2016", "B and E of equation (1)"},
    {"error.estimate", "true error / misfit that the oracle saw", "section 5, on the oracle"},

    {"kind VE", corner_and_edge, heckbert, true},
    {"kind EV", corner_and_edge, heckbert, true},
    {"kind EEE", "x on a line that meets three edges: a quadric", "Heckbert 1992; Drettakis & Fiume 1994", true},
    {"kind plane", "x in the plane of the polygon: n \u00b7 (x \u2212 v) = 0", heckbert, true},
    {"kind contact", "V(x,y) itself jumps", heckbert, true},
    {"curve order 0", "D\u2070: the irradiance itself jumps", heckbert, true},
    {"curve order 1", "D\u00b9: the first derivative jumps", heckbert, true},
    {"curve order 2", "D\u00b2: the second derivative jumps", heckbert, true},

    {"threshold", "misfit of a polynomial to the kernel, integrated over the source", "section 5, on the oracle"},
    {"depth", "levels of the quad-tree", "section 5"},
    {"tolerance", "\u2016\u03a3 b\u2098 N\u2098 \u2212 B\u2016 / \u2016B \u2212 E\u2016", "B and E of equation (1)"},
    {"order 1", "M = 1", "equation (4)"},
    {"order 2", "M = 2", "equation (4)"},
    {"order 3", "M = 3", "equation (4)"},
    {"order 4", "M = 4", "equation (4)"},
    {"basis parametric", "N\u2098(u,v) on the unit square", "sections 3 and 4"},

    {"figure patches", "1776, 1019, 262 and 3 patches by (a) to (d)", "section 5"},
    {"figure coefficients", "\u03a3 n\u209a over all patches p", "equation (3)"},
    {"figure links", "K(q\u2192p)", "equation (3)"},
    {"figure links \u00d7 coefficients", "\u03a3 n\u209a n(q) over all K(q\u2192p)", "equation (3)"},
    {"figure splits, of these cuts", "\u03a9\u2080 = \u03a9\u2081 \u222a \u03a9\u2082 \u2026", "section 3, figure 2"},
    {"figure kernel evaluations", kernel, "equation (2)"},
    {"figure clips", "V(x,y)", "equation (2)"},
    {"figure at the depth limit", "levels of the quad-tree", "section 5"},
    {"figure change", "b\u209a of this step \u2212 b\u209a of the step before", "equation (3)"},
    {"figure error", "\u2016\u03a3 b\u2098 N\u2098 \u2212 B\u2016 / \u2016B \u2212 E\u2016", "B and E of equation (1)"},
    {"figure radiosity", light, "equation (1)"},
    {"figure reflectance", "\u03c1(x)", "equation (2)"},

    {"cost patches", "\u03a9\u2080, \u03a9\u2081, \u03a9\u2082 \u2026", "section 3, figure 2"},
    {"cost coefficients", "\u03a3 n\u209a over all patches p", "equation (3)"},
    {"cost link_coefficients", "\u03a3 n\u209a n(q) over all K(q\u2192p)", "equation (3)"},
    {"cost kernel_evaluations", kernel, "equation (2)"},

    {"effect emission", "E(x)", "equation (1)"},
    {"effect visibility", "V(x,y)", "equation (2)"},
    {"effect discontinuities.ve-ev", corner_and_edge, heckbert, true},
    {"effect interreflection", light, "equation (1)"},
    {"effect order", "M", "equation (4)"},

    {"microscope.piece 1", push, "equation (6)"},
    {"microscope.piece 2", push, "equation (6)"},
    {"microscope.piece 3", push, "equation (6)"},
    {"microscope.piece 4", push, "equation (6)"},
    {"share of the child", "A(u\u2032,v\u2032)", "equation (7)"},
};

} // namespace

std::span<const PaperLine> paper_lines() { return lines; }

std::string paper_line(std::string_view name) {
    const auto found = std::ranges::find(lines, name, &PaperLine::name);
    if (found == std::end(lines))
        return {};
    return std::string(found->symbol) + "   (" + (found->of_others ? "" : "Bouatouch & Pattanaik 1995, ") +
           std::string(found->place) + ")";
}

} // namespace penumbra
