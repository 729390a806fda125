#include "script_lines.h"

#include "discontinuity/curve.h"
#include "verbs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

namespace penumbra {

namespace {

using Lines = std::vector<std::string>;

std::string text(double x) { return fmt::format("{}", x); }
template <class Vector>
std::string triple(const Vector &v) {
    return fmt::format("{} {} {}", v[0], v[1], v[2]);
}
std::string text(const Range &r) { return fmt::format("{}:{}", r.low, r.high); }
std::string text(const SurfacePoint &p) { return fmt::format("{} {}", p.surface, triple(p.point)); }

/// A line of options, which is none without any.
struct OptionLine {
    std::string line, options{};

    void add(const char *name, const std::string &value) { options += fmt::format(" --{} {}", name, value); }
    void quote(const char *name, const std::string &value) { add(name, '"' + value + '"'); }
    void end(Lines &lines) const {
        if (!options.empty())
            lines.push_back(line + options);
    }
};

template <std::size_t n, class Name>
std::string flagged(const std::array<bool, n> &on, const Name &name) {
    std::string all;
    for (std::size_t i = 0; i < n; ++i)
        if (on[i])
            all += (all.empty() ? "" : ",") + std::string(name(i));
    return all.empty() ? "none" : all;
}

/// What the solution is asked for; whatever that starts anew goes on to where it was asked to go.
void set_options(Lines &lines, Scripted &a, const Scripted &b) {
    const Options &to = b.set.options;
    Options o = a.set.options;
    OptionLine set{"set"};
    if (to.tolerance && to.tolerance != o.tolerance) {
        set.add("tolerance", text(*to.tolerance));
        o = o.to_tolerance(*to.tolerance);
    } else if (!to.tolerance && (o.tolerance || o.threshold != to.threshold)) {
        set.add("threshold", text(to.threshold));
        o = o.to_threshold(to.threshold);
    }
    const auto number = [&](const char *name, int now, int wanted) {
        if (now != wanted)
            set.add(name, std::to_string(wanted));
    };
    const auto word = [&](const char *option, auto now, auto wanted) {
        if (now != wanted)
            set.add(option, std::string(name(wanted)));
    };
    number("max-depth", o.max_depth, to.max_depth);
    number("max-iterations", o.max_iterations, to.max_iterations);
    number("order", o.order, to.order);
    word("basis", o.basis, to.basis);
    word("cut", o.cut, to.cut);
    word("coarse-correction", o.coarse_correction, to.coarse_correction);
    word("gather", o.gather, to.gather);
    for (const Effect effect : all_effects)
        if (o.effects[effect] != to.effects[effect])
            set.add("effect", fmt::format("{}={}", name(effect), name(to.effects[effect])));
    if (set.options.empty())
        return;
    set.end(lines);
    a.set.look.range.reset(); // as every start does
    if (!b.playing && b.place.position > 0)
        a.place = {-1};
}

void move_objects(Lines &lines, Scripted &a, const Scripted &b) {
    const auto &from = a.set.moves, &to = b.set.moves;
    if (from == to)
        return;
    a.set.look.range.reset();
    if (to.empty()) {
        lines.emplace_back("edit.put_back");
        return;
    }
    for (const ObjectMove &m : from)
        if (std::ranges::find(to, m.surface, &ObjectMove::surface) == to.end())
            lines.push_back(fmt::format("move {} 0 0 0", m.surface));
    for (const ObjectMove &m : to)
        if (std::ranges::find(from, m) == from.end())
            lines.push_back(fmt::format("move {} {}{}", m.surface, triple(m.offset), m.scale == 1 ? "" : " " + text(m.scale)));
}

void choose_panes(Lines &lines, Scripted a, const Scripted &b) {
    const int n = n_panes(b.set.layout);
    const std::size_t index = pane_set_of(b.set.layout);
    PaneSet now = a.set.pane_sets[index];
    const PaneSet &to = b.set.pane_sets[index];
    if (a.set.layout != b.set.layout || !std::equal(now.strategies.begin(), now.strategies.begin() + n, to.strategies.begin())) {
        std::string letters;
        for (int i = 0; i < n; ++i)
            letters += std::string(" ") + letter(to.strategies[static_cast<std::size_t>(i)]);
        lines.push_back("panes" + letters + (share_a_place(b.set.layout) ? " " + std::string(name(b.set.layout)) : ""));
        if (b.set.layout == Layout::difference)
            now.active = 1; // which it makes so
    }
    if (a.set.wipe != b.set.wipe)
        lines.push_back("wipe " + text(b.set.wipe));
    const auto go_to_pane = [&](int pane) {
        if (const int times = (pane - now.active + n) % n; times > 0)
            lines.push_back(times == 1 ? "view.next_pane" : "view.next_pane " + std::to_string(times));
        now.active = pane;
    };
    for (int i = 0; i < n; ++i)
        if (const auto pane = static_cast<std::size_t>(i);
            is_constant(to.strategies[pane]) && now.reconstructed[pane] != to.reconstructed[pane]) {
            go_to_pane(i);
            lines.emplace_back("strategy.reconstructed");
        }
    go_to_pane(to.active);
}

void show_errors(Lines &lines, OptionLine &show, const Look &from, const Look &to) {
    if (to.change && from.change != to.change) {
        show.add("change", text_of(*to.change));
    } else if (to.shading == Shading::error) {
        if (from.change && !to.change)
            lines.emplace_back("layers.polynomial"); // lets go of the change
        if (from.shading != to.shading || from.change != to.change)
            show.add("shading", "error");
    } else if (from.shading != to.shading || from.change) {
        lines.push_back("layers." + std::string(name(to.shading)));
    }
    if (from.error != to.error)
        show.add("error", std::string(name(to.error)));
    if (to.error_range && from.error_range != to.error_range)
        show.add("error-range", text(*to.error_range));
}

void show_curves(OptionLine &show, const CurveFilter &from, const CurveFilter &to) {
    if (from.kinds != to.kinds)
        show.add("curve-kinds", flagged(to.kinds, [](std::size_t k) { return name(static_cast<CurveKind>(k)); }));
    if (from.orders != to.orders)
        show.add("curve-orders", flagged(to.orders, [](std::size_t k) { return std::to_string(k); }));
    if (from.source != to.source)
        show.add("curve-source", to.source < 0 ? "all" : std::to_string(to.source));
}

std::string camera_line(const Camera &c) {
    return fmt::format("show --camera \"{} {} {} {}\"", triple(c.eye), triple(c.target), triple(c.up), c.fov_y);
}

std::size_t active_pane(const Parameters &p) { return static_cast<std::size_t>(p.pane_sets[pane_set_of(p.layout)].active); }

/// Makes panes that have lines of their own the active one for these, once round and back.
void go_through_panes(Lines &lines, const Parameters &to, const std::function<Lines(std::size_t)> &of) {
    const int n = n_places(to.layout);
    int passed = 0; // panes, since the last line
    const auto pass = [&] {
        if (passed > 0)
            lines.push_back(passed == 1 ? "view.next_pane" : fmt::format("view.next_pane {}", passed));
        passed = 0;
    };
    bool any = false;
    for (int k = 0; k < n; ++k, ++passed)
        if (const Lines own = of((active_pane(to) + static_cast<std::size_t>(k)) % static_cast<std::size_t>(n)); !own.empty()) {
            pass();
            lines.insert(lines.end(), own.begin(), own.end());
            any = true;
        }
    if (any && passed < n)
        pass();
}

void show_cameras(Lines &lines, const Parameters &a, const Parameters &b) {
    const int n = n_places(b.layout);
    const std::size_t active = active_pane(b);
    if (n > 1 && a.pane_cameras.has_value() != b.pane_cameras.has_value())
        lines.emplace_back("view.unlink");
    if (n == 1 || !b.pane_cameras) {
        const std::optional<Camera> now = n > 1 && a.pane_cameras ? (*a.pane_cameras)[active] : a.camera;
        if (b.camera && now != b.camera)
            lines.push_back(camera_line(*b.camera));
        else if (now && !b.camera)
            lines.emplace_back("view.reset");
        return;
    }
    const auto same = [&](std::size_t pane) {
        return a.pane_cameras ? (*a.pane_cameras)[pane] == (*b.pane_cameras)[pane] : a.camera == (*b.pane_cameras)[pane];
    };
    go_through_panes(lines, b, [&](std::size_t pane) { return same(pane) ? Lines() : Lines{camera_line((*b.pane_cameras)[pane])}; });
}

Lines tone_lines(const Tone &from, const Tone &to) {
    Lines lines;
    if (from.range_chosen && !to.range_chosen)
        lines.emplace_back("layers.lock_range");
    OptionLine show{"show"};
    if (from.exposure_ev != to.exposure_ev)
        show.add("exposure", text(to.exposure_ev));
    if (to.range && from.range != to.range)
        show.add("range", text(*to.range));
    if (to.error_range && from.error_range != to.error_range)
        show.add("error-range", text(*to.error_range));
    show.end(lines);
    return lines;
}

/// Exposure and ranges of the panes that are not active, where they have their own.
void show_tones(Lines &lines, const Parameters &a, const Parameters &b) {
    if (n_places(b.layout) == 1)
        return;
    if (a.pane_tones.has_value() != b.pane_tones.has_value())
        lines.emplace_back("view.unlink_tones");
    if (!b.pane_tones)
        return;
    const std::size_t active = active_pane(b);
    go_through_panes(lines, b, [&](std::size_t pane) {
        const Tone &from = a.pane_tones ? (*a.pane_tones)[pane] : (*b.pane_tones)[active];
        return pane == active ? Lines() : tone_lines(from, (*b.pane_tones)[pane]);
    });
}

void show_look(Lines &lines, const Scripted &a, const Scripted &b) {
    const Look &from = a.set.look, &to = b.set.look;
    const bool unlocks = from.range && !to.range, unlocks_errors = from.error_range && !to.error_range && from.error == to.error;
    if (from.shading == Shading::error ? unlocks_errors : unlocks)
        lines.emplace_back("layers.lock_range"); // of what is shown before
    OptionLine show{"show"};
    show_errors(lines, show, from, to);
    if (from.layers != to.layers)
        show.add("layers", flagged(std::array{to.layers.mesh, to.layers.curves, to.layers.links}, [](std::size_t i) {
                     constexpr std::string_view names[] = {"mesh", "curves", "links"};
                     return names[i];
                 }));
    show_curves(show, from.curve_filter, to.curve_filter);
    if (from.exposure_ev != to.exposure_ev)
        show.add("exposure", text(to.exposure_ev));
    if (to.range && from.range != to.range)
        show.add("range", text(*to.range));
    if (from.theme != to.theme)
        show.add("background", to.theme == Theme::dark ? "dark" : "light");
    if (b.set.pinned_curve && a.set.pinned_curve != b.set.pinned_curve)
        show.add("curve", std::to_string(*b.set.pinned_curve));
    if (b.set.keyhole && a.set.keyhole != b.set.keyhole)
        show.quote("keyhole", triple(b.set.keyhole->point));
    if (b.set.profile && a.set.profile != b.set.profile)
        show.quote("profile", triple(b.set.profile->first.point) + " " + triple(b.set.profile->second));
    show.end(lines);
    if (a.set.pinned_curve && !b.set.pinned_curve)
        lines.emplace_back("unpin");
    show_tones(lines, a.set, b.set);
    show_cameras(lines, a.set, b.set);
    if (b.pivot && a.pivot != b.pivot)
        lines.push_back("pivot " + triple(*b.pivot));
}

/// Whatever an action turns on and off.
void flip(Lines &lines, const Scripted &a, const Scripted &b) {
    const auto unless = [&](bool same, const char *id) {
        if (!same)
            lines.emplace_back(id);
    };
    unless(!a.set.keyhole || b.set.keyhole, "view.keyhole");
    unless(!a.set.profile || b.set.profile, "view.profile");
    unless(a.set.legend_hidden == b.set.legend_hidden, "layers.legend");
    unless(a.set.look.false_colour == b.set.look.false_colour, "layers.false_colour");
    unless(a.set.look.emphasise_fresh == b.set.look.emphasise_fresh, "layers.fresh");
    unless(a.panels_hidden == b.panels_hidden, "view.panels");
    unless(a.animates_splits == b.animates_splits, "solve.animate");
    unless(a.help == b.help, "help.keys");
    unless(a.picture_settings == b.picture_settings, "file.picture_settings");
}

void inspect(Lines &lines, const Scripted &a, const Scripted &b) {
    constexpr std::string_view actions[] = {"",           "filters", "hard_cases", "cost",
                                            "effects", "objects", "bookmarks",  "inspector"};
    if (a.inspector != b.inspector) // the same action closes what it has opened
        lines.push_back("view." + std::string(actions[static_cast<std::size_t>(
                                      b.inspector == Inspector::none ? a.inspector : b.inspector)]));
    if (b.inspector == Inspector::element) {
        if (b.element && (a.element != b.element || a.inspector != b.inspector))
            lines.push_back("pick " + text(*b.element));
        if (a.source != b.source || a.xray != b.xray)
            lines.push_back(fmt::format("xray {} {}", b.source ? std::to_string(*b.source) : "none",
                                        b.xray == XrayLine::worst ? "worst" : "centre"));
    } else if (b.inspector == Inspector::filters) {
        if (b.split && (a.split != b.split || a.inspector != b.inspector))
            lines.push_back("pick " + text(*b.split));
        if (a.outward != b.outward || a.piece != b.piece)
            lines.push_back(fmt::format("filters {} {}", b.outward, b.piece));
    }
    if (a.object != b.object)
        lines.push_back("object " + (b.object < 0 ? std::string("none") : std::to_string(b.object)));
    if (a.cost != b.cost)
        lines.push_back("cost " + std::string(name(b.cost)));
}

void caption_bookmarks(Lines &lines, const Scripted &a, const Scripted &b) {
    const auto &from = a.bookmarks, &to = b.bookmarks;
    if (to.size() + 1 == from.size()) {
        const auto gone = std::ranges::mismatch(from, to).in1 - from.begin();
        lines.push_back("forget " + std::to_string(gone + 1));
    }
    if (to.size() == from.size())
        for (std::size_t i = 0; i < to.size(); ++i)
            if (from[i] != to[i])
                lines.push_back(fmt::format("caption {} {}", i + 1, to[i]));
}

void take_pictures_as(Lines &lines, const Scripted &a, const Scripted &b) {
    if (a.pictures == b.pictures)
        return;
    const PixelSize size = pixels_of(b.pictures.size);
    lines.push_back(fmt::format("pictures {} {}{}{}", size.width == 0 ? "panes" : fmt::format("{}x{}", size.width, size.height),
                                b.pictures.supersample, b.pictures.transparent ? " transparent" : "",
                                b.pictures.labels ? "" : " no-labels"));
}

} // namespace

std::vector<std::string> way_to(const Scripted &to, bool played) {
    const auto &[position, split, linking] = to.place;
    if (position >= far_ahead)
        return {played ? "play" : "go end"};
    std::string place = std::to_string(iteration_of(position));
    if (const Phase phase = phase_of(position); phase == Phase::refined || phase == Phase::gathered)
        place += " " + std::string(name(phase));
    Lines lines;
    if (played)
        lines.push_back("play " + place);
    if (!played || split || linking)
        lines.push_back("go " + place +
                        (split ? fmt::format(" {}", *split) : linking ? fmt::format(" links {}", *linking) : std::string()));
    return lines;
}

std::vector<std::string> lines_between(const Scripted &from, const Scripted &to) {
    Lines lines;
    if (from.bookmark != to.bookmark && from.bookmarks == to.bookmarks && to.bookmark >= 0)
        return {"bookmark " + std::to_string(to.bookmark + 1)}; // with all that it brings
    Scripted a = from;
    move_objects(lines, a, to);
    set_options(lines, a, to);
    choose_panes(lines, a, to);
    if (a.set.steps_unlinked != to.set.steps_unlinked && n_panes(to.set.layout) > 1)
        lines.emplace_back("view.unlink_steps");
    if (a.speed != to.speed)
        lines.push_back("speed " + text(to.speed));
    if (a.place != to.place)
        std::ranges::move(way_to(to, from.playing), std::back_inserter(lines));
    flip(lines, a, to);
    show_look(lines, a, to);
    inspect(lines, a, to);
    take_pictures_as(lines, a, to);
    caption_bookmarks(lines, a, to);
    if (a.caption != to.caption)
        lines.push_back(to.caption.empty() ? "say" : "say " + to.caption);
    return lines;
}

} // namespace penumbra
