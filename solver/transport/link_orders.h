// The oracle of a link's orders: as many functions, on either side, as what is brought calls for.
#pragma once

#include "transport/interaction.h"
#include "transport/point_transfer.h"

#include <span>
#include <vector>

namespace penumbra {

using ChannelValues = Eigen::Matrix<double, Eigen::Dynamic, 3>; ///< points x channels

/// The size of misfits as `leeway` takes it, reflected [W/m2].
double size_of(const ChannelValues &misfits, const Leeway &leeway);

/// The lowest order, up to p's, of which a fit to these values of T_S at points of p by least squares misses no more than
/// the leeway. Points must be more than functions of the orders below p's; else p's own.
int sufficient_order(const ElementBasis &p, std::span<const Vec2> points, const ChannelValues &values,
                     const Leeway &leeway);

/// By node: the largest |T_j| (j > 0) over the rows of `transfers` (points x columns of all nodes), where the node's columns
/// but the first can be left out: those of nodes whose sum_j |T_j| |b_j| is least, while their sum stays within the leeway.
/// Empty for the others, for nodes of one column, and for those that the receiver comes nearer than their width, where this is
/// less than its own radius: there they bring far more than points spread over it see. `size`: that radius; `distance`: of the
/// receiver and the source's surface.
std::vector<Eigen::VectorXd> columns_to_leave_out(std::span<const SourceNode> nodes, const Eigen::MatrixXd &transfers, double size, double distance,
                                                  const Leeway &leeway);

} // namespace penumbra
