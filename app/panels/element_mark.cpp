// Over a pane: the picked element, the links that were picked, and the line of their X-ray.
#include "element_verbs.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "render/camera.h"
#include "render/link_colour.h"
#include "render/profile_mark.h"

#include <optional>
#include <vector>

namespace penumbra {

namespace {

class Pen {
public:
    Pen(const Camera &camera, ImDrawList &list, const WindowRect &pane) : camera_(camera), list_(list), pane_(pane) {}

    std::optional<ImVec2> at(const Vec3 &p) const {
        const auto place =
            place_in_frame(camera_, static_cast<double>(pane_.width / pane_.height), {p.x(), p.y(), p.z()});
        if (!place)
            return std::nullopt;
        return ImVec2(pane_.x + pane_.width * static_cast<float>(0.5 + 0.5 * place->x),
                      pane_.y + pane_.height * static_cast<float>(0.5 - 0.5 * place->y));
    }
    /// Nothing where a corner lies behind the eye.
    void outline(const std::vector<Vec3> &corners, float width, float opacity) const {
        std::vector<ImVec2> points;
        for (const Vec3 &p : corners)
            if (const auto q = at(p))
                points.push_back(*q);
        if (points.size() < corners.size())
            return;
        ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
        accent.w = opacity;
        const int n = static_cast<int>(points.size());
        list_.AddPolyline(points.data(), n, IM_COL32(0, 0, 0, static_cast<int>(200 * opacity)), ImDrawFlags_Closed, width + 2);
        list_.AddPolyline(points.data(), n, ImGui::ColorConvertFloat4ToU32(accent), ImDrawFlags_Closed, width);
    }
    void link(const LinkReport &l) const {
        const glm::vec3 c = link_colour(l.kind);
        const ImU32 colour = ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
        const auto receiver = at(l.centre);
        if (!receiver)
            return;
        for (const Vec3 &p : l.sources)
            if (const auto source = at(p)) {
                list_.AddLine(*receiver, *source, IM_COL32(0, 0, 0, 200), em(0.24f));
                list_.AddLine(*receiver, *source, colour, em(0.12f));
                list_.AddCircleFilled(*source, em(0.24f), colour);
            }
        list_.AddCircleFilled(*receiver, em(0.32f), IM_COL32(0, 0, 0, 200));
        list_.AddCircleFilled(*receiver, em(0.22f), colour);
    }

private:
    const Camera &camera_;
    ImDrawList &list_;
    const WindowRect &pane_;
};

} // namespace

void draw_picked_element(const AppState &state, ImDrawList &list, const WindowRect &pane, const Camera &camera,
                         const Fonts &fonts) {
    const auto snapshot = state.active_solution();
    const ElementReport *report = shown_report(state);
    if (state.inspector != Inspector::element || !report || !snapshot)
        return;
    const Pen pen(camera, list, pane);
    list.PushClipRect({pane.x, pane.y}, {pane.x + pane.width, pane.y + pane.height}, true);
    pen.outline(report->outline, 2, 1);
    if (const LinkReport *links = picked_links(state)) {
        if (links->levels_up > 0)
            pen.outline(links->outline, 1, 0.7f);
        pen.link(*links);
        if (report->xray)
            draw_profile_mark(list, fonts, {pane.x, pane.y}, {pane.x + pane.width, pane.y + pane.height}, camera,
                              {report->surface, report->xray->from, report->xray->to}, state.element.cursor, "PQ");
    }
    list.PopClipRect();
}

} // namespace penumbra
