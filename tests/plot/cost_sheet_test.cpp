// From a study to its four plots and the sentences below them.
#include "made_up_study.h"

#include "plot/cost_sheet.h"
#include "plot/svg_canvas.h"

#include <gmock/gmock.h>

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(CostSheet, PlotsShareTheErrorAndDifferInThePrice) {
    const CostStudy study = made_up_study();
    const auto plots = cost_plots(study, Theme::light);
    for (const Plot &plot : plots) {
        EXPECT_EQ(plot.y.low, plots[0].y.low);
        EXPECT_EQ(plot.y.high, plots[0].y.high);
        ASSERT_EQ(plot.curves.size(), 8U);
        for (const PlotCurve &curve : plot.curves)
            for (const PlotMark &m : curve.marks) {
                EXPECT_GT(plot.x.place(m.x_low), 0);
                EXPECT_LT(plot.x.place(m.x_high), 1);
                EXPECT_GT(plot.y.place(m.y), 0);
                EXPECT_LT(plot.y.place(m.y), 1);
            }
    }
    const CostPoint &first = study.points.front();
    EXPECT_EQ(plots[1].curves[0].marks[0].x, first.counters.patches);
    EXPECT_EQ(plots[2].curves[0].marks[0].x, first.counters.coefficients);
    EXPECT_EQ(plots[3].curves[0].marks[0].x, first.counters.total_work.kernel_evaluations);
    EXPECT_EQ(plots[0].curves[0].marks[0].x, 0.0125) << "the median of 0.01, 0.0125 and 0.02";
    EXPECT_DOUBLE_EQ(plots[0].curves[0].marks[0].x_high, 0.02);
    EXPECT_EQ(plots[0].y_words, true);
    EXPECT_EQ(plots[1].y_words, false);
}

TEST(CostSheet, RunsThatWereStoppedAreCrossesAndThoseNotTriedAreNot) {
    const CostStudy study = made_up_study();
    for (const Plot &plot : cost_plots(study, Theme::light)) {
        EXPECT_EQ(plot.curves[0].marks.size(), 2U);
        EXPECT_THAT(plot.curves[0].stopped, testing::ElementsAre(0.02)) << "at the error so far";
        EXPECT_TRUE(plot.curves[7].stopped.empty());
    }
}

TEST(CostSheet, AnErrorOfZeroIsACrossAsALogarithmCannotShowIt) {
    CostStudy study = made_up_study();
    study.points.front().error = 0;
    EXPECT_EQ(cost_plots(study, Theme::light)[0].curves[0].stopped.size(), 2U);
}

TEST(CostSheet, PlanarIsDashedAndEachStrategyIsNamedOnce) {
    const auto plots = cost_plots(made_up_study(), Theme::light);
    std::vector<std::string> names, letters;
    for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_EQ(plots[0].curves[c].dashed, c % 2 == 1);
        names.push_back(plots[0].curves[c].label);
        letters.push_back(plots[2].curves[c].label);
    }
    EXPECT_THAT(names, testing::ElementsAre("(a) uniform, constant", "", "(b) cut, constant", "", "(c) uniform, M = 3", "",
                                            "(d) cut, M = 3", ""));
    EXPECT_THAT(letters, testing::ElementsAre("(a)", "", "(b)", "", "(c)", "", "(d)", ""));
}

TEST(CostSheet, NotesSayWhatWasMeasuredOnWhatAndWhatIsMissing) {
    std::string notes;
    for (const std::string &line : cost_notes(made_up_study()))
        notes += line + "\n";
    EXPECT_THAT(notes, HasSubstr("median of 3 runs"));
    EXPECT_THAT(notes, HasSubstr("dashed: convex polygons"));
    EXPECT_THAT(notes, HasSubstr("Of 32 solutions 2 met the time limit of 2 s, 2 with finer thresholds were not tried"));
    EXPECT_THAT(notes, HasSubstr("made-up; A Processor, 2 threads of 4 cores; Penumbra 1.2.3"));
    EXPECT_THAT(notes, HasSubstr("Hollow"));
}

TEST(CostSheet, NotesLeaveOutWhatDoesNotOccur) {
    CostStudy study = made_up_study();
    study.repeats = 1;
    std::erase_if(study.points, [](const CostPoint &p) {
        return p.options.basis == BasisFamily::planar || !p.done() || p.counters.nodes_at_limit > 0;
    });
    std::string notes;
    for (const std::string &line : cost_notes(study))
        notes += line + "\n";
    for (const char *words : {"median", "dashed", "Of ", "limit", "Hollow"})
        EXPECT_THAT(notes, Not(HasSubstr(words)));
}

TEST(CostSheet, AsSvgHasAllPlotsAndAllNotes) {
    SvgCanvas svg(2000, 860);
    draw_cost_sheet(svg, {2000, 860}, made_up_study(), {20, Theme::light});
    const std::string file = svg.file();
    for (const char *words : {">What accuracy costs: made-up<", ">seconds<", ">patches<", ">coefficients<",
                              ">kernel evaluations<", ">relative L2 error<"})
        EXPECT_THAT(file, HasSubstr(words));
}

} // namespace
} // namespace penumbra
