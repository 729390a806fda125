// All that the viewer knows, in one place. Actions change it; the panels and the panes show it; the worker's goal
// follows from it.
#pragma once

#include "files/saved_state.h"
#include "iteration/after_splits.h"
#include "iteration/element_report.h"
#include "iteration/split_filters.h"
#include "layout.h"
#include "measure/keyhole.h"
#include "plot/cost_measure.h"
#include "picture_mode.h"
#include "price_book.h"
#include "plot/profile_sheet.h"
#include "render/camera.h"
#include "render/event_words.h"
#include "render/look.h"
#include "render/pick.h"
#include "scene/move_object.h"
#include "scene/scene.h"
#include "shelf.h"
#include "timeline.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

struct ErrorMap; // iteration/error_map.h
struct Action;   // action.h
struct Scripted; // scripted.h

using Clock = std::chrono::steady_clock;

/// Which strategies are compared; each number of panes remembers its own.
struct PaneSet {
    std::array<Strategy, 4> strategies{};
    int active = 0; ///< the pane that strategy actions change and numbers are told of
    std::array<bool, 4> reconstructed{}; ///< constants are drawn as quadratics (quadratic.h)

    bool operator==(const PaneSet &) const = default;
};

/// A sentence for the status bar; errors also stand over the panes until the next action.
struct Message {
    std::string text;
    bool error = false;
};

/// The phase that the worker is in.
struct Busy {
    Strategy strategy{};
    int position = 0; ///< that it leads to
    Clock::time_point since;
};

enum class PictureRequest { panes, window, command };

/// A rectangle of the window [screen coordinates, y downward].
struct WindowRect {
    float x = 0, y = 0, width = 0, height = 0;
};

/// Looking at the emitters from one point; see keyhole_verbs.h.
struct KeyholeMode {
    bool open = false;
    bool dragging = false;                     ///< the mouse holds the point
    std::shared_ptr<const Scene> scene;        ///< that the eye looks from
    std::shared_ptr<const KeyholeEye> eye;
    std::shared_ptr<const Keyhole> seen;       ///< from where the point is; null: nowhere yet
    int crossed = -1;                          ///< curve that was crossed last; -1: none
    Clock::time_point crossed_at;
    EventWords news;                           ///< what that has changed
};

struct SurfacePoint {
    int surface = 0;
    Vec3 point; ///< scene's own frame

    bool operator==(const SurfacePoint &) const = default;
};

/// How wrong the solutions are, as far as it is known; see truth_verbs.h.
struct TruthMode {
    /// By version of the snapshot, and of the one that it is held against (0: the truth), of the present run.
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::shared_ptr<const ErrorMap>> maps;
    double error = 0; ///< of the truth itself, relative; 0: exact, or not known yet
    bool busy = false;
    std::string doing;                 ///< what is being found out, in words
    bool halted = false;               ///< nothing is found out until something is asked for again
    bool range_locked = false;         ///< look.error_range stays as it is
    /// Kind and versions that a pane's range of errors was made for; the first of all of them where they share one.
    std::array<std::vector<std::uint64_t>, 4> ranged;
};

/// What of the profile's line the mouse holds.
enum class ProfileGrip { none, from, to };

/// The radiosity along a line; see profile_verbs.h.
struct ProfileMode {
    bool open = false;
    ProfileGrip dragging = ProfileGrip::none;
    std::optional<SurfacePoint> pressed; ///< where a new line begins, until the mouse has moved
    std::optional<ProfileLine> line;
    int asked = 0;                       ///< number of the line
    std::vector<ProfilePoint> exact;     ///< the truth along it; empty: not known yet
    ProfileData data;                    ///< that is plotted
    bool stale = false;                  ///< it is not the line's any more
    std::vector<std::uint64_t> versions; ///< of the snapshots that it is from
    std::optional<double> cursor;        ///< place on the line that is pointed at
    bool cursor_in_plot = false;         ///< by the mouse in the plot, not in a pane
};

/// What stands at the right of the panes.
enum class Inspector { none, filters, hard_cases, cost, effects, objects, bookmarks, element };

/// Looking at one element and at who lights it; see element_verbs.h.
struct ElementMode {
    std::optional<SurfacePoint> at; ///< the element that holds it is looked at; none: nothing yet
    std::optional<int> source;      ///< surface whose links are drawn and X-rayed
    XrayLine line = XrayLine::centre;
    std::shared_ptr<const ElementReport> shown; ///< of the question that was answered last; null: none was
    std::uint64_t version = 0;      ///< of the snapshot that the answer is about
    Strategy strategy{};            ///< that it is of
    ElementQuestion answered;
    std::optional<double> cursor;   ///< place on the X-ray's line that is pointed at
};

/// Looking at the filters of one split; see microscope_verbs.h.
struct Microscope {
    std::optional<SurfacePoint> at; ///< the splits above the patch that holds it are looked at; none: nothing yet
    int outward = 0;                ///< how many splits above the innermost one
    int piece = 0;                  ///< that is looked at
    std::shared_ptr<const SplitFilters> shown; ///< null: no split there
    std::uint64_t version = 0;                 ///< of the snapshot that it is from
    int split = -1;                            ///< of that snapshot
    int n_splits = 0;                          ///< above the patch
    std::string reading;                       ///< the number under the mouse, with its place
};

/// Objects that are moved; see move_verbs.h.
struct ObjectsMode {
    std::shared_ptr<const Scene> original;     ///< as its file has it
    std::vector<ObjectMove> moves;             ///< from there, one an object
    int chosen = -1;                           ///< first surface of the object in hand; -1: none
    std::optional<Vec3> grabbed;               ///< point of it that the mouse holds, scene's own frame
    /// What was shown before a drag goes on being shown until the step that is asked for is there again.
    std::array<std::shared_ptr<const Snapshot>, 4> shown_before; ///< by pane
};

/// All that a user sets, but the step: what undo brings back. See history.h.
struct Parameters {
    std::shared_ptr<const Scene> scene;
    std::vector<ObjectMove> moves; ///< that led to the scene
    Options options;
    Layout layout{};
    std::array<PaneSet, n_pane_sets> pane_sets;
    double wipe = 0.5;
    Look look;                            ///< its ranges only where they were chosen, without a spotlight
    std::optional<Camera> camera;         ///< none: nobody has moved it
    std::optional<std::array<Camera, 4>> pane_cameras; ///< none: linked
    std::optional<std::array<Tone, 4>> pane_tones; ///< the active pane's as in `look`; none: linked
    bool steps_unlinked = false;
    std::optional<SurfacePoint> keyhole;  ///< none: closed
    std::optional<std::pair<SurfacePoint, Vec3>> profile; ///< ends of its line; none: closed
    std::optional<int> pinned_curve;
    bool legend_hidden = false;

    bool operator==(const Parameters &) const = default;
};

/// The way that parameters have taken; see history.h.
struct History {
    std::vector<Parameters> past, future; ///< the nearest last
    std::optional<Parameters> present;    ///< none: nothing was seen yet
    Clock::time_point moved_at;           ///< when the camera alone was last noted
};

/// Where anything can be found by typing a part of its name; see palette.h.
struct PaletteMode {
    bool open = false;
    std::string typed;
    int chosen = 0; ///< of palette_entries()
};

/// The cards of the first start; see tour.h.
struct TourMode {
    bool open = false;
    int card = 0;
};

/// What the mouse tells about the control that it rests on.
struct Told {
    std::string control; ///< its name in `widgets`; empty: it rests on none
    std::string title, sentence, paper;
};

/// An action that was done, for the record of the session; see recorder.h.
struct Deed {
    const Action *action = nullptr;
    std::shared_ptr<const Scripted> before, after;
    bool rested = false; ///< everything that was asked for before was there
};

/// A script that is played; see script.h.
struct ScriptMode {
    bool playing = false;
    int line = 0, n_lines = 0;
};

struct AppState {
    // What is solved.
    std::shared_ptr<const Scene> scene;
    Options options;       ///< of all strategies; its own strategy is not looked at
    double asked_tolerance = 0.01; ///< the last one, or what a solution is asked for when the tolerance is chosen
    std::uint64_t run = 1; ///< grows when scene or options change, which starts every solution anew
    std::array<Timeline, 4> timelines; ///< by strategy, of the present run
    /// Constants drawn as quadratics, by the version of their own snapshot.
    std::map<std::uint64_t, std::shared_ptr<const Snapshot>> reconstructions;

    PriceBook prices; ///< of the runs before the present one, on the same scene
    std::optional<double> tolerance_in_hand; ///< while its slider is moved

    // Where it stands.
    int position = 0;      ///< asked for, see timeline.h; the active pane's, and all others' unless these have their own
    bool steps_unlinked = false;          ///< panes have their own, where there are several
    std::array<int, 4> pane_positions{};  ///< of the panes that are not active
    bool playing = false;
    double phases_per_second = 2; ///< of playing
    std::optional<int> play_until; ///< position at which playing pauses; none: at the end
    std::optional<int> split;     ///< splits of the refinement at `position` that are shown (split_verbs.h); none: all
    std::optional<int> linking;   ///< pairs that it linked, of which so many are shown, where `split` is none; none: all
    bool animates_splits = true;  ///< while playing
    bool seeking = false;         ///< goes on until a cut is shown
    int stepped_from = 0;         ///< position that the last step forward began at
    bool before_by_key = false, before_by_mouse = false; ///< held down: panes show what was before the last step
    std::map<std::uint64_t, std::shared_ptr<const Snapshot>> split_snapshots; ///< of the panes that `split` or `linking` is for
    bool halted = false;   ///< cancelled: nothing is computed until something is asked for again
    std::optional<Busy> busy;
    std::string opening;   ///< scene that is being read; empty: none

    // How it is seen.
    Layout layout = Layout::single;
    double wipe = 0.5; ///< where the divider of layout wipe stands, from the left, 0 to 1
    std::array<PaneSet, n_pane_sets> pane_sets{{{{Strategy::discontinuity_wavelet}, 0},
                                      {{Strategy::uniform_constant, Strategy::discontinuity_wavelet}, 1},
                                      {{Strategy::uniform_constant, Strategy::discontinuity_constant,
                                        Strategy::uniform_wavelet, Strategy::discontinuity_wavelet},
                                       3}}};
    Look look;
    std::optional<Range> chosen_range; ///< came with a state; none: look.range follows what is shown
    Camera camera;
    bool camera_is_set = false; ///< false: the first view is taken with the next snapshot
    bool camera_moved = false;  ///< by the user
    bool cameras_unlinked = false;      ///< panes side by side have these, each its own; else all have the one above
    std::array<Camera, 4> pane_cameras;
    bool tones_unlinked = false;    ///< panes side by side have their own exposure and ranges
    std::array<Tone, 4> pane_tones; ///< of the panes that are not active; the active one's is in `look`
    double first_aspect = 1;    ///< pane_aspect that the first view was made for
    double pane_aspect = 1;     ///< width / height of a pane, in the last frame
    std::optional<Pick> under_cursor;
    std::optional<int> hovered_curve; ///< of the active pane's curves; those of emitters come first and are the same in all panes
    std::optional<int> pinned_curve;  ///< by a click: stays in the limelight
    KeyholeMode keyhole;
    TruthMode truth;
    ProfileMode profile;
    std::optional<std::pair<Vec3, Vec3>> profile_to_open; ///< came with a state; as the keyhole's point
    Inspector inspector = Inspector::none;
    ObjectsMode objects;
    Microscope microscope;
    ElementMode element;
    CostMeasure cost_measure = CostMeasure::seconds; ///< of the plot of costs and its bars
    Shelf shelf;
    PictureMode pictures; ///< see picture_verbs.h
    std::optional<Vec3> keyhole_to_open; ///< came with a state; looked from as soon as something is known
    std::optional<glm::dvec3> pivot; ///< set by a double click; none: what lies under the mouse when a drag begins
    std::optional<glm::dvec3> orbit_pivot; ///< of the drag that is going on
    std::optional<glm::dvec3> drag_anchor; ///< point that a pan keeps under the mouse
    Clock::time_point fresh_since; ///< since when the newest patches are shown

    // Window.
    std::vector<std::string> bundled_scenes; ///< names
    bool inert = false; ///< for tests of the tests: actions do nothing
    bool panels_hidden = false, help_open = false, open_dialog = false, legend_hidden = false;
    PaletteMode palette;
    ScriptMode script;
    bool recording = false;  ///< deeds are noted
    std::vector<Deed> deeds; ///< since the recorder looked last
    std::vector<SavedState> bookmarks; ///< see bookmark_verbs.h
    int bookmark = -1;                 ///< that was gone to last
    std::optional<SavedState> to_restore; ///< as soon as its scene is open
    TourMode tour;
    Told told; ///< in the last frame
    std::string marked; ///< control that was drawn last
    std::string caption; ///< a sentence below the panes, in the window and in pictures; empty: none
    History history;
    std::string open_path; ///< in the dialog
    bool hint_done = false; ///< somebody has stepped: the hint has served
    double ui_scale = 1;
    Message message;

    // Kept from one start to the next; see window/keeper.h.
    Theme chosen_theme = Theme::dark; ///< by the user; that of a state or a script is look.theme alone
    bool tour_seen = false;
    std::vector<std::string> recent_files; ///< absolute, the latest first; some may have gone
    std::vector<std::string> orphans; ///< autosaves of windows that ended unexpectedly, the latest first; the first is offered

    // Asked of the window; it does them and takes them back.
    std::optional<std::string> open_request; ///< bundled name or file
    std::optional<PictureRequest> picture_request;
    std::string picture_file; ///< for that picture; empty: a numbered one in the folder of pictures
    bool state_request = false, discard_request = false;
    std::optional<std::string> copy_request; ///< text for the clipboard
    bool paste_request = false;              ///< of a view from the clipboard
    bool cancel_request = false, quit_request = false;

    std::map<std::string, WindowRect> widgets; ///< where each control was drawn in the last frame, by action or name
    std::vector<std::string> cut; ///< what does not fit where it is drawn, in the last frame; tests want none
    int tool_bar_rows = 1;        ///< that it took in the last frame
    std::string last_picture, last_state; ///< files
    int inputs = 0;           ///< keys that were pressed so far; tests wait for theirs to be taken
    double cancel_ms = -1;    ///< from the last cancel to its answer; negative: none yet

    PaneSet &panes() { return pane_sets[pane_set_of(layout)]; }
    const PaneSet &panes() const { return pane_sets[pane_set_of(layout)]; }
    bool has_own_cameras() const { return cameras_unlinked && n_places(layout) > 1; }
    const Camera &camera_of(int pane) const { return has_own_cameras() ? pane_cameras[static_cast<std::size_t>(pane)] : camera; }
    Camera &camera_of(int pane) { return has_own_cameras() ? pane_cameras[static_cast<std::size_t>(pane)] : camera; }
    const Camera &active_camera() const { return camera_of(panes().active); }
    bool has_own_tones() const { return tones_unlinked && n_places(layout) > 1; }
    bool has_own_steps() const { return steps_unlinked && n_panes(layout) > 1; }
    /// The position that a pane was asked to go to.
    int asked_position(int pane) const {
        return has_own_steps() && pane != panes().active ? pane_positions[static_cast<std::size_t>(pane)] : position;
    }
    Tone tone_of(int pane) const {
        if (has_own_tones() && pane != panes().active)
            return pane_tones[static_cast<std::size_t>(pane)];
        return {look.exposure_ev, look.range, look.error_range, chosen_range.has_value(), truth.range_locked};
    }
    /// The look with what the layout makes of it: a difference has its own.
    Look shown_look() const {
        return layout == Layout::difference ? look_at({panes().strategies[0], panes().strategies[1]}, look) : look;
    }
    Look look_of(int pane) const { return has_own_tones() ? with_tone(shown_look(), tone_of(pane)) : shown_look(); }
    Strategy strategy_of(int pane) const { return panes().strategies[static_cast<std::size_t>(pane)]; }
    Strategy active_strategy() const { return strategy_of(panes().active); }
    const Timeline &timeline(Strategy s) const { return timelines[static_cast<std::size_t>(s)]; }
    Timeline &timeline(Strategy s) { return timelines[static_cast<std::size_t>(s)]; }
    /// The strategies of the panes, from the upper left, row by row.
    std::vector<Strategy> shown() const {
        const auto &all = panes().strategies;
        return {all.begin(), all.begin() + n_panes(layout)};
    }
    /// Those that `position` is asked of.
    std::vector<Strategy> stepping() const { return has_own_steps() ? std::vector{active_strategy()} : shown(); }
    /// Where the active pane stands: short of `position` while that is being computed, or where its course ends sooner.
    int shown_position() const { return std::clamp(position, 0, std::max(0, timeline(active_strategy()).last())); }
    /// Of a pane's strategy, where the pane stands; null before anything is known.
    std::shared_ptr<const Snapshot> solution(int pane) const {
        const Timeline &course = timeline(strategy_of(pane));
        const auto &before = objects.shown_before[static_cast<std::size_t>(pane)];
        const bool stands_in = before && before->options.strategy == strategy_of(pane) && !course.reached(asked_position(pane));
        return stands_in ? before : course.at(asked_position(pane));
    }
    std::shared_ptr<const Snapshot> active_solution() const { return solution(panes().active); }
    /// What panes show: where we stand, or stood before the last step while that is asked for.
    bool shows_before() const { return before_by_key || before_by_mouse; }
    Place shown_place(int pane) const; // split_verbs.cpp
    bool reconstructs(int pane) const {
        return panes().reconstructed[static_cast<std::size_t>(pane)] && is_constant(strategy_of(pane));
    }
    /// What a pane shows: its strategy's solution, or what was reconstructed from it, if that is wanted and there.
    std::shared_ptr<const Snapshot> shown_snapshot(int pane) const {
        const Place place = shown_place(pane);
        const auto found_there = place.position == asked_position(pane) ? solution(pane) : timeline(strategy_of(pane)).at(place.position);
        if (!found_there)
            return found_there;
        if (!reconstructs(pane)) {
            const auto found = split_snapshots.find(version_of(*found_there, {place.split, place.linking}));
            return found == split_snapshots.end() ? found_there : found->second;
        }
        const auto found = reconstructions.find(found_there->version);
        return found == reconstructions.end() ? found_there : found->second;
    }
    /// Whether it shows constants until they are reconstructed.
    bool awaits_reconstruction(int pane) const {
        const auto shown = shown_snapshot(pane);
        return shown && reconstructs(pane) && !shown->reconstructed && !halted;
    }
    /// What all panes show, without those of which nothing is known yet.
    std::vector<std::shared_ptr<const Snapshot>> shown_snapshots() const {
        std::vector<std::shared_ptr<const Snapshot>> all;
        for (int pane = 0; pane < n_panes(layout); ++pane)
            if (auto one = shown_snapshot(pane))
                all.push_back(std::move(one));
        return all;
    }
};

} // namespace penumbra
