#include "panels/coefficient_bars.h"

#include "iteration/split_filters.h"
#include "panels/controls.h"
#include "panels/filter_words.h"
#include "panels/split_sketch.h"
#include "panels/words.h"
#include "render/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

constexpr ImU32 channel_colours[] = {IM_COL32(230, 90, 80, 255), IM_COL32(90, 190, 100, 255), IM_COL32(100, 140, 240, 255)};

void tell_function(const ElementReport &r, int k, bool grey) {
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(("function " + std::to_string(k) + ": " + function_words(r.basis, r.order, k)).c_str());
    const Rgb value = r.coefficients.row(k).transpose().array();
    ImGui::TextUnformatted((grey ? number_words(value[0]) : rgb_words(value)).append(" W/m\u00b2").c_str());
    ImGui::EndTooltip();
}

} // namespace

void draw_coefficient_bars(const ElementReport &r, float width, float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("coefficients", {width, height});
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const int n = static_cast<int>(r.coefficients.rows()) - 1;
    const float middle = low.y + 0.5f * height;
    list.AddLine({low.x, middle}, {low.x + width, middle}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    if (n < 1)
        return;
    const Eigen::MatrixX3d details = r.coefficients.bottomRows(n);
    const double most = details.cwiseAbs().maxCoeff();
    const bool grey = (details.colwise() - details.col(0)).cwiseAbs().maxCoeff() <= 1e-9 * most;
    const int n_bars = grey ? 1 : 3;
    const float step = width / static_cast<float>(n), bar = 0.8f * step / static_cast<float>(n_bars);
    for (int k = 0; k < n; ++k) {
        const float left = low.x + static_cast<float>(k) * step;
        if (hovered && ImGui::GetIO().MousePos.x >= left && ImGui::GetIO().MousePos.x < left + step) {
            list.AddRectFilled({left, low.y}, {left + step, low.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
            tell_function(r, k + 1, grey);
        }
        for (int c = 0; c < n_bars && most > 0; ++c) {
            const float x = left + 0.1f * step + static_cast<float>(c) * bar;
            const float y = middle - 0.48f * height * static_cast<float>(details(k, c) / most);
            list.AddRectFilled({x, std::min(y, middle)}, {x + std::max(1.f, bar - 0.5f), std::max(y, middle)},
                               grey ? ImGui::GetColorU32(ImGuiCol_CheckMark) : channel_colours[c]);
        }
    }
}

void draw_polynomial_map(const Snapshot &snapshot, int index, const Camera &camera, const Look &look, float side) {
    const SnapshotPatch &patch = snapshot.patches[static_cast<std::size_t>(index)];
    const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(patch.surface)];
    const Eigen::Matrix2d turn = turn_to_view(camera, surface);
    Vec2 low = turn * patch.corners.front(), high = low;
    for (const Vec2 &p : patch.corners) {
        low = low.cwiseMin(turn * p);
        high = high.cwiseMax(turn * p);
    }
    const double scale = 0.98 * static_cast<double>(side) / (high - low).maxCoeff();
    const Vec2 middle = (low + high) / 2;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    const auto at = [&](const Vec2 &p) { // y upward
        const Vec2 q = scale * (turn * p - middle);
        return ImVec2(corner.x + 0.5f * side + static_cast<float>(q.x()), corner.y + 0.5f * side - static_cast<float>(q.y()));
    };
    struct Cell {
        std::array<ImVec2, 4> corners;
        double value;
    };
    std::vector<Cell> cells;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    const int n = patch.order == 1 ? 1 : 20;
    for (const BilinearQuad &tile : tiles(patch))
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const auto point = [&](double di, double dj) { return tile.at((i + di) / n, (j + dj) / n); };
                const double value = radiosity(snapshot, patch, point(0.5, 0.5)).mean();
                least = std::min(least, value);
                most = std::max(most, value);
                cells.push_back({{at(point(0, 0)), at(point(1, 0)), at(point(1, 1)), at(point(0, 1))}, value});
            }
    Look own = look;
    own.false_colour = true;
    own.exposure_ev = 0;
    own.shading = Shading::polynomial;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill; // no seams between cells
    for (const Cell &c : cells)
        list.AddQuadFilled(c.corners[3], c.corners[2], c.corners[1], c.corners[0],
                           ImGui::ColorConvertFloat4ToU32(shown_colour(own, {least, std::max(most, least + 1e-12)}, c.value)));
    list.Flags = flags;
    std::vector<ImVec2> outline;
    std::ranges::transform(patch.corners, std::back_inserter(outline), at);
    list.AddPolyline(outline.data(), static_cast<int>(outline.size()), ImGui::GetColorU32(ImGuiCol_Text), ImDrawFlags_Closed, 1);
    const std::string words = n == 1 ? number_words(most) : number_words(least) + " \u2026 " + number_words(most);
    ImGui::TextDisabled("%s", words.c_str());
}

} // namespace penumbra
