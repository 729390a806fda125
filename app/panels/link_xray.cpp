// The X-ray of the links from the surface that was picked.
#include "element_verbs.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "plot/draw_list_canvas.h"
#include "plot/xray_plot.h"

#include <algorithm>
#include <string>

namespace penumbra {

namespace {

void choose_line(AppState &state, const LinkXray &xray) {
    ButtonRow lines({"through the centre", "where it misses most"});
    if (choice(state, "xray.centre", "through the centre", xray.line == XrayLine::centre,
               "The line runs through the middle of the picked element.", lines.next()))
        set_xray_line(state, XrayLine::centre);
    ImGui::BeginDisabled(xray.tests.empty());
    if (choice(state, "xray.worst", "where it misses most", xray.line == XrayLine::worst,
               "The line runs through the test point at which the fit misses most.", lines.next()))
        set_xray_line(state, XrayLine::worst);
    ImGui::EndDisabled();
}

std::string tests_words(const LinkXray &xray) {
    if (xray.tests.empty())
        return "Weak links are a constant and are not tested.";
    const auto near = std::ranges::count_if(xray.tests, &XrayTest::near);
    return std::to_string(near) + " of " + std::to_string(xray.tests.size()) + " test points lie near this line" +
           (std::ranges::any_of(xray.tests, [](const XrayTest &t) { return t.near && t.worst; }) ? "; the filled one is the worst." : ".");
}

} // namespace

void draw_xray(AppState &state, const Fonts &fonts) {
    const auto report = state.element.shown;
    if (!report || !report->xray || !picked_links(state)) {
        state.element.cursor.reset();
        return;
    }
    const LinkXray &xray = *report->xray;
    heading("X-ray of these links");
    choose_line(state, xray);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = em(17);
    ImGui::InvisibleButton("xray plot", {width, height});
    mark(state, "xray plot");
    const bool hovered = ImGui::IsItemHovered();
    DrawListCanvas canvas(*ImGui::GetWindowDrawList(), fonts);
    const XrayPlaces places = draw_xray_plot(canvas, {{low.x, low.y}, {low.x + width, low.y + height}}, xray,
                                             {0.9f * fonts.size, state.look.theme}, state.element.cursor);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    state.element.cursor = hovered ? places.place({mouse.x, mouse.y}) : std::nullopt;
    constexpr const char *channels[] = {"red", "green", "blue"};
    const bool grey = std::ranges::all_of(xray.points, [](const XrayPoint &p) {
        return (p.exact - p.exact[0]).abs().maxCoeff() <= 1e-9 * p.exact.abs().maxCoeff();
    });
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s%s", tests_words(xray).c_str(),
                        grey ? "" : (std::string(" Shown: ") + channels[xray.channel] + ", the channel that is worst.").c_str());
    ImGui::PopTextWrapPos();
}

} // namespace penumbra
