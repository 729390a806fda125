// Words and scales that make a picture explain itself, on any ImGui draw list: in the window and off-screen alike.
#pragma once

#include "iteration/snapshot.h"
#include "render/look.h"

#include <imgui.h>

#include <string>
#include <vector>

namespace penumbra {

struct ErrorMap; // iteration/error_map.h

/// DejaVu Sans (embedded), rasterised for this text height in pixels; very large text is drawn from letters of 96 pixels.
struct Fonts {
    ImFont *text = nullptr;
    ImFont *bold = nullptr;
    float size = 15; ///< text height [pixels]; every other distance of a label is a multiple of it
};
/// Adds the fonts to the atlas of the current ImGui context; `text` becomes its default. Before the first frame.
Fonts load_fonts(float size);

struct PaneLabel {
    std::string title;                ///< strategy in words: "Discontinuity meshing, order 4"
    std::vector<std::string> figures; ///< "3 patches", "48 coefficients", "error 0.12 %"; unknown ones left out
    std::string time;                 ///< "0.31 s"; empty: nothing was done yet
    std::string footnote;             ///< scene, step and phase
};
/// `tag` as "(a)" goes before the title. With a map the error is the map's, and the truth's own is told beside it.
PaneLabel pane_label(const Snapshot &snapshot, const std::string &tag = "", const ErrorMap *errors = nullptr);

/// Of the picture of a difference; with its map the label tells how large it is.
PaneLabel difference_label(const Snapshot &first, const Snapshot &second, const ErrorMap *map);

/// In the upper left corner of the rectangle; the footnote in the lower left one. `grounded`: lines have the background beneath
/// them, to be read over a picture. Returns the height of the upper part [pixels].
float draw_pane_label(ImDrawList &list, const Fonts &fonts, ImVec2 low, ImVec2 high, const PaneLabel &label, Theme theme,
                      bool grounded = false);
/// The footnote alone.
void draw_footnote(ImDrawList &list, const Fonts &fonts, ImVec2 corner, const PaneLabel &label, Theme theme);
/// The height it would have in a rectangle of this width.
float pane_label_height(const Fonts &fonts, float width, const PaneLabel &label);

/// Colour bar with ticks and unit, vertical, its upper right corner at `corner`, with the background beneath it to be read over
/// a picture: of radiosity over `range`, or of the
/// look's errors where these are shown and have a range. Returns its size.
ImVec2 draw_colour_legend(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float bar_height, const Look &look,
                          const Range &range);
/// The same lying down, `width` wide with its upper left corner at `corner`.
ImVec2 draw_colour_legend_lying(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float width, const Look &look,
                                const Range &range);

/// Kinds of curves and of mesh lines that occur in the snapshots and are shown, in lines of at most `width` pixels from
/// the upper left corner `corner`. Returns its size (zero when there is nothing to explain).
ImVec2 draw_line_legend(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float width, const Look &look,
                        const std::vector<const Snapshot *> &snapshots);
/// The size it would have.
ImVec2 line_legend_size(const Fonts &fonts, float width, const Look &look,
                        const std::vector<const Snapshot *> &snapshots);

/// What a radiosity looks like, as the surfaces pass shows it (grey for true colour): sRGB in [0, 1].
ImVec4 shown_colour(const Look &look, const Range &range, double radiosity);
/// Of a curve kind (Okabe & Ito 2008: told apart by colour-blind people).
ImVec4 curve_colour(int kind);

} // namespace penumbra
