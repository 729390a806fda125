#include "plot/axes.h"

#include <algorithm>

namespace penumbra {

glm::vec4 plot_ink(Theme theme, float opacity) {
    return theme == Theme::dark ? glm::vec4(0.93f, 0.94f, 0.96f, opacity) : glm::vec4(0.07f, 0.08f, 0.1f, opacity);
}

int labels_in(float length, float each) { return std::max(2, static_cast<int>(length / each)); }

void draw_axes(Canvas &canvas, const PlotBox &box, const AxisMarks &x, const AxisMarks &y, const PlotLook &look) {
    const float em = look.text;
    const auto grid = [&](const Tick &t) {
        return PlotStroke{plot_ink(look.theme, t.major ? 0.16f : 0.06f), 0.06f * em};
    };
    const auto words = [&](TextAlign align) { return PlotText{em, plot_ink(look.theme, 0.85f), align, false}; };
    for (std::size_t i = 0; i < x.ticks.size(); ++i) {
        const float at = box.low.x + static_cast<float>(x.places[i]) * box.width();
        canvas.line({at, box.low.y}, {at, box.high.y}, grid(x.ticks[i]));
        if (x.words)
            canvas.text({at, box.high.y + 0.9f * em}, x.ticks[i].label, words(TextAlign::centre));
    }
    for (std::size_t i = 0; i < y.ticks.size(); ++i) {
        const float at = box.high.y - static_cast<float>(y.places[i]) * box.height();
        canvas.line({box.low.x, at}, {box.high.x, at}, grid(y.ticks[i]));
        if (y.words)
            canvas.text({box.low.x - 0.5f * em, at}, y.ticks[i].label, words(TextAlign::right));
    }
    const PlotStroke axis{plot_ink(look.theme, 0.7f), 0.08f * em};
    canvas.line({box.low.x, box.low.y}, {box.low.x, box.high.y}, axis);
    canvas.line({box.low.x, box.high.y}, {box.high.x, box.high.y}, axis);
    PlotText title{em, plot_ink(look.theme), TextAlign::centre, false};
    if (x.words)
        canvas.text({(box.low.x + box.high.x) / 2, box.high.y + 2.3f * em}, x.title, title);
    title.align = TextAlign::left;
    if (y.words)
        canvas.text({box.low.x - 4.2f * em, box.low.y - 1.1f * em}, y.title, title);
}

} // namespace penumbra
