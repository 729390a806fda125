// What the links from one surface bring to points of their receiver: the polynomial that the oracle judges.
#pragma once

#include "transport/interaction.h"

namespace penumbra {

/// sum over i of N_i(x) (sum over the links of K b)_i, with the functions N_i of the interaction's order: a gather of one
/// interaction [W/m2 of irradiance, before reflection]. Keeps the forest.
class LinkFit {
public:
    LinkFit(const Forest &forest, const Interaction &interaction, const Coefficients &radiosity);

    /// At a point of the receiver's plane.
    Rgb at(const Vec2 &point) const;

private:
    const ElementBasis &basis_;
    int order_;
    Eigen::MatrixX3d coefficients_;
};

} // namespace penumbra
