// What a picture without a window is asked to show.
#pragma once

#include "commands/look_options.h"
#include "commands/solving_options.h"
#include "files/saved_state.h"
#include "iteration/after_splits.h"
#include "iteration/snapshot.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct AskedPane {
    Strategy strategy{};
    bool as_quadratics = false; ///< its constants are drawn so
    bool lettered = true;
};

struct RenderOptions {
    std::vector<AskedPane> panes; ///< labelled; empty: the one of --strategy
    bool subtracts = false;     ///< two panes: the second minus the first is drawn
    std::optional<double> wipe; ///< two panes stand in one place, left and right of a divider there; none: side by side
    std::optional<int> steps;    ///< none: to `position`
    std::optional<int> position; ///< of a saved state, see timeline.h; none: to the fixed point
    Phase phase = Phase::pushed_pulled; ///< that the last of `steps` stops after
    std::vector<int> positions; ///< by pane; empty: all stop at the one
    RefinementPart part{};
    bool priced = true;          ///< two panes have a sentence on what they took
    std::optional<bool> price_asked; ///< said on the command line
    LookOptions look;
    /// Where they come from, for messages.
    std::string curve_field = "--curve", keyhole_field = "--keyhole", profile_field = "--profile";
};

/// --layout, --wipe, --panes, --steps, --pane-steps, --phase, --split, --link, --price, and all of add_look_options().
void add_render_options(CLI::App &parser, RenderOptions &options);

/// What the state says, and over it what was said beside it.
void take_over(const SavedState &state, const CLI::App &parser, SolvingOptions &solving, RenderOptions &options);

/// What is given by pane is given for each; else BadInput.
void check_panes(const RenderOptions &options);

} // namespace penumbra
