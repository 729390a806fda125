#include "window/viewer.h"

#include "action.h"
#include "bookmark_verbs.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/resident_memory.h"
#include "files/state_text.h"
#include "gl/context_lost.h"
#include "history.h"
#include "keyhole_verbs.h"
#include "pane_verbs.h"
#include "panels/panels.h"
#include "profile_verbs.h"
#include "restore.h"
#include "shelf_verbs.h"
#include "split_verbs.h"
#include "truth_verbs.h"
#include "verbs.h"
#include "window/cut.h"
#include "window/display_end.h"
#include "window/end_signal.h"
#include "window/save_state.h"
#include "window/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <utility>

namespace penumbra {

namespace {

constexpr double text_height = 15; ///< screen coordinates at scale 1
/// ImGui may need one frame for the press of a button, one for its release, and one more for what follows from it.
constexpr int frames_to_settle = 4;
constexpr double fresh_seconds = 2.5; ///< how long new patches stand out
constexpr double rest_seconds = 0.15; ///< after the last move of the camera the panes are drawn at their best

AppState first_state(const ViewerSetup &setup) {
    AppState state;
    state.options = setup.options;
    state.asked_tolerance = setup.options.tolerance.value_or(state.asked_tolerance);
    state.bundled_scenes = setup.bundled_scenes;
    state.scene = setup.file.scene;
    state.objects.original = setup.file.original ? setup.file.original : setup.file.scene;
    state.objects.moves = setup.file.moves;
    state.inert = setup.inert;
    state.pane_sets[0].strategies[0] = setup.options.strategy;
    if (setup.file.state)
        restore(state, *setup.file.state);
    return state;
}

double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

/// The sooner of two waits, of which a negative one is endless.
double sooner(double a, double b) { return a < 0 ? b : b < 0 ? a : std::min(a, b); }

} // namespace

Viewer::Viewer(ViewerSetup setup)
    : setup_(std::move(setup)), state_(first_state(setup_)),
      window_("Penumbra", setup_.width, setup_.height,
              {[this](const std::string &key) { on_key(key); },
               [this](const std::string &file) { state_.open_request = file; },
               [this](const std::string &key) { release_key(key, state_); }}),
      worker_(setup_.read_file, GlfwWindow::wake), checker_(GlfwWindow::wake), judge_(GlfwWindow::wake) {
    ImGui::GetIO().UserData = &state_; // for tooltips
    keeper_.begin(state_, setup_.file.state.has_value(), setup_.script.has_value() || setup_.inert);
    keeper_.note_opened(state_, setup_.file_name);
    if (!setup_.record.empty())
        begin_record();
    if (!setup_.frame_times.empty())
        frame_times_.emplace(setup_.frame_times);
    if (setup_.script)
        script_.emplace(std::move(*setup_.script));
}

/// From a window that knows nothing of how people have theirs.
void Viewer::begin_record() {
    AppState fresh;
    fresh.options.threshold = paper_threshold;
    fresh.phases_per_second = 0; // told in any case, and so is the background
    if (setup_.state_in_file) {
        restore(fresh, *setup_.state_in_file);
        fresh.objects.moves = setup_.file.moves;
    }
    fresh.look.theme = state_.look.theme == Theme::dark ? Theme::light : Theme::dark;
    try {
        recorder_.emplace(setup_.record, setup_.file_name, fresh, state_);
    } catch (const Unavailable &e) {
        throw Unavailable(std::string("--record: ") + e.what());
    }
}

ViewerEnd Viewer::run() {
    const EndSignal signal(GlfwWindow::wake);
    const DisplayEnd display_end([this] {
        keeper_.leave_autosave(state_);
        return rescue();
    });
    try {
        show_until_closed(signal);
    } catch (const Unavailable &e) {
        keeper_.leave_autosave(state_);
        throw Unavailable(e.what() + ("; " + rescue()));
    }
    keeper_.end(state_);
    return signal.seen() == 0 ? ViewerEnd{} : ViewerEnd{signal.seen(), rescue()};
}

void Viewer::show_until_closed(const EndSignal &signal) {
    while (!state_.quit_request && !window_.should_close() && signal.seen() == 0) {
        window_.wait(frames_owed_ > 0 ? 0 : wait_time());
        take_reports();
        keep_memory_limit();
        serve_requests();
        if (window_.take_touched() || window_.has_input_waiting())
            frames_owed_ = frames_to_settle;
        if (state_.busy || state_.playing || state_.pictures.drawn)
            frames_owed_ = std::max(frames_owed_, 1);
        play_script();
        if (frames_owed_ <= 0)
            continue;
        --frames_owed_;
        draw_frame();
        if (has_lost_context())
            throw Unavailable("the graphics driver has lost what the window draws with");
        serve_requests();
        write_state();
    }
    if (recorder_)
        recorder_->note(state_, Clock::now(), false);
    if (frame_times_)
        frame_times_->write();
}

/// A line at a time, when what the line before has changed was drawn.
void Viewer::play_script() {
    if (!script_ || frames_owed_ > 0)
        return;
    const int line = state_.script.line;
    script_->play(state_);
    if (state_.script.line != line || !state_.script.playing || !at_rest(state_))
        frames_owed_ = frames_to_settle;
    if (!state_.script.playing)
        script_.reset();
}

bool Viewer::has_lost_context() const {
    const bool stepped = state_.position > 0 && state_.timeline(state_.active_strategy()).reached(state_.position);
    return gl::context_is_lost() || (setup_.lose_context && stepped);
}

/// Keeps what was shown, and says where.
std::string Viewer::rescue() const {
    try {
        const std::string file = rescue_state(state_).string();
        return "what it showed is kept: penumbra view " + file;
    } catch (const std::exception &e) {
        return std::string("what it showed could not be kept: ") + e.what();
    }
}

void Viewer::on_key(const std::string &key) {
    ++state_.inputs;
    if (const Action *action = action_on_key(key))
        penumbra::run(*action, state_);
}

void Viewer::take_reports() {
    for (const Report &report : worker_.take_reports()) {
        if (std::holds_alternative<Stopped>(report) && cancelled_at_)
            state_.cancel_ms = 1e3 * seconds_since(*std::exchange(cancelled_at_, std::nullopt));
        take_report(report);
        if (std::holds_alternative<Stopped>(report) && std::exchange(over_memory_limit_, false))
            state_.message = {fmt::format("The memory limit of {:g} MiB stopped the solver; this is the last complete state.",
                                          *setup_.memory_limit),
                              true};
        frames_owed_ = frames_to_settle;
    }
    for (const TruthReport &report : judge_.take_reports()) {
        apply(state_, report);
        frames_owed_ = frames_to_settle;
    }
    for (const CheckReport &report : checker_.take_reports()) {
        apply(state_, report);
        frames_owed_ = frames_to_settle;
    }
}

void Viewer::take_report(const Report &report) {
    const bool by_line = state_.to_restore.has_value(); // a bookmark in another scene
    const Scripted before = recorder_ ? scripted(state_) : Scripted();
    apply(state_, report);
    const auto *opened = std::get_if<Opened>(&report);
    if (recorder_ && opened)
        recorder_->note_opened(opened->name, by_line, before, state_);
    else if (recorder_ && std::holds_alternative<Stopped>(report))
        recorder_->note_stopped();
    else if (recorder_)
        recorder_->follow(before, state_);
    if (opened)
        keeper_.note_opened(state_, opened->name);
}

/// Passes on to the workers what the actions have asked for.
void Viewer::serve_requests() {
    if (auto name = std::exchange(state_.open_request, std::nullopt)) {
        state_.opening = *name;
        worker_.open(std::move(*name));
        frames_owed_ = frames_to_settle;
    }
    if (const auto text = std::exchange(state_.copy_request, std::nullopt))
        ImGui::SetClipboardText(text->c_str());
    if (std::exchange(state_.paste_request, false)) {
        const char *text = ImGui::GetClipboardText();
        use_view_text(state_, text ? text : "");
        frames_owed_ = frames_to_settle;
    }
    if (std::exchange(state_.state_request, false)) {
        save_state(state_);
        frames_owed_ = frames_to_settle;
    }
    if (std::exchange(state_.discard_request, false))
        keeper_.discard(state_);
    if (std::exchange(state_.cancel_request, false)) {
        cancelled_at_ = Clock::now();
        worker_.cancel();
        aimed_.reset();
    }
    if (std::exchange(state_.shelf.stop_request, false))
        checker_.stop();
    if (std::exchange(state_.shelf.check_request, false))
        checker_.start(hard_cases(), state_.options.threads);
    if (TruthGoal now = truth_goal(state_); !(now == judging_)) {
        judging_ = now;
        judge_.aim(std::move(now));
    }
    if (auto now = goal(state_); now && now != aimed_) {
        aimed_ = now;
        worker_.aim(std::move(*now));
    }
}

/// Looked at whenever the window wakes, which is every tenth of a second while the solver is busy. The start is shown in any
/// case.
void Viewer::keep_memory_limit() {
    const bool shows_something = state_.active_solution() != nullptr;
    if (!setup_.memory_limit || !state_.busy || state_.halted || !shows_something ||
        resident_mib() <= *setup_.memory_limit)
        return;
    state_.cancel_request = state_.halted = over_memory_limit_ = true;
    state_.playing = false;
}

/// How long nothing will change unless an event comes; negative: for ever.
double Viewer::wait_time() {
    const bool played = state_.playing;
    double wait = advance_play(state_, Clock::now());
    serve_requests();
    if (played != state_.playing)
        frames_owed_ = frames_to_settle;
    const std::string said = state_.message.text;
    wait = sooner(wait, keeper_.keep(state_, Clock::now()));
    if (said != state_.message.text)
        frames_owed_ = frames_to_settle;
    if (state_.busy)
        wait = sooner(wait, 0.1); // its clock runs
    if (script_)
        wait = sooner(wait, 0.02);
    if (state_.pictures.drawn)
        wait = 0;
    if (state_.look.emphasise_fresh) {
        const double left = fresh_seconds - seconds_since(state_.fresh_since);
        if (left > 0)
            wait = sooner(wait, left + 0.01);
        else if (left > -0.1)
            frames_owed_ = std::max(frames_owed_, 1);
    }
    if (const double left = crossing_glows(state_, Clock::now()); left > 0)
        wait = sooner(wait, left + 0.01);
    else if (drawn_spotlight_ != spotlight(state_))
        frames_owed_ = std::max(frames_owed_, 1);
    if (canvas_.draft()) {
        if (const double left = rest_seconds - seconds_since(moved_at_); left > 0)
            wait = sooner(wait, left);
        else
            frames_owed_ = std::max(frames_owed_, 1);
    }
    return frames_owed_ > 0 ? 0 : wait;
}

void Viewer::set_first_view() {
    const auto snapshot = state_.active_solution();
    // A view that nobody has touched follows the pane's shape.
    const bool fits = state_.camera_moved || std::abs(state_.pane_aspect / state_.first_aspect - 1) < 0.01;
    if ((state_.camera_is_set && fits) || !snapshot || !state_.scene)
        return;
    state_.camera = first_view(*state_.scene, *snapshot, state_.pane_aspect);
    state_.first_aspect = state_.pane_aspect;
    state_.camera_is_set = true;
    state_.camera_moved = false;
    state_.pivot.reset();
}

/// Whether the camera, or the mouse from curve to curve, has moved a moment ago.
bool Viewer::is_moving() {
    std::array<Camera, 4> cameras;
    for (int pane = 0; pane < 4; ++pane)
        cameras[static_cast<std::size_t>(pane)] = state_.camera_of(pane);
    if (drawn_cameras_ != cameras || drawn_spotlight_ != spotlight(state_)) {
        if (drawn_cameras_) // the first view comes at rest
            moved_at_ = Clock::now();
        drawn_cameras_ = cameras;
        drawn_spotlight_ = spotlight(state_);
    }
    return seconds_since(moved_at_) < rest_seconds;
}

/// A pane's look as it is drawn now: what is new stands out for a moment only.
Look Viewer::look_now(int pane) const {
    Look look = state_.look_of(pane);
    look.emphasise_fresh = look.emphasise_fresh && seconds_since(state_.fresh_since) < fresh_seconds;
    look.spotlight = spotlight(state_);
    return look;
}

void Viewer::update_fonts() {
    const double scale = state_.ui_scale * window_.content_scale(), ratio = window_.pixel_ratio();
    const auto height = static_cast<float>(std::round(text_height * scale));
    if (fonts_scale_ != scale * ratio) {
        window_.replace_fonts([&] { fonts_ = load_fonts(static_cast<float>(std::round(text_height * scale * ratio))); });
        ImGui::GetIO().FontGlobalScale = static_cast<float>(1 / ratio);
        fonts_.size = height;
        fonts_scale_ = scale * ratio;
        theme_.reset();
    }
    if (theme_ != state_.look.theme) {
        set_theme(state_.look.theme, height);
        theme_ = state_.look.theme;
    }
}

void Viewer::draw_frame() {
    if (frame_times_)
        frame_times_->begin();
    update_fonts();
    window_.begin_frame();
    keeper_.note_frame();
    state_.widgets.clear();
    state_.cut.clear();
    state_.told = {};
    bring_splits(state_);
    if (!state_.panels_hidden)
        draw_menu_bar(state_);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float top = state_.panels_hidden ? 0 : std::ceil(ImGui::GetFrameHeight()); // whole pixels
    const Arrangement arrangement = arrange(
        state_, size.x, size.y, top, ImGui::GetFontSize(), [this](float width) { return legend_height(width); });
    state_.pane_aspect = static_cast<double>(arrangement.pane[0].width / arrangement.pane[0].height);
    set_first_view();
    update_ranges(state_);
    update_error_ranges(state_);
    update_profile(state_);
    draw_panels(arrangement);
    set_first_view(); // where a panel has asked for it

    const bool moving = is_moving() && !state_.picture_request;
    int width = 0, height = 0;
    window_.framebuffer_size(width, height);
    if (width > 0 && height > 0)
        canvas_.draw(state_, {look_now(0), look_now(1), look_now(2), look_now(3)}, arrangement, width, height, window_.pixel_ratio(), moving);
    window_.draw_interface();
    take_pictures();
    window_.swap();
    if (frame_times_)
        frame_times_->end(state_.busy.has_value(), moving);
}

float Viewer::legend_height(float width) const {
    const std::vector<std::shared_ptr<const Snapshot>> kept = state_.shown_snapshots();
    std::vector<const Snapshot *> snapshots;
    for (const auto &snapshot : kept)
        snapshots.push_back(snapshot.get());
    return line_legend_size(fonts_, width, state_.look, snapshots).y;
}

void Viewer::draw_panels(const Arrangement &arrangement) {
    draw_panes(state_, arrangement, fonts_);
    if (!state_.panels_hidden) {
        draw_tool_bar(state_, arrangement.tool_bar);
        draw_side_panel(state_, arrangement.side);
        draw_inspector(state_, arrangement.inspector, fonts_);
        draw_profile_panel(state_, arrangement.profile, fonts_);
        draw_transport(state_, arrangement.transport);
        draw_status_bar(state_, arrangement.status);
    }
    draw_hint(state_, arrangement.panes);
    WindowRect scene = arrangement.panes;
    scene.height -= arrangement.legend.height;
    draw_caption(state_, scene);
    draw_error(state_, arrangement.panes);
    draw_tour(state_, arrangement);
    draw_offer(state_, arrangement.panes);
    draw_open_dialog(state_);
    draw_picture_settings(state_);
    draw_help(state_);
    draw_palette(state_);
    if (!setup_.state_file.empty())
        std::ranges::move(cut_windows(), std::back_inserter(state_.cut));
    const bool held = ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive();
    if (!held)
        note_changes(state_, Clock::now());
    if (recorder_)
        recorder_->note(state_, Clock::now(), held);
}

void Viewer::take_pictures() {
    const auto request = std::exchange(state_.picture_request, std::nullopt);
    int width = 0, height = 0;
    window_.framebuffer_size(width, height);
    if (request)
        photographer_.take(state_, *request, width, height);
    else if (!photographer_.go_on(state_, width, height))
        return;
    if (!state_.pictures.drawn) // else it goes on with the next frame
        frames_owed_ = frames_to_settle;
}

void Viewer::write_state() {
    if (setup_.state_file.empty() || frames_owed_ > 0 || canvas_.draft())
        return;
    std::string text = observed_state_text(state_);
    if (text == written_state_)
        return;
    write_atomically(setup_.state_file, text);
    written_state_ = std::move(text);
}

} // namespace penumbra
