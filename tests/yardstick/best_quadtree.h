// The best that uniform meshing can do: patches against error, with no oracle and no transport in the way.
#pragma once

#include "yardstick/exact_light.h"

#include <vector>

namespace penumbra::yardstick {

/// A quadtree's size and its relative L2 error, as relative_error() has it.
struct Standing {
    int patches = 0;
    double error = 0;
};

/// From one patch on, the best L2 fits by polynomials of degree < order in each parameter on the leaves of the quadtree
/// over the (square) surface, always splitting the leaf with the largest squared error, until the error is at most
/// `target`. `n` Gauss points a parameter on every piece of a leaf (ExactLight::samples).
std::vector<Standing> best_quadtree(const ExactLight &exact, const BilinearQuad &root, int order, double target,
                                    int n = 6);

/// Patches of the first standing whose error is at most this; 0 when there is none.
int patches_for(const std::vector<Standing> &standings, double error);

} // namespace penumbra::yardstick
