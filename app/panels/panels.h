// The panels of the window, one a file. Each draws itself into its place with ImGui and changes the state by actions.
#pragma once

#include "app_state.h"
#include "panels/arrangement.h"
#include "render/labels.h"

namespace penumbra {

void draw_menu_bar(AppState &state);
void draw_tool_bar(AppState &state, const WindowRect &rect);
void draw_side_panel(AppState &state, const WindowRect &rect);   ///< layers, options, figures
void draw_solution(AppState &state);                               ///< in the side panel
void draw_curve_filter(AppState &state);                          ///< in the side panel
void draw_inspector(AppState &state, const WindowRect &rect, const Fonts &fonts); ///< where it is open
void draw_cost(AppState &state, const Fonts &fonts);              ///< in the inspector
void draw_microscope(AppState &state);                            ///< in the inspector
void draw_element(AppState &state, const Fonts &fonts);           ///< in the inspector
void draw_element_links(AppState &state, const ElementReport &report); ///< who lights it, a row each
void draw_xray(AppState &state, const Fonts &fonts);              ///< below the element's links
void draw_hard_cases(AppState &state);                            ///< in the inspector
void draw_bookmarks(AppState &state);                             ///< in the inspector
void draw_objects(AppState &state);                               ///< in the inspector
void draw_effects(AppState &state);                               ///< in the inspector
void draw_profile_panel(AppState &state, const WindowRect &rect, const Fonts &fonts); ///< where it is open
void draw_transport(AppState &state, const WindowRect &rect);    ///< step, play, the course so far, cancel
void draw_status_bar(AppState &state, const WindowRect &rect);
/// Labels and legends over the panes, and the mouse in them.
void draw_panes(AppState &state, const Arrangement &arrangement, const Fonts &fonts);
/// Over the panes; part of draw_panes. The divider of a wipe is dragged before the panes have the mouse.
void drag_divider(AppState &state, const Arrangement &arrangement);
void draw_divider(const AppState &state, ImDrawList &list, const Arrangement &arrangement);
void draw_keyhole(AppState &state, ImDrawList &list, const Arrangement &arrangement, const Fonts &fonts);
/// The element that was picked, the links from the surface that was, and the line of their X-ray.
void draw_picked_element(const AppState &state, ImDrawList &list, const WindowRect &pane, const Camera &camera,
                         const Fonts &fonts);
void draw_profile_line(const AppState &state, ImDrawList &list, const Arrangement &arrangement, const Fonts &fonts);
void draw_hint(AppState &state, const WindowRect &panes);        ///< until the first step
void draw_caption(const AppState &state, const WindowRect &panes); ///< of a lecture
void draw_error(AppState &state, const WindowRect &panes);       ///< the message, when it is one
void draw_open_dialog(AppState &state);
void draw_picture_settings(AppState &state);
void draw_help(AppState &state);
void draw_palette(AppState &state);
void draw_tour(AppState &state, const Arrangement &arrangement);  ///< in the lower right corner of the panes
void draw_offer(AppState &state, const WindowRect &panes);        ///< of what a window showed that ended unexpectedly

} // namespace penumbra
