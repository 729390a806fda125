#include "recorder.h"

#include "action.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "script.h"
#include "script_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace penumbra {

namespace {

constexpr double shortest_pause = 0.5; ///< [s]
constexpr double one_movement = 1;     ///< views that follow each other sooner are one movement [s]

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

bool is_view(std::string_view line) { return line.starts_with("show --camera "); }

/// Lines that ask for a place in the course of the solution.
bool asks_for_place(std::string_view line) {
    constexpr std::string_view asks[] = {"go ",        "play",           "solve.step",     "solve.sub_step", "solve.back", "solve.sub_back",
                                         "solve.split", "solve.link", "solve.next_cut", "solve.reset", "solve.end"};
    return std::ranges::any_of(asks, [&](std::string_view ask) { return line.starts_with(ask); });
}

/// "solve.step" once more: "solve.step 2".
std::string once_more(const std::string &line, std::string_view id) {
    const int times = line.size() == id.size() ? 1 : std::stoi(line.substr(id.size() + 1));
    return fmt::format("{} {}", id, times + 1);
}

/// The action alone, or with how often.
bool does(const std::string &line, std::string_view id) {
    return line.starts_with(id) && (line.size() == id.size() || line[id.size()] == ' ');
}

/// The scene alone, where the state that brought it will be gone.
std::string scene_of(const AppState &state) {
    const std::string file = place_of(*state.scene, "/");
    return file.empty() ? state.scene->name : file;
}

/// What a scene leaves as it was, and what it begins with.
Scripted just_opened(Scripted s) {
    Parameters &p = s.set;
    p.moves.clear();
    p.look.range.reset();
    p.look.error_range.reset();
    p.look.curve_filter.source = -1;
    p.camera.reset();
    p.keyhole.reset();
    p.profile.reset();
    p.pinned_curve.reset();
    s.place = {};
    s.playing = false;
    s.element = s.split = {};
    s.outward = s.piece = 0;
    s.source.reset();
    s.object = -1;
    return s;
}

} // namespace

std::string lasting_name(const std::string &name) {
    std::error_code none;
    return std::filesystem::exists(name, none) ? std::filesystem::absolute(name).lexically_normal().string() : name;
}

Recorder::Recorder(std::filesystem::path file, const std::string &opened, const AppState &fresh, AppState &now)
    : file_(std::move(file)), known_(scripted(fresh)), quiet_since_(Clock::now()) {
    lines_ = {"# Recorded by penumbra " PENUMBRA_VERSION "; penumbra view --script does it again, Esc stops it.",
              "open " + lasting_name(opened)};
    const Scripted shown = scripted(now);
    std::ranges::move(lines_between(known_, shown), std::back_inserter(lines_));
    known_ = shown;
    keep(now);
    if (ended_)
        throw Unavailable(now.message.text);
    now.recording = true;
}

void Recorder::note(AppState &state, Clock::time_point now, bool held) {
    for (const Deed &deed : std::exchange(state.deeds, {}))
        write_deed(deed, state, now);
    if (std::exchange(stopped_, false))
        forget_asked();
    if (held) {
        quiet_since_ = now;
        return;
    }
    Scripted shown = scripted(state);
    if (state.playing)
        shown.place = known_.place; // until it pauses
    write_lines(lines_between(known_, shown), state, now);
    known_ = std::move(shown);
    if (at_rest(state))
        rested_ = lines_.size();
    else
        quiet_since_ = now;
}

void Recorder::write_deed(const Deed &deed, AppState &state, Clock::time_point now) {
    const bool by_effect = deed.action->by_effect || (!deed.rested && deed.before->place != deed.after->place);
    if (by_effect)
        return;
    write_lines(lines_between(known_, *deed.before), state, now);
    known_ = *deed.after;
    const std::string id(deed.action->id);
    if (seconds(now - quiet_since_) < shortest_pause && does(lines_.back(), id)) {
        lines_.back() = once_more(lines_.back(), id);
        keep(state);
    } else {
        write_lines({id}, state, now);
    }
}

void Recorder::write_lines(const std::vector<std::string> &lines, AppState &state, Clock::time_point now) {
    if (lines.empty())
        return;
    const double pause = seconds(now - quiet_since_);
    const bool goes_on = lines.size() == 1 && is_view(lines.front()) && is_view(lines_.back()) && pause < one_movement;
    const bool asks_again = lines.size() == 1 && lines.front().starts_with("go ") && lines_.size() > rested_ &&
                            lines_.back().starts_with("go ");
    if (goes_on || asks_again)
        lines_.pop_back();
    else if (pause >= shortest_pause)
        lines_.push_back(fmt::format("wait {:.1f}", pause));
    std::ranges::copy(lines, std::back_inserter(lines_));
    quiet_since_ = now;
    keep(state);
}

/// Played again it would be gone all the way.
void Recorder::forget_asked() {
    const auto from = lines_.begin() + static_cast<std::ptrdiff_t>(std::min(rested_, lines_.size()));
    lines_.erase(std::remove_if(from, lines_.end(), asks_for_place), lines_.end());
    known_.place.position = -1; // whatever it has come to is a place of its own
}

void Recorder::follow(const Scripted &before, AppState &state) { penumbra::follow(known_, before, scripted(state)); }

void Recorder::note_opened(const std::string &name, bool by_line, const Scripted &before, AppState &state) {
    const auto now = Clock::now();
    for (const Deed &deed : std::exchange(state.deeds, {}))
        write_deed(deed, state, now);
    const Scripted shown = scripted(state);
    if (!by_line) {
        write_lines(lines_between(known_, before), state, now);
        const bool passing = std::ranges::find(state.orphans, name) != state.orphans.end();
        write_lines({"open " + (passing ? scene_of(state) : lasting_name(name))}, state, now);
        if (passing)
            write_lines(lines_between(just_opened(before), shown), state, now);
    }
    known_ = shown;
}

void Recorder::keep(AppState &state) {
    if (ended_)
        return;
    std::string text;
    for (const std::string &line : lines_)
        text += line + "\n";
    try {
        write_atomically(file_, text);
    } catch (const Unavailable &e) {
        ended_ = true;
        state.recording = false;
        state.message = {std::string(e.what()) + "; the record has ended.", true};
    }
}

} // namespace penumbra
