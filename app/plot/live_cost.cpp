#include "plot/live_cost.h"

#include "plot/strategy_style.h"

#include <set>
#include <string>

namespace penumbra {

namespace {

PlotCurve curve_of(const LiveRun &run, CostMeasure measure, Theme theme) {
    const Options &options = run.states.front().options;
    PlotCurve curve{strategy_colour(options.strategy, theme), strategy_marker(options.strategy),
                    is_dashed(options.basis), !run.earlier, "", {}, {}};
    if (run.earlier)
        curve.colour.a = 0.5f;
    for (const PricedState &s : run.states) {
        PlotMark mark;
        mark.x = value(measure, s.counters);
        mark.y = s.error();
        mark.hollow = s.estimated();
        mark.ringed = s.position == run.here;
        curve.marks.push_back(mark);
    }
    return curve;
}

} // namespace

Plot live_cost_plot(const std::vector<LiveRun> &runs, CostMeasure measure, Theme theme) {
    Plot plot{std::string(title(measure)), "relative L2 error", {}, {}, true, {}};
    AxisRange x, y;
    std::set<Strategy> named;
    for (const bool earlier : {false, true}) // labels go to the present ones
        for (const LiveRun &run : runs) {
            if (run.states.empty() || run.earlier != earlier)
                continue;
            PlotCurve curve = curve_of(run, measure, theme);
            const Options &options = run.states.front().options;
            if (named.insert(options.strategy).second)
                curve.label = strategy_label(options.strategy, options.order);
            for (const PlotMark &m : curve.marks) {
                x.add(m.x);
                y.add(m.y);
            }
            plot.curves.push_back(std::move(curve));
        }
    plot.x = x.axis(unit(measure));
    plot.y = y.axis(PlotUnit::share);
    return plot;
}

} // namespace penumbra
