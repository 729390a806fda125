// A box of a plot with two linear axes.
#pragma once

#include "plot/axes.h"
#include "plot/linear_axis.h"

#include <glm/glm.hpp>

namespace penumbra {

struct LinearPage {
    PlotBox box;
    LinearAxis x, y;

    /// Where the point of these values stands in the picture [pixels].
    glm::vec2 at(double place, double value) const {
        return {box.low.x + static_cast<float>(x.place(place)) * box.width(),
                box.high.y - static_cast<float>(y.place(value)) * box.height()};
    }
};

} // namespace penumbra
