#include "render/picture.h"

#include "core/error.h"
#include "gl/bound_framebuffer.h"
#include "gl/context_lost.h"
#include "render/divider.h"
#include "render/event_note.h"
#include "render/keyhole_inset.h"
#include "render/overlay.h"
#include "render/pane_renderer.h"
#include "render/profile_mark.h"
#include "render/tiles.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace penumbra {
namespace {

/// Where things lie [pixels, y down].
struct Layout {
    std::vector<PixelRect> cells; ///< of the panes with their labels
    std::vector<PixelRect> views; ///< of the drawing below the label
    std::vector<PixelRect> parts; ///< of the views, that are drawn
    PixelRect inset, note, legend;
};

float text_height(const PictureSpec &spec) {
    if (spec.text > 0)
        return static_cast<float>(spec.text);
    return static_cast<float>(std::max(11.0, std::round(std::min(spec.width / (spec.columns > 1 ? 30.0 * spec.columns : 54), spec.height / 42.0))));
}

int n_rows(const PictureSpec &spec) { return spec.wipe ? 1 : (static_cast<int>(spec.panes.size()) + spec.columns - 1) / spec.columns; }

/// Heights of the parts that hold text, which depend on how the text breaks into lines, and the width of the keyhole's.
struct TextSizes {
    int legend = 0, label = 0, note = 0, inset = 0;
};

/// The part of a wipe on its left, or on its right, of the divider.
PixelRect side(const PixelRect &whole, double share, std::size_t pane) {
    const int left = static_cast<int>(std::lround(share * whole.width));
    return pane == 0 ? PixelRect{whole.x, whole.y, left, whole.height}
                     : PixelRect{whole.x + left, whole.y, whole.width - left, whole.height};
}

Layout layout(const PictureSpec &spec, const TextSizes &sizes) {
    Layout result;
    const int gap = spec.panes.size() > 1 ? static_cast<int>(text_height(spec) / 2) : 0, rows = std::max(1, n_rows(spec));
    const int below = sizes.legend + sizes.note, label_height = sizes.label;
    const int height = spec.height - below - (rows - 1) * gap, width = spec.width - sizes.inset - (spec.columns - 1) * gap;
    for (int i = 0; i < static_cast<int>(spec.panes.size()); ++i) {
        const int row = spec.wipe ? 0 : i / spec.columns, column = i % spec.columns;
        const PixelRect cell{column * (width / spec.columns + gap), row * (height / rows + gap), width / spec.columns,
                             height / rows};
        result.cells.push_back(cell);
        const PixelRect view{cell.x, cell.y + label_height, cell.width, std::max(1, cell.height - label_height)};
        result.views.push_back(view);
        result.parts.push_back(spec.wipe ? side(view, *spec.wipe, result.parts.size()) : view);
        if (spec.wipe)
            result.cells.back() = side(cell, label_share(*spec.wipe), static_cast<std::size_t>(i));
    }
    result.inset = {spec.width - sizes.inset, label_height, sizes.inset, spec.height - below - label_height};
    result.note = {0, spec.height - below, spec.width, sizes.note};
    result.legend = {0, spec.height - sizes.legend, spec.width, sizes.legend};
    return result;
}

/// Of error pictures; others tell the snapshot's own error.
const ErrorMap *shown_errors(const PictureSpec &spec, const PicturePane &pane) {
    return spec.look.shading == Shading::error ? pane.errors.get() : nullptr;
}

PaneLabel label_of(const PictureSpec &spec, const PicturePane &pane) {
    const ErrorMap *errors = shown_errors(spec, pane);
    return pane.minus ? difference_label(*pane.minus, *pane.snapshot, errors) : pane_label(*pane.snapshot, pane.tag, errors);
}

bool have_same_footnote(const PictureSpec &spec) {
    for (const PicturePane &pane : spec.panes)
        if (pane_label(*pane.snapshot).footnote != pane_label(*spec.panes.front().snapshot).footnote)
            return false;
    return true;
}

/// The curve in the limelight; null when there is none.
const SnapshotCurve *noted_curve(const PictureSpec &spec) {
    const int chosen = spec.look.spotlight.curve;
    if (spec.panes.empty() || !spec.panes.front().snapshot->curves)
        return nullptr;
    const auto &curves = *spec.panes.front().snapshot->curves;
    return chosen >= 0 && chosen < static_cast<int>(curves.size()) ? &curves[static_cast<std::size_t>(chosen)] : nullptr;
}

/// What that curve is, or the caption and the price, above `bottom`; measured only when there is no list. Returns its height.
float draw_note(ImDrawList *list, const Fonts &fonts, const PictureSpec &spec, float bottom) {
    const SnapshotCurve *curve = noted_curve(spec);
    if (!curve && spec.caption.empty() && spec.price.empty())
        return 0;
    constexpr const char *measured = "measured while this picture was made";
    const EventWords words = curve ? event_words(*spec.panes.front().snapshot, *curve)
                                   : spec.caption.empty() ? EventWords{spec.price, "", measured, ""}
                                                        : EventWords{spec.caption, "", spec.price, ""};
    return draw_event_note(list, fonts, {0.6f * fonts.size, bottom}, static_cast<float>(spec.width) - 1.2f * fonts.size,
                           words, curve ? curve_colour(curve->kind) : ImVec4(0.95f, 0.62f, 0.1f, 1), spec.look.theme)
        .y;
}

/// The keyhole's width with a margin on its right.
int inset_width(const PictureSpec &spec, const Fonts &fonts) {
    return spec.keyhole ? static_cast<int>(std::ceil(keyhole_inset_size(fonts, *spec.keyhole).x + 0.6f * fonts.size)) : 0;
}

TextSizes measure(const PictureSpec &spec, const Fonts &fonts, const std::vector<const Snapshot *> &snapshots) {
    TextSizes sizes;
    sizes.inset = inset_width(spec, fonts);
    const float em = fonts.size;
    if (spec.labels)
        for (std::size_t i = 0; i < spec.panes.size(); ++i) {
            const PicturePane &pane = spec.panes[i];
            const PixelRect row{0, 0, (spec.width - sizes.inset) / spec.columns, 0};
            const float width = static_cast<float>((spec.wipe ? side(row, label_share(*spec.wipe), i) : row).width) - em;
            const PaneLabel label = label_of(spec, pane);
            sizes.label = std::max(sizes.label, static_cast<int>(std::ceil(pane_label_height(fonts, width, label))));
        }
    sizes.note = static_cast<int>(std::ceil(draw_note(nullptr, fonts, spec, 0)));
    if (spec.legend) {
        const float lines = line_legend_size(fonts, 0.52f * static_cast<float>(spec.width), spec.look, snapshots).y;
        sizes.legend = static_cast<int>(std::ceil(std::max(5.1f * em, lines) + 0.7f * em));
    }
    return sizes;
}

ImVec2 corner(const PixelRect &r) { return {static_cast<float>(r.x), static_cast<float>(r.y)}; }
ImVec2 far_corner(const PixelRect &r) { return {static_cast<float>(r.x + r.width), static_cast<float>(r.y + r.height)}; }

/// Behind words over a clear background: they are read on whatever will be there.
void draw_plate(ImDrawList &list, const PictureSpec &spec, const ImVec2 &low, const ImVec2 &high) {
    const glm::vec4 c = background_colour(spec.look.theme);
    if (spec.look.transparent && high.x > low.x && high.y > low.y)
        list.AddRectFilled(low, high, ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 0.85f}), 0.4f * text_height(spec));
}

void draw_labels(ImDrawList &list, const Fonts &fonts, const PictureSpec &spec, const Layout &l, bool same_footnote) {
    const float em = fonts.size;
    for (std::size_t i = 0; i < spec.panes.size(); ++i) {
        PaneLabel label = label_of(spec, spec.panes[i]);
        const ImVec2 low = corner(l.cells[i]), high = far_corner(l.cells[i]);
        if (!same_footnote) { // else it is said once, with the legend
            const float width = 0.9f * fonts.text->CalcTextSizeA(em, 1e9f, 0, label.footnote.c_str()).x;
            const ImVec2 at(high.x - width - 0.6f * em, high.y - 1.5f * em);
            draw_plate(list, spec, {at.x - 0.4f * em, at.y - 0.2f * em}, {high.x - 0.2f * em, at.y + 1.3f * em});
            draw_footnote(list, fonts, at, label, spec.look.theme);
        }
        label.footnote.clear();
        draw_plate(list, spec, low, {high.x, corner(l.views[i]).y});
        draw_pane_label(list, fonts, low, high, label, spec.look.theme);
    }
}

Look look_of(const PictureSpec &spec, const PicturePane &pane) {
    return pane.tone ? with_tone(spec.look, *pane.tone) : spec.look;
}

bool have_own_tones(const PictureSpec &spec) {
    return std::ranges::any_of(spec.panes, [](const PicturePane &pane) { return pane.tone.has_value(); });
}

/// In the corners of the panes.
void draw_own_legends(ImDrawList &list, const Fonts &fonts, const PictureSpec &spec, const Layout &l) {
    const float em = fonts.size;
    for (std::size_t i = 0; i < spec.panes.size(); ++i) {
        const Look look = look_of(spec, spec.panes[i]);
        const ImVec2 low = corner(l.views[i]), high = far_corner(l.views[i]);
        draw_colour_legend(list, fonts, {high.x - 0.9f * em, low.y + 0.9f * em}, std::min(14 * em, 0.5f * (high.y - low.y)), look,
                           *look.range);
    }
}

void draw_legend(ImDrawList &list, const Fonts &fonts, const PictureSpec &spec, const Layout &l, bool same_footnote,
                 const std::vector<const Snapshot *> &snapshots) {
    const float em = fonts.size, width = static_cast<float>(spec.width);
    const ImVec2 at = corner(l.legend);
    draw_plate(list, spec, at, far_corner(l.legend));
    const float below =
        have_own_tones(spec)
            ? 0
            : draw_colour_legend_lying(list, fonts, {at.x + em, at.y + 0.4f * em}, 0.34f * width, spec.look, *spec.look.range).y;
    if (same_footnote && !spec.panes.empty())
        draw_footnote(list, fonts, {at.x + em, at.y + 0.6f * em + below}, pane_label(*snapshots.front()), spec.look.theme);
    draw_line_legend(list, fonts, {at.x + 0.43f * width, at.y + 0.4f * em}, 0.55f * width, spec.look, snapshots);
}

/// All that stands over the panes and beside them.
void draw_words(ImDrawList &list, const Fonts &fonts, const PictureSpec &spec, const Layout &l,
                const std::vector<const Snapshot *> &snapshots) {
    const bool same_footnote = spec.legend && have_same_footnote(spec);
    if (spec.labels)
        draw_labels(list, fonts, spec, l, same_footnote);
    if (spec.wipe)
        draw_divider(list, static_cast<float>(l.parts[1].x), corner(l.views[0]).y, far_corner(l.views[0]).y, fonts.size);
    for (std::size_t i = 0; i < (spec.wipe ? 1 : l.views.size()); ++i) {
        const PixelRect &view = l.views[i];
        const Camera camera = spec.panes[i].camera.value_or(spec.camera);
        if (spec.profile)
            draw_profile_mark(list, fonts, corner(view), far_corner(view), camera, *spec.profile);
        if (spec.keyhole)
            draw_keyhole_point(list, fonts, corner(view), far_corner(view), camera, *spec.keyhole);
    }
    if (spec.keyhole)
        draw_keyhole_inset(list, fonts, corner(l.inset), *spec.keyhole, *snapshots.front(), spec.look.theme);
    draw_note(&list, fonts, spec, static_cast<float>(l.note.y + l.note.height));
    if (spec.legend && have_own_tones(spec))
        draw_own_legends(list, fonts, spec, l);
    if (spec.legend)
        draw_legend(list, fonts, spec, l, same_footnote, snapshots);
}

/// What is drawn before it is averaged, with the ranges that its panes share or have.
PictureSpec enlarged(const PictureSpec &spec, const std::vector<const Snapshot *> &snapshots) {
    PictureSpec large = spec;
    large.text = static_cast<double>(spec.supersample) * text_height(spec);
    large.width *= spec.supersample;
    large.height *= spec.supersample;
    if (!large.look.range)
        large.look.range = common_range(snapshots);
    if (large.look.shading == Shading::error && !large.look.error_range)
        large.look.error_range = error_range(large.look.error, judged(spec));
    for (PicturePane &pane : large.panes)
        if (pane.tone)
            pane.tone = with_ranges(*pane.tone, pane, large.look);
    return large;
}

std::vector<const Snapshot *> snapshots_of(const PictureSpec &spec) {
    std::vector<const Snapshot *> all;
    for (const PicturePane &pane : spec.panes)
        all.push_back(pane.snapshot.get());
    return all;
}

} // namespace

Tone with_ranges(Tone tone, const PicturePane &pane, const Look &look) {
    const Snapshot *snapshots[] = {pane.snapshot.get()};
    const Judged judged[] = {{pane.snapshot.get(), pane.errors.get()}};
    if (!tone.range)
        tone.range = common_range(snapshots);
    if (look.shading == Shading::error && !tone.error_range)
        tone.error_range = error_range(look.error, judged);
    return tone;
}

std::vector<Judged> judged(const PictureSpec &spec) {
    std::vector<Judged> all;
    for (const PicturePane &pane : spec.panes)
        all.push_back({pane.snapshot.get(), pane.errors.get()});
    return all;
}

double pane_aspect(const PictureSpec &spec) {
    // Text heights are estimated: two lines of label, four of legend, two of a note.
    const float em = text_height(spec);
    const auto part = [&](bool there, float lines) { return there ? static_cast<int>(lines * em) : 0; };
    const Layout l = layout(
        spec, {part(spec.legend, 5.9f), part(spec.labels, 3.4f), part(noted_curve(spec) != nullptr || !spec.caption.empty() || !spec.price.empty(), 3.6f),
               inset_width(spec, Fonts{nullptr, nullptr, em})});
    return l.views.empty() ? 1 : l.views.front().aspect();
}

struct PictureDrawing::Parts {
    std::vector<const Snapshot *> snapshots;
    PictureSpec large;
    Overlay overlay;
    Layout layout;
    std::vector<std::unique_ptr<PaneRenderer>> renderers;
    TiledDrawing tiles;

    Parts(const PictureSpec &spec, int tile_side)
        : snapshots(snapshots_of(spec)), large(enlarged(spec, snapshots)), overlay(large.width, large.height, text_height(large)),
          layout(penumbra::layout(large, measure(large, overlay.fonts(), snapshots))),
          tiles({spec.width, spec.height, spec.supersample, tile_side, large.look.transparent,
                 large.look.transparent ? glm::vec4(0) : background_colour(large.look.theme)}) {
        draw_words(overlay.list(), overlay.fonts(), large, layout, snapshots);
        for (const PicturePane &pane : large.panes) {
            renderers.push_back(std::make_unique<PaneRenderer>());
            renderers.back()->upload(pane.snapshot, pane.errors);
        }
        overlay.leave();
    }
};

PictureDrawing::PictureDrawing(const PictureSpec &spec, int tile_side) {
    const gl::BoundFramebuffer before;
    parts_ = std::make_unique<Parts>(spec, tile_side);
}

PictureDrawing::~PictureDrawing() = default;

bool PictureDrawing::draw_tile() {
    const gl::BoundFramebuffer before;
    Parts &p = *parts_;
    const PixelScale scale{p.overlay.fonts().size / 15.0};
    p.overlay.enter();
    const bool drawn = p.tiles.draw_tile(
        [&](const PixelRect &tile) {
            for (std::size_t i = 0; i < p.renderers.size(); ++i) {
                const PicturePane &pane = p.large.panes[i];
                p.renderers[i]->draw(pane.camera.value_or(p.large.camera), look_of(p.large, pane), p.layout.views[i], p.large.height,
                                     scale, tile, p.layout.parts[i]);
            }
        },
        [&](const PixelRect &tile) { p.overlay.draw(tile); });
    p.overlay.leave();
    if (gl::context_is_lost())
        throw Unavailable("the graphics driver has lost what the picture was drawn with; try again");
    return drawn;
}

double PictureDrawing::share() const { return parts_->tiles.share(); }

Image PictureDrawing::take() && { return std::move(parts_->tiles).take(); }

Image draw_picture(const PictureSpec &spec, int tile_side) {
    PictureDrawing drawing(spec, tile_side);
    while (drawing.draw_tile()) {
    }
    return std::move(drawing).take();
}

} // namespace penumbra
