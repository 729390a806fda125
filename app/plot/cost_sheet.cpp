#include "plot/cost_sheet.h"

#include "core/percent.h"
#include "plot/cost_measure.h"
#include "plot/strategy_style.h"
#include "study/spread.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace penumbra {

namespace {

constexpr std::array<CostMeasure, 4> prices{CostMeasure::seconds, CostMeasure::patches, CostMeasure::coefficients,
                                            CostMeasure::kernel_evaluations};

/// Seconds are those of the repeats; all else is the same in each.
Spread price_of(const CostPoint &p, CostMeasure measure) {
    if (measure == CostMeasure::seconds)
        return spread_of(p.seconds);
    const double x = value(measure, p.counters);
    return {x, x, x};
}

bool is_mark(const CostPoint &p) { return p.done() && p.error > 0; }
/// Tried, and not brought to an end; or so good that a logarithm cannot show it.
bool is_cross(const CostPoint &p) {
    return !is_mark(p) && p.end != RunEnd::not_tried && p.end != RunEnd::interrupted;
}

LogAxis error_axis(const CostStudy &study) {
    AxisRange range;
    for (const CostPoint &p : study.points)
        if (is_mark(p) || is_cross(p))
            range.add(p.error);
    return range.axis(PlotUnit::share);
}

LogAxis price_axis(const CostStudy &study, CostMeasure price) {
    AxisRange range;
    for (const CostPoint &p : study.points)
        if (is_mark(p)) {
            const Spread s = price_of(p, price);
            range.add(s.low);
            range.add(s.high);
        }
    return range.axis(unit(price));
}

/// A curve for each strategy in each basis; points of one stand together.
std::vector<PlotCurve> curves_of(const CostStudy &study, CostMeasure price, bool full_names, Theme theme) {
    std::vector<PlotCurve> curves;
    const CostPoint *last = nullptr;
    std::set<Strategy> named;
    for (const CostPoint &p : study.points) {
        const Strategy strategy = p.options.strategy;
        if (!last || last->options.strategy != strategy || last->options.basis != p.options.basis) {
            PlotCurve curve{strategy_colour(strategy, theme), strategy_marker(strategy), is_dashed(p.options.basis),
                            true, "", {}, {}};
            if (named.insert(strategy).second) {
                const std::string label = strategy_label(strategy, p.options.order);
                curve.label = full_names ? label : label.substr(0, label.find(' '));
            }
            curves.push_back(std::move(curve));
        }
        last = &p;
        if (is_mark(p)) {
            const Spread s = price_of(p, price);
            curves.back().marks.push_back({s.median, p.error, s.low, s.high, p.counters.nodes_at_limit > 0, false});
        } else if (is_cross(p)) {
            curves.back().stopped.push_back(p.error);
        }
    }
    return curves;
}

std::string counted(std::ptrdiff_t n, const char *one, const char *many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// "2 met the time limit of 2 s"; of each way to end that occurs.
std::string ends_in_words(const CostStudy &study) {
    const auto n = [&](RunEnd end) { return std::ranges::count(study.points, end, &CostPoint::end); };
    std::string words;
    const auto add = [&](RunEnd end, const std::string &what) {
        if (n(end) > 0)
            words += fmt::format("{}{} {}", words.empty() ? "" : ", ", n(end), what);
    };
    add(RunEnd::time_limit, fmt::format("met the time limit of {:g} s", study.limits.seconds.value_or(0)));
    add(RunEnd::memory_limit, fmt::format("met the memory limit of {:g} MiB", study.limits.memory_mib.value_or(0)));
    add(RunEnd::not_converged, "did not reach the fixed point");
    add(RunEnd::failed, "failed");
    add(RunEnd::not_tried, "with finer thresholds were not tried after that");
    add(RunEnd::interrupted, "were interrupted");
    return words;
}

bool has_basis(const CostStudy &study, BasisFamily basis) {
    return std::ranges::any_of(study.points, [&](const CostPoint &p) { return p.options.basis == basis; });
}

} // namespace

std::array<Plot, 4> cost_plots(const CostStudy &study, Theme theme) {
    std::array<Plot, 4> plots;
    const LogAxis error = error_axis(study);
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const CostMeasure price = prices[i];
        plots[i] = {std::string(title(price)), "relative L2 error", price_axis(study, price), error, i == 0,
                    curves_of(study, price, i == 0, theme)};
    }
    return plots;
}

std::vector<std::string> cost_notes(const CostStudy &study) {
    std::vector<std::string> notes;
    std::string styles = "Further left is cheaper, further down is more accurate.";
    if (has_basis(study, BasisFamily::parametric) && has_basis(study, BasisFamily::planar))
        styles += " Solid: quads (parametric basis); dashed: convex polygons (planar basis).";
    if (study.repeats > 1)
        styles += fmt::format(" Seconds: median of {} runs, whiskers from the fastest to the slowest.", study.repeats);
    if (std::ranges::any_of(study.points, [](const CostPoint &p) { return is_mark(p) && p.counters.nodes_at_limit > 0; }))
        styles += " Hollow: patches met the depth limit.";
    if (study.reference_error > 0)
        styles += fmt::format(" Errors against a reference, itself about {} off.", percent(study.reference_error));
    notes.push_back(styles);
    if (const std::string ends = ends_in_words(study); !ends.empty()) {
        const bool crosses = std::ranges::any_of(study.points, is_cross);
        notes.push_back((crosses ? "\u00d7 on the right border: not brought to an end, at the error so far. Of " : "Of ") +
                        counted(std::ssize(study.points), "solution ", "solutions ") + ends + ".");
    }
    notes.push_back(fmt::format("{}; {}{} of {}; Penumbra {}", study.scene, study.cpu.empty() ? "" : study.cpu + ", ",
                                counted(study.threads, "thread", "threads"), counted(study.cores, "core", "cores"),
                                study.version));
    return notes;
}

void draw_cost_sheet(Canvas &canvas, glm::vec2 size, const CostStudy &study, const PlotLook &look) {
    const float em = look.text;
    const std::vector<std::string> notes = cost_notes(study);
    PlotText heading{1.25f * em, plot_ink(look.theme), TextAlign::left, true};
    canvas.text({em, 1.4f * em}, "What accuracy costs: " + study.scene, heading);
    const float bottom = size.y - (1.35f * static_cast<float>(notes.size()) + 0.6f) * em, top = 2.2f * em;
    const auto plots = cost_plots(study, look.theme);
    // The first one has numbers along its axis, too; between the axes all are as wide.
    const float extra = 3.6f * em, width = (size.x - extra - 0.6f * em) / static_cast<float>(plots.size());
    float x = 0.3f * em;
    for (const Plot &plot : plots) {
        const float to = x + width + (plot.y_words ? extra : 0);
        draw_plot(canvas, {{x, top}, {to, bottom}}, plot, look);
        x = to;
    }
    float y = bottom + 0.8f * em;
    for (const std::string &note : notes) {
        canvas.text({em, y}, note, {0.92f * em, plot_ink(look.theme, 0.8f), TextAlign::left, false});
        y += 1.35f * em;
    }
}

} // namespace penumbra
