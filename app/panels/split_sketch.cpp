#include "panels/split_sketch.h"

#include "geometry/convex_pieces.h"
#include "geometry/polygon.h"
#include "panels/controls.h"
#include "render/camera.h"
#include "render/surface_role.h"

#include <algorithm>
#include <string>
#include <vector>

namespace penumbra {

namespace {

ImU32 accent(float opacity) {
    ImVec4 colour = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
    colour.w = opacity;
    return ImGui::ColorConvertFloat4ToU32(colour);
}

void fill(ImDrawList &list, const std::vector<ImVec2> &points, ImU32 colour) {
    list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), colour);
}

void stroke(ImDrawList &list, const std::vector<ImVec2> &points, ImU32 colour, float width) {
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_Closed, width);
}

void write_number(ImDrawList &list, const ImVec2 &at, std::size_t piece, ImU32 colour) {
    const std::string text = std::to_string(piece + 1);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddText({at.x - 0.5f * size.x, at.y - 0.5f * size.y}, colour, text.c_str());
}

bool holds(const std::vector<Vec2> &corners, const Vec2 &p) {
    return std::ranges::all_of(half_planes(corners), [&](const HalfPlane &h) { return h.value(p) >= 0; });
}

} // namespace

Eigen::Matrix2d turn_to_view(const Camera &camera, const SnapshotSurface &s) {
    const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye),
                     right = glm::normalize(glm::cross(ahead, camera.up)), up = glm::cross(right, ahead);
    const auto seen = [&](const Vec3 &v) {
        const glm::dvec3 w(v.x(), v.y(), v.z());
        return Vec2(glm::dot(w, right), glm::dot(w, up));
    };
    const Vec2 u = seen(s.u), v = seen(s.v);
    const Eigen::Matrix2d quarter{{0, -1}, {1, 0}};
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity(), best = turn;
    double most = -1e300;
    for (int k = 0; k < 4; ++k, turn = quarter * turn)
        if (const double match = turn.col(0).dot(u) + turn.col(1).dot(v); match > most + 1e-9) {
            most = match;
            best = turn;
        }
    return best;
}

int draw_split_sketch(AppState &state, const SplitFilters &filters, int chosen, float side) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton("split sketch", {side, side});
    mark(state, "split sketch");
    tooltip("The element and its pieces", "Click a piece to look at its filters.");
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
    if (const auto snapshot = state.active_solution())
        turn = turn_to_view(state.active_camera(), snapshot->surfaces[static_cast<std::size_t>(filters.surface)]);
    Vec2 low = turn * filters.corners.front(), high = low;
    for (const Vec2 &p : filters.corners) {
        low = low.cwiseMin(turn * p);
        high = high.cwiseMax(turn * p);
    }
    const double scale = 0.98 * static_cast<double>(side) / (high - low).maxCoeff();
    const Vec2 middle = (low + high) / 2;
    const Vec2 centre(static_cast<double>(corner.x + 0.5f * side), static_cast<double>(corner.y + 0.5f * side));
    const auto at = [&](const Vec2 &p) { // y upward
        const Vec2 q = scale * (turn * p - middle);
        return ImVec2(static_cast<float>(centre.x() + q.x()), static_cast<float>(centre.y() - q.y()));
    };
    const auto outline = [&](const std::vector<Vec2> &corners) {
        std::vector<ImVec2> points; // turned over, as the picture's y runs downward
        std::ranges::transform(corners.rbegin(), corners.rend(), std::back_inserter(points), at);
        return points;
    };
    ImDrawList &list = *ImGui::GetWindowDrawList();
    int found = -1;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Vec2 off(static_cast<double>(mouse.x) - centre.x(), centre.y() - static_cast<double>(mouse.y));
    const Vec2 under = turn.transpose() * (middle + off / scale);
    for (std::size_t c = 0; c < filters.pieces.size(); ++c) {
        const auto &corners = filters.pieces[c].corners;
        const bool is_chosen = static_cast<int>(c) == chosen;
        fill(list, outline(corners), is_chosen ? accent(0.55f) : ImGui::GetColorU32(ImGuiCol_FrameBg));
        if (clicked && holds(corners, under))
            found = static_cast<int>(c);
    }
    for (std::size_t c = 0; c < filters.pieces.size(); ++c) {
        const auto &corners = filters.pieces[c].corners;
        stroke(list, outline(corners), ImGui::GetColorU32(ImGuiCol_TextDisabled), 1);
        const ImVec2 number = at(centroid(corners));
        write_number(list, number, c, ImGui::GetColorU32(ImGuiCol_Text));
        state.widgets["split sketch piece " + std::to_string(c + 1)] = {number.x - 2, number.y - 2, 4, 4};
    }
    stroke(list, outline(filters.corners), ImGui::GetColorU32(ImGuiCol_Text), 2);
    return found;
}

void draw_split_outline(const AppState &state, ImDrawList &list, const WindowRect &pane, const Camera &camera) {
    const Microscope &m = state.microscope;
    const auto snapshot = state.active_solution();
    if (state.inspector != Inspector::filters || !m.shown || !snapshot || m.version != snapshot->version)
        return;
    const SnapshotSurface &surface = snapshot->surfaces[static_cast<std::size_t>(m.shown->surface)];
    const auto outline = [&](const std::vector<Vec2> &corners) {
        std::vector<ImVec2> points;
        for (const Vec2 &corner : corners) {
            const Vec3 p = to_space(surface, corner);
            const auto at =
                place_in_frame(camera, static_cast<double>(pane.width / pane.height), {p.x(), p.y(), p.z()});
            if (!at)
                return std::vector<ImVec2>(); // behind the eye
            points.push_back({pane.x + pane.width * static_cast<float>(0.5 + 0.5 * at->x),
                              pane.y + pane.height * static_cast<float>(0.5 - 0.5 * at->y)});
        }
        return points;
    };
    const auto draw = [&](const std::vector<Vec2> &corners, float width) {
        const std::vector<ImVec2> points = outline(corners);
        if (points.empty())
            return;
        stroke(list, points, IM_COL32(0, 0, 0, 200), width + 2);
        stroke(list, points, accent(1), width);
    };
    list.PushClipRect({pane.x, pane.y}, {pane.x + pane.width, pane.y + pane.height}, true);
    if (const auto chosen = outline(m.shown->pieces[static_cast<std::size_t>(m.piece)].corners); !chosen.empty())
        fill(list, {chosen.rbegin(), chosen.rend()}, accent(0.25f));
    for (const PieceFilters &piece : m.shown->pieces)
        draw(piece.corners, 1);
    draw(m.shown->corners, 2);
    for (std::size_t c = 0; c < m.shown->pieces.size(); ++c)
        if (const auto at = outline({centroid(m.shown->pieces[c].corners)}); !at.empty()) {
            list.AddCircleFilled(at[0], em(0.65f), IM_COL32(10, 12, 16, 210));
            write_number(list, at[0], c, IM_COL32(255, 255, 255, 255));
        }
    list.PopClipRect();
}

} // namespace penumbra
