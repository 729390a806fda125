// Irradiance down the tree, radiosity up.
#pragma once

#include "hierarchy/forest.h"

#include <span>

namespace penumbra {

/// Coefficients of three channels: row = function (Element::first + k), column = channel.
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// An element's rows.
auto rows(const Element &e, auto &coefficients) { return coefficients.middleRows(e.first, e.basis.n_functions()); }

/// Carries irradiance, gathered at whatever level, down to the leaves (6), turns it into radiosity
/// b = e + rho g there, and pulls radiosity up to the roots (7). `radiosity` is resized and overwritten.
void push_pull(const Forest &forest, const Scene &scene, const Coefficients &gathered, Coefficients &radiosity);

/// The same for some elements alone: whole trees, parents before children. Only their rows are read and written. `pushed`,
/// as long as the others, is working memory: the irradiance of all levels above an element and its own.
void push_pull(const Forest &forest, const Scene &scene, std::span<const ElementId> elements, const Coefficients &gathered,
               Coefficients &pushed, Coefficients &radiosity);

/// Mean square of what each element's radiosity leaves out of its leaves' (the detail that pull dropped), largest
/// channel, as a root mean square over the element in its basis' own measure: 0 at leaves. By element.
std::vector<double> dropped_detail(const Forest &forest, const Coefficients &radiosity);

} // namespace penumbra
