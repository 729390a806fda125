// What accuracy costs: the error against seconds or work while one steps, and the panes' work side by side.
#include "core/percent.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "plot/draw_list_canvas.h"
#include "plot/strategy_style.h"
#include "price_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <string>
#include <vector>

namespace penumbra {

namespace {

ImU32 to_imgui(const glm::vec4 &c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a}); }

const char *button_words(CostMeasure measure) {
    constexpr const char *words[] = {"seconds", "patches", "patches \u00d7 functions", "links \u00d7 coefficients",
                                     "kernel evaluations"};
    return words[static_cast<std::size_t>(measure)];
}

std::string value_words(CostMeasure measure, const Counters &counters) {
    return measure == CostMeasure::seconds ? seconds_words(counters.seconds)
                                           : count_words(static_cast<std::int64_t>(value(measure, counters)));
}

void draw_measure_choice(AppState &state) {
    std::vector<const char *> texts;
    for (const CostMeasure m : all_cost_measures)
        texts.push_back(button_words(m));
    ButtonRow row(texts);
    for (const CostMeasure m : all_cost_measures)
        if (choice(state, "cost " + std::string(name(m)), button_words(m), state.cost_measure == m,
                   std::string(sentence(m)).c_str(), row.next()))
            state.cost_measure = m;
}

/// All figures of a point.
void tell_point(const PricedState &s, bool earlier) {
    const Counters &c = s.counters;
    note_told(strategy_label(s.options.strategy, s.options.order), sentence(CostMeasure::seconds));
    ImGui::BeginTooltip();
    ImGui::TextUnformatted((strategy_label(s.options.strategy, s.options.order) +
                            (s.options.basis == BasisFamily::planar ? ", polygons" : ""))
                               .c_str());
    ImGui::TextDisabled("%s", (s.options.tolerance ? "asked for " + percent(*s.options.tolerance)
                                                   : "threshold " + percent(s.options.threshold))
                                  .c_str());
    if (ImGui::BeginTable("figures", 2, ImGuiTableFlags_SizingFixedFit)) {
        const auto row = [](const char *what, const std::string &words) {
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", what);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(words.c_str());
        };
        row("iteration", count_words(c.iteration));
        if (!s.estimated())
            row("true error", percent(s.true_error));
        if (c.estimated_error >= 0)
            row("estimated error", percent(c.estimated_error) + ", at most " + percent(c.error_bound));
        for (const CostMeasure m : all_cost_measures)
            row(button_words(m), value_words(m, c));
        row("links", count_words(c.links));
        ImGui::EndTable();
    }
    ImGui::TextDisabled(earlier ? "Of an earlier run; a click solves it again up to here." : "A click goes there.");
    ImGui::EndTooltip();
}

/// The reason why there is nothing in the plot, and what to do.
void draw_no_point(AppState &state) {
    ImGui::PushTextWrapPos(0);
    if (state.options.tolerance)
        ImGui::TextDisabled("No point yet: step on. The error is known when a state has settled.");
    else if (state.shown_position() < phases_per_iteration)
        ImGui::TextDisabled("No point yet: each step adds one for each pane.");
    else
        ImGui::TextDisabled("Light is reflected more than once here, so that the exact solution is not known. Choose "
                            "\u201ctolerance\u201d on the left: then the error is measured.");
    ImGui::PopTextWrapPos();
}

struct Found {
    const LiveRun *run = nullptr;
    const PricedState *state = nullptr;
};

/// Curves of the plot are the runs in their order, the present ones first.
Found find(const std::vector<LiveRun> &runs, const PlacedMark &mark) {
    const LiveRun &run = runs[mark.curve];
    return {&run, &run.states[mark.index]};
}

void mark_points(AppState &state, const std::vector<LiveRun> &runs, const std::vector<PlacedMark> &placed) {
    for (const PlacedMark &m : placed) {
        const Found f = find(runs, m);
        const std::string id = std::string("cost point ") + letter(f.state->options.strategy) + " " +
                               std::to_string(iteration_of(f.state->position)) + (f.run->earlier ? " earlier" : "");
        state.widgets[id] = {m.at.x - 1, m.at.y - 1, 2, 2};
    }
}

void draw_cost_plot(AppState &state, const std::vector<LiveRun> &runs, const Fonts &fonts) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = std::min(0.95f * width, em(23));
    ImGui::InvisibleButton("cost plot", {width, height});
    mark(state, "cost plot");
    DrawListCanvas canvas(*ImGui::GetWindowDrawList(), fonts);
    const Plot plot = live_cost_plot(runs, state.cost_measure, state.look.theme);
    const std::vector<PlacedMark> placed = draw_plot(canvas, {{low.x, low.y}, {low.x + width, low.y + height}}, plot,
                                                     {0.9f * fonts.size, state.look.theme});
    mark_points(state, runs, placed);
    if (!ImGui::IsItemHovered())
        return;
    const ImVec2 mouse = ImGui::GetMousePos();
    const PlacedMark *near = mark_near(placed, {mouse.x, mouse.y}, em(0.7f));
    if (!near)
        tooltip("Error against " + std::string(title(state.cost_measure)),
                "A point for each pane and step. Rest the mouse on one for its figures; a click goes back to it.");
    else {
        const Found f = find(runs, *near);
        tell_point(*f.state, f.run->earlier);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            go_to_priced(state, *f.state, f.run->earlier);
    }
}

/// What full, hollow, ringed and faint marks are, of those that occur.
void draw_key(const std::vector<LiveRun> &runs) {
    bool full = false, hollow = false, earlier = false;
    for (const LiveRun &run : runs) {
        earlier |= run.earlier;
        for (const PricedState &s : run.states)
            (s.estimated() ? hollow : full) = true;
    }
    std::string words;
    if (full)
        words += "Filled: true error, against the exact direct solution. ";
    if (hollow)
        words += "Hollow: estimated error, measured at random points. ";
    words += "Ringed: where the panes stand. ";
    if (earlier)
        words += "Faint: where runs with other options ended. ";
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", words.c_str());
    ImGui::PopTextWrapPos();
}

/// One strategy's bar by the measure, full; above it by patches, an outline.
void draw_bar(AppState &state, const Snapshot &s, double most, double most_patches) {
    const CostMeasure m = state.cost_measure;
    const glm::vec4 colour = strategy_colour(s.options.strategy, state.look.theme);
    const std::string words = value_words(m, s.counters);
    const float height = em(1.6f), label = em(1.8f), number = em(5.2f);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, room = width - label - number;
    ImGui::Dummy({width, height});
    mark(state, std::string("cost bar ") + letter(s.options.strategy));
    tooltip(std::string(title(s.options.strategy)),
            words + " " + button_words(m) + ", " + count_words(s.counters.patches) + " patches. " +
                std::string(sentence(m)));
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddText({low.x, low.y + 0.2f * em()}, to_imgui(colour), (std::string("(") + letter(s.options.strategy) + ")").c_str());
    const auto bar = [&](double share) { return low.x + label + std::max(1.f, static_cast<float>(share) * room); };
    const float x = low.x + label, top = low.y + 0.12f * height, bottom = low.y + 0.88f * height;
    list.AddRectFilled({x, top}, {bar(most > 0 ? value(m, s.counters) / most : 0), bottom}, to_imgui(colour));
    if (m != CostMeasure::patches && most_patches > 0)
        list.AddRect({x, top - 1}, {bar(s.counters.patches / most_patches), bottom + 1},
                     ImGui::GetColorU32(ImGuiCol_Text, 0.9f), 0, 0, 1.5f);
    list.AddText({low.x + width - ImGui::CalcTextSize(words.c_str()).x, low.y + 0.2f * em()}, ImGui::GetColorU32(ImGuiCol_Text),
                 words.c_str());
}

void draw_bars(AppState &state) {
    heading("Patches are not work");
    const auto snapshots = compared(state);
    double most = 0, most_patches = 0;
    for (const auto &s : snapshots) {
        most = std::max(most, value(state.cost_measure, s->counters));
        most_patches = std::max(most_patches, value(CostMeasure::patches, s->counters));
    }
    if (snapshots.size() > 1)
        for (const auto &s : snapshots)
            draw_bar(state, *s, most, most_patches);
    ImGui::PushTextWrapPos(0);
    if (snapshots.size() < 2)
        ImGui::TextDisabled("With four panes (Ctrl+4) the strategies' work stands side by side.");
    else if (state.cost_measure == CostMeasure::patches)
        ImGui::TextDisabled("By patches alone wavelets win. Choose another measure above: a patch with M = 4 may take 16 "
                            "times the effort of a constant one.");
    else
        ImGui::TextDisabled("Full: %s; outline: patches; each as a share of the largest. Where the full bar is the longer one, a "
                            "patch is dear.",
                            button_words(state.cost_measure));
    ImGui::PopTextWrapPos();
}

} // namespace

void draw_cost(AppState &state, const Fonts &fonts) {
    draw_measure_choice(state);
    const std::vector<LiveRun> runs = live_runs(state);
    if (runs.empty())
        draw_no_point(state);
    else
        draw_cost_plot(state, runs, fonts);
    if (!runs.empty())
        draw_key(runs);
    draw_bars(state);
}

} // namespace penumbra
