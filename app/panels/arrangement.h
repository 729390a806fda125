// Where everything stands in the window.
#pragma once

#include "app_state.h"

#include <functional>
#include <vector>

namespace penumbra {

struct Arrangement {
    WindowRect tool_bar, side, inspector, transport, status; ///< empty when panels are hidden
    WindowRect panes;               ///< all of them, with the legend strip below
    WindowRect profile;             ///< plot below the panes; empty unless it is open
    WindowRect legend;              ///< strip that explains line kinds; empty when hidden
    std::vector<WindowRect> pane;   ///< from the upper left, row by row; those that share a place have the same
    std::vector<WindowRect> part;   ///< of each pane, that is seen; of no width: nothing
    std::vector<WindowRect> place;  ///< the panes' without repetition
};

/// Of a window in which the course of the solution has a line of its own.
bool is_narrow(float width, float em);

/// `width`, `height`: of the window [screen coordinates]; `top`: height of the menu bar; `em`: of the text;
/// `legend_height`: what the legend of lines needs in a strip of the width that it is given.
Arrangement arrange(const AppState &state, float width, float height, float top, float em,
                    const std::function<float(float)> &legend_height);

} // namespace penumbra
