#include "panels/filter_words.h"

#include "panels/words.h"

#include <algorithm>

namespace penumbra {

namespace {

std::string small_number(int n, bool below) {
    static constexpr const char *raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    static constexpr const char *lowered[] = {"\u2080", "\u2081", "\u2082", "\u2083", "\u2084",
                                              "\u2085", "\u2086", "\u2087", "\u2088", "\u2089"};
    std::string text;
    for (const char digit : std::to_string(n))
        text += (below ? lowered : raised)[digit - '0'];
    return text;
}

std::string child(int piece) { return "child " + std::to_string(piece + 1); }

} // namespace

double largest(const Eigen::MatrixXd &m) { return m.cwiseAbs().maxCoeff(); }

std::string function_words(const SplitFilters &f, int k, bool child) {
    return function_words(f.basis, f.order, k, child);
}

std::string function_words(BasisFamily basis, int order, int k, bool child) {
    const auto [i, j] = function_degrees(basis, order, k);
    if (basis == BasisFamily::parametric) {
        const char *prime = child ? "\u2032" : "";
        return "L" + small_number(i, true) + "(u" + prime + ") L" + small_number(j, true) + "(v" + prime + ")";
    }
    const auto power = [](const char *x, int n) {
        return n == 0 ? std::string() : n == 1 ? std::string(x) : x + small_number(n, false);
    };
    return i + j == 0 ? "1" : power("x", i) + power("y", j) + " + \u2026";
}

MapWords push_words(int piece) {
    return {"push",
            "Push to " + child(piece),
            "child's function",
            "parent's function",
            "Gives the child's coefficients from its parent's: light that was gathered above is carried down.",
            "b\u207d\u00b9\u207e\u2098 = \u03a3\u2099 c\u207d\u2070\u2192\u00b9\u207e\u2098\u2099 "
            "b\u207d\u2070\u207e\u2099",
            "Bouatouch & Pattanaik 1995, equation (6)"};
}

MapWords pull_words(int piece) {
    return {"pull",
            "Pull from " + child(piece),
            "parent's function",
            "child's function",
            "Gives what the child adds to its parent's coefficients: the light of the pieces is summed up.",
            "b\u207d\u2070\u207e\u2098 = \u03a3\u2099 c\u207d\u00b9\u2192\u2070\u207e\u2098\u2099 "
            "b\u207d\u00b9\u207e\u2099 + \u2026",
            "Bouatouch & Pattanaik 1995, equation (7)"};
}

MapWords difference_words() {
    return {"difference",
            "pull \u2212 C\u00b7push\u1d40",
            "parent's function",
            "child's function",
            "What pull has beyond push transposed and multiplied by C. Zero: one filter gives the other.",
            "c\u207d\u00b9\u2192\u2070\u207e\u2098\u2099 \u2212 C c\u207d\u2070\u2192\u00b9\u207e\u2099\u2098",
            "Bouatouch & Pattanaik 1995, below equation (7)"};
}

MapWords loss_words() {
    return {"loss",
            "\u03a3 pull\u00b7push \u2212 I",
            "parent's function",
            "parent's function",
            "What a trip down to all children and up again changes. Zero: nothing is lost.",
            "\u03a3 pull push \u2212 I, over all children",
            "Bouatouch & Pattanaik 1995, equations (6) and (7)"};
}

std::string how_split(const SplitFilters &f) {
    if (f.kind == SplitKind::cut)
        return "cut in two";
    return f.pieces.size() == 4 ? "split in four" : "halved";
}

std::string verdict(const SplitFilters &f) {
    const bool related = std::ranges::all_of(f.pieces, [](const auto &p) { return largest(p.difference) < rounding; });
    const bool lossless = largest(f.loss) < rounding;
    if (related && lossless)
        return f.basis == BasisFamily::planar
                   ? "Pull is push transposed, times C, and a trip down and up loses nothing: in this basis for every "
                     "cut."
                   : "Here A(u\u2032,v\u2032) is constant: pull is push transposed, times C, and nothing is lost.";
    return "A(u\u2032,v\u2032) varies over a slanted cut: pull is not push transposed, and a trip down and up changes "
           "some functions, here by up to " +
           power_words(largest(f.loss), 2) + ".";
}

} // namespace penumbra
