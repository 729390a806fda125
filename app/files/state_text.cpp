#include "files/state_text.h"

#include "element_verbs.h"
#include "files/write_state.h"
#include "move_verbs.h"
#include "iteration/error_map.h"
#include "palette.h"
#include "picture_verbs.h"
#include "split_verbs.h"
#include "truth_verbs.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace penumbra {

namespace {

using Json = nlohmann::ordered_json;

Json triple(const glm::dvec3 &v) { return Json::array({v.x, v.y, v.z}); }

/// What a pane shows, which falls short of the position asked for while it is being computed.
int shown_position(const AppState &s, int pane) {
    int furthest = 0;
    for (const Strategy strategy : s.has_own_steps() ? std::vector{s.strategy_of(pane)} : s.shown())
        furthest = std::max(furthest, s.timeline(strategy).last());
    return std::clamp(s.shown_place(pane).position, 0, furthest);
}

bool all_converged(const AppState &s) {
    for (int pane = 0; pane < n_panes(s.layout); ++pane)
        if (const auto snapshot = s.solution(pane); !snapshot || !snapshot->counters.converged)
            return false;
    return true;
}

/// What was predicted of the active pane's run.
Json price(const AppState &s) {
    const auto &predicted = s.prices.predicted[static_cast<std::size_t>(s.active_strategy())];
    if (!predicted)
        return nullptr;
    return {{"seconds", predicted->seconds}, {"patches", predicted->patches}, {"bytes", predicted->bytes}};
}

std::string_view name(Inspector inspector) {
    constexpr std::string_view names[] = {"none", "filters", "hard_cases", "cost", "effects", "objects", "bookmarks", "element"};
    return names[static_cast<std::size_t>(inspector)];
}

/// Errors that are not known are negative.
Json known(double error) { return error >= 0 ? Json(error) : Json(); }

Json pane(const AppState &s, int pane) {
    const Strategy strategy = s.strategy_of(pane);
    Json j{{"strategy", name(strategy)}, {"computed", s.timeline(strategy).last()}};
    if (const auto snapshot = s.shown_snapshot(pane)) {
        j["reconstructed"] = snapshot->reconstructed;
        j["direct_error"] = known(snapshot->error);
        j["iteration"] = snapshot->counters.iteration;
        j["phase"] = name(snapshot->phase);
        j["split"] = snapshot->n_shown_events;
        j["linking"] = snapshot->n_shown_linkings;
        j["patches"] = snapshot->counters.patches;
        j["coefficients"] = snapshot->counters.coefficients;
        j["links"] = snapshot->counters.links;
        j["converged"] = snapshot->counters.converged;
        j["threshold"] = snapshot->counters.threshold;
        j["estimated_error"] = known(snapshot->counters.estimated_error);
        j["error_bound"] = known(snapshot->counters.error_bound);
        j["version"] = snapshot->version;
        const auto map = errors_of(s, pane);
        j["error"] = map ? Json(map->error()) : Json();
    }
    return j;
}

Json under_cursor(const AppState &s) {
    if (!s.under_cursor)
        return nullptr;
    const Pick &pick = *s.under_cursor;
    const auto difference = difference_under_cursor(s);
    return {{"surface", pick.surface},
            {"patch", pick.patch},
            {"point", {pick.point.x(), pick.point.y(), pick.point.z()}},
            {"radiosity", {pick.radiosity[0], pick.radiosity[1], pick.radiosity[2]}},
            {"difference", difference ? Json::array({(*difference)[0], (*difference)[1], (*difference)[2]}) : Json()}};
}

Json keyhole(const KeyholeMode &mode) {
    Json j{{"open", mode.open}, {"crossed", mode.crossed}, {"news", mode.news.sentence}};
    if (!mode.open || !mode.seen)
        return j;
    const Vec3 &p = mode.seen->point;
    j["surface"] = mode.seen->surface.index;
    j["point"] = {p.x(), p.y(), p.z()};
    j["emitters"] = Json::array();
    for (const KeyholeEmitter &e : mode.seen->emitters)
        j["emitters"].push_back({{"source", e.whole.surface}, {"share", e.share}, {"corners", e.corners.size()}});
    return j;
}

Json profile(const ProfileMode &mode) {
    Json j{{"open", mode.open}, {"dragging", mode.dragging != ProfileGrip::none}};
    if (!mode.open || !mode.line)
        return j;
    j["surface"] = mode.line->surface;
    j["length"] = mode.line->length();
    j["exact_points"] = mode.exact.size();
    j["crossings"] = mode.data.crossings.size();
    j["pieces"] = Json::array();
    for (const ProfileCurve &c : mode.data.curves)
        j["pieces"].push_back(c.pieces.size());
    j["cursor"] = mode.cursor ? Json(*mode.cursor) : Json();
    return j;
}

Json microscope(const Microscope &m) {
    Json j{{"splits", m.n_splits}, {"outward", m.outward}, {"piece", m.piece}, {"reading", m.reading}};
    if (!m.shown)
        return j;
    const PieceFilters &piece = m.shown->pieces[static_cast<std::size_t>(m.piece)];
    j["surface"] = m.shown->surface;
    j["basis"] = name(m.shown->basis);
    j["kind"] = m.shown->kind == SplitKind::cut ? "cut" : "uniform";
    j["pieces"] = m.shown->pieces.size();
    j["share"] = piece.share;
    j["difference"] = piece.difference.cwiseAbs().maxCoeff();
    j["loss"] = m.shown->loss.cwiseAbs().maxCoeff();
    return j;
}

/// What the palette offers first.
Json found(const AppState &s) {
    const auto entries = palette_entries(s, s.palette.typed);
    return entries.empty() ? Json() : Json(entries.front().title);
}

Json element(const AppState &s) {
    const ElementMode &mode = s.element;
    Json j{{"picked", mode.at.has_value()}, {"source", mode.source ? Json(*mode.source) : Json()}, {"awaited", awaits_report(s)}};
    const ElementReport *report = shown_report(s);
    if (!report)
        return j;
    j["heading"] = heading(*report);
    j["element"] = report->element;
    j["surface"] = report->surface;
    j["order"] = report->order;
    j["history"] = history_words(*report);
    j["links"] = Json::array();
    for (const LinkReport &l : report->links)
        j["links"].push_back({{"source", l.source},
                              {"receiver", l.receiver},
                              {"kind", l.kind},
                              {"links", l.n_links},
                              {"brings", {l.mean[0], l.mean[1], l.mean[2]}},
                              {"share", l.share},
                              {"verdict", l.words}});
    if (const auto &x = report->xray)
        j["xray"] = {{"line", x->line == XrayLine::worst ? "worst" : "centre"},
                     {"length", x->length()},
                     {"points", x->points.size()},
                     {"tests", x->tests.size()},
                     {"passes", x->passes},
                     {"cursor", mode.cursor ? Json(*mode.cursor) : Json()}};
    return j;
}

Json pictures(const PictureMode &mode) {
    const PictureSettings &settings = mode.settings;
    const PixelSize size = pixels_of(settings.size);
    return {{"pending", mode.pending.size()},
            {"drawn", mode.drawn ? Json(*mode.drawn) : Json()},
            {"settings_open", mode.settings_open},
            {"size", size.width == 0 ? Json("panes") : Json::array({size.width, size.height})},
            {"supersample", settings.supersample},
            {"transparent", settings.transparent},
            {"labels", settings.labels},
            {"command", mode.command}};
}

Json shelf(const Shelf &shelf) {
    constexpr std::string_view names[] = {"not run", "running", "ok", "failed"};
    Json j{{"checking", shelf.checking}, {"cases", Json::object()}};
    for (const ShelfCase &c : shelf.cases)
        for (const CaseVerdict &v : c.verdicts)
            j["cases"][c.name].push_back(names[static_cast<std::size_t>(v.status)]);
    return j;
}

} // namespace

SavedState saved_state(const AppState &s, const std::filesystem::path &folder) {
    SavedState saved;
    if (s.scene) {
        saved.scene = s.scene->name;
        saved.file = place_of(*s.scene, folder);
        saved.up = up_axis(*s.scene);
    }
    saved.moves = s.objects.moves;
    saved.options = s.options;
    saved.options.strategy = s.active_strategy();
    saved.strategies = s.shown();
    if (share_a_place(s.layout))
        saved.layout = s.layout;
    saved.wipe = s.wipe;
    for (int pane = 0; pane < n_panes(s.layout); ++pane)
        saved.reconstructed.push_back(s.reconstructs(pane));
    saved.active = s.panes().active;
    const int active = s.panes().active;
    saved.position = shown_position(s, active);
    for (int pane = 0; pane < n_panes(s.layout) && s.has_own_steps(); ++pane)
        saved.positions.push_back(shown_position(s, pane));
    saved.split = s.shows_before() ? s.shown_place(active).split : shown_splits(s);
    saved.linking = s.shows_before() ? s.shown_place(active).linking : shown_linkings(s);
    saved.converged = all_converged(s);
    if (s.camera_is_set)
        saved.camera = s.camera;
    for (int pane = 0; pane < n_panes(s.layout) && s.has_own_cameras(); ++pane)
        saved.cameras.push_back(s.camera_of(pane));
    for (int pane = 0; pane < n_panes(s.layout) && s.has_own_tones(); ++pane)
        saved.tones.push_back(s.tone_of(pane));
    saved.look = s.look;
    saved.look.error = s.shown_look().error; // that the range is of
    saved.look.spotlight.curve = s.pinned_curve.value_or(-1);
    saved.range_chosen = s.chosen_range.has_value();
    saved.legend = !s.legend_hidden;
    if (s.keyhole.open && s.keyhole.seen)
        saved.keyhole = s.keyhole.seen->point;
    saved.caption = s.caption;
    saved.bookmarks = s.bookmarks;
    saved.error_range_locked = s.truth.range_locked;
    if (s.profile.open && s.profile.line)
        saved.profile = std::pair(s.profile.line->from, s.profile.line->to);
    return saved;
}

std::string observed_state_text(const AppState &s) {
    Json j = state_json(saved_state(s, "."));
    j["position"] = s.position;
    j["iteration"] = iteration_of(s.position);
    j["phase"] = name(phase_of(s.position));
    j["panes"] = Json::array();
    bool awaits = false;
    for (int i = 0; i < n_panes(s.layout); ++i) {
        j["panes"].push_back(pane(s, i));
        awaits |= s.awaits_reconstruction(i);
    }
    j["run"] = s.run;
    j["busy"] = s.busy.has_value() || s.truth.busy || awaits || awaits_report(s) || !s.pictures.pending.empty() || s.pictures.drawn.has_value();
    j["judging"] = {
        {"busy", s.truth.busy}, {"doing", s.truth.doing}, {"halted", s.truth.halted}, {"truth_error", s.truth.error}};
    j["profiling"] = profile(s.profile);
    j["playing"] = s.playing;
    j["opening"] = s.opening;
    j["message"] = s.message.text;
    j["message_is_error"] = s.message.error;
    j["hint"] = !s.hint_done;
    j["help"] = s.help_open;
    j["open_dialog"] = s.open_dialog;
    j["palette"] = s.palette.open;
    j["script"] = {{"playing", s.script.playing}, {"line", s.script.line}};
    j["caption"] = s.caption;
    j["tour"] = {{"open", s.tour.open}, {"card", s.tour.card}};
    j["told"] = {{"control", s.told.control}, {"title", s.told.title}, {"sentence", s.told.sentence}, {"paper", s.told.paper}};
    j["recent"] = s.recent_files;
    j["offered"] = s.orphans.empty() ? Json() : Json(s.orphans.front());
    j["found"] = s.palette.open && !s.palette.typed.empty() ? found(s) : Json();
    j["changes"] = {{"past", s.history.past.size()}, {"future", s.history.future.size()}};
    j["panels_hidden"] = s.panels_hidden;
    j["ui_scale"] = s.ui_scale;
    j["speed"] = s.phases_per_second;
    j["splits"] = n_splits(s);
    j["linkings"] = n_linkings(s);
    j["animates_splits"] = s.animates_splits;
    j["seeking"] = s.seeking;
    j["before"] = s.shows_before();
    j["pivot"] = s.pivot ? triple(*s.pivot) : Json();
    j["under_cursor"] = under_cursor(s);
    j["hovered_curve"] = s.hovered_curve ? Json(*s.hovered_curve) : Json();
    j["pinned_curve"] = s.pinned_curve ? Json(*s.pinned_curve) : Json();
    j["looking"] = keyhole(s.keyhole);
    j["inspector"] = name(s.inspector);
    j["object"] = s.objects.chosen >= 0 && s.scene ? Json(object_name(*s.scene, s.objects.chosen)) : Json();
    j["bookmark"] = s.bookmark;
    j["cost_measure"] = name(s.cost_measure);
    j["price"] = price(s);
    j["earlier_runs"] = s.prices.runs.size();
    j["microscope"] = microscope(s.microscope);
    j["inspected"] = element(s);
    j["shelf"] = shelf(s.shelf);
    j["pictures"] = pictures(s.pictures);
    j["progress"] = picture_progress(s);
    j["picture"] = s.last_picture;
    j["saved"] = s.last_state;
    j["inputs"] = s.inputs;
    j["cancel_ms"] = s.cancel_ms;
    j["cut"] = s.cut;
    j["widgets"] = Json::object();
    for (const auto &[widget, r] : s.widgets)
        j["widgets"][widget] = Json::array({r.x, r.y, r.width, r.height});
    return j.dump(1, ' ', false, Json::error_handler_t::replace);
}

} // namespace penumbra
