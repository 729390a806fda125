// Looking at one element: what it holds, how it came about, and who lights it.
#pragma once

#include "app_state.h"
#include "solve_worker.h"

#include <optional>

namespace penumbra {

/// Looks at the element that holds the point, in the active pane's solution. The surface whose links are X-rayed stays.
void pick_element(AppState &state, const SurfacePoint &at);
/// Draws the links from this surface and X-rays them; lets go of them when they are.
void pick_source(AppState &state, int source);
void set_xray_line(AppState &state, XrayLine line);
/// What the worker is asked, while the inspector is open and an element was picked.
std::optional<Inspection> inspection(const AppState &state);
/// Whether the answer is still to come.
bool awaits_report(const AppState &state);
/// The report, where it is about what the active pane shows.
const ElementReport *shown_report(const AppState &state);
/// Of the surface that was picked; null: none was, or it does not light the element.
const LinkReport *picked_links(const AppState &state);

} // namespace penumbra
