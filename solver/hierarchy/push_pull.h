// Irradiance down the tree, radiosity up.
#pragma once

#include "hierarchy/forest.h"

namespace penumbra {

/// Coefficients of three channels: row = function (Element::first + k), column = channel.
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Carries irradiance, gathered at whatever level, down to the leaves (6), turns it into radiosity
/// b = e + rho g there, and pulls radiosity up to the roots (7). `radiosity` is resized and overwritten.
void push_pull(const Forest &forest, const Scene &scene, const Coefficients &gathered, Coefficients &radiosity);

/// Mean square of what each element's radiosity leaves out of its leaves' (the detail that pull dropped), largest
/// channel, as a root mean square over the element in its basis' own measure: 0 at leaves. By element.
std::vector<double> dropped_detail(const Forest &forest, const Coefficients &radiosity);

} // namespace penumbra
