// An X-rayed link as a plot: what is really brought, the fit, what may be missed, and the oracle's test points.
#pragma once

#include "iteration/link_xray.h"
#include "plot/axes.h"
#include "plot/canvas.h"

#include <optional>

namespace penumbra {

/// Where the plot lies.
struct XrayPlaces {
    PlotBox box; ///< between the axes
    double length = 0;

    /// The place on the line below a point of the page; none beside the plot.
    std::optional<double> place(glm::vec2 at) const;
};

/// Fills `box`: T solid, the fit dashed, the band T +- what passes filled, test points near the line as dots (the worst one
/// of all full), the part of the line inside the picked element marked below. With a cursor a rule stands at that
/// place, and the figures there beside it. Of the channel in which the fit misses most.
XrayPlaces draw_xray_plot(Canvas &canvas, const PlotBox &box, const LinkXray &xray, const PlotLook &look,
                          std::optional<double> cursor = std::nullopt);

} // namespace penumbra
