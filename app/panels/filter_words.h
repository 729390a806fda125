// What the filter microscope says: of functions, of the maps, and of a split as a whole.
#pragma once

#include "iteration/split_filters.h"

#include <string>

namespace penumbra {

inline constexpr double rounding = 1e-11; ///< entries of a filter below it are 0 to the eye
double largest(const Eigen::MatrixXd &m); ///< of the absolute values

/// "L₂(u) L₁(v)", with primes for a child; of the planar basis "x²y + …", its highest power.
std::string function_words(const SplitFilters &f, int k, bool child);
std::string function_words(BasisFamily basis, int order, int k, bool child = false);

/// How a map is labelled and explained.
struct MapWords {
    const char *name; ///< of the widget
    std::string title;
    const char *rows, *columns; ///< what they stand for: "child's function"
    std::string sentence;       ///< plain
    const char *symbol;
    const char *equation;
};
/// Of the filters to and from a piece.
MapWords push_words(int piece);
MapWords pull_words(int piece);
MapWords difference_words();
MapWords loss_words();

/// "cut in two"
std::string how_split(const SplitFilters &f);
/// In words what the two numbers mean for this very split.
std::string verdict(const SplitFilters &f);

} // namespace penumbra
