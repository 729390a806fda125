#include "panels/matrix_map.h"

#include "panels/controls.h"
#include "panels/words.h"
#include "render/diverging.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

ImU32 colour(double t) {
    const glm::dvec3 c = diverging(t);
    return ImGui::ColorConvertFloat4ToU32(
        {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1});
}

std::string value_words(double value) { return power_words(std::abs(value) < 1e-12 ? 0 : value, 2); }

/// In every cell, or in none: where one of them has not room enough.
bool has_room_for_values(const Eigen::MatrixXd &matrix, float wide, float size) {
    float widest = 0;
    for (Eigen::Index k = 0; k < matrix.size(); ++k)
        widest =
            std::max(widest, ImGui::GetFont()->CalcTextSizeA(size, 1e9f, 0, value_words(matrix.data()[k]).c_str()).x);
    return widest + em(0.2f) < wide;
}

} // namespace

std::optional<MatrixCell> draw_matrix_map(const char *name, const Eigen::MatrixXd &matrix, double range, float side) {
    const ImVec2 corner = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
    ImGui::InvisibleButton(name, {side, side});
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float wide = side / static_cast<float>(matrix.cols()), high = side / static_cast<float>(matrix.rows());
    const float gap = std::min(wide, high) > 6 ? 1 : 0;
    const bool written = has_room_for_values(matrix, wide, em(0.8f));
    std::optional<MatrixCell> found;
    for (int i = 0; i < matrix.rows(); ++i)
        for (int j = 0; j < matrix.cols(); ++j) {
            const ImVec2 low{std::round(corner.x + static_cast<float>(j) * wide),
                             std::round(corner.y + static_cast<float>(i) * high)},
                high_end{std::round(corner.x + static_cast<float>(j + 1) * wide) - gap,
                         std::round(corner.y + static_cast<float>(i + 1) * high) - gap};
            const double t = range > 0 ? matrix(i, j) / range : 0;
            list.AddRectFilled(low, high_end, colour(t));
            if (written) {
                const std::string text = value_words(matrix(i, j));
                const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(em(0.8f), 1e9f, 0, text.c_str());
                list.AddText(ImGui::GetFont(), em(0.8f),
                             {0.5f * (low.x + high_end.x - size.x), 0.5f * (low.y + high_end.y - size.y)},
                             std::abs(t) > 0.4 ? IM_COL32(255, 255, 255, 255) : IM_COL32(20, 20, 20, 255),
                             text.c_str());
            }
            if (hovered && mouse.x >= low.x && mouse.x < high_end.x + gap && mouse.y >= low.y &&
                mouse.y < high_end.y + gap)
                found = MatrixCell{i, j};
            if (found && found->row == i && found->column == j)
                list.AddRect({low.x - 1, low.y - 1}, {high_end.x + 1, high_end.y + 1},
                             ImGui::GetColorU32(ImGuiCol_CheckMark), 0, 0, 2);
        }
    return found;
}

void draw_upward(const char *text, float left, float middle, ImU32 colour, float size) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const int first = list.VtxBuffer.Size;
    const float length = ImGui::GetFont()->CalcTextSizeA(size, 1e9f, 0, text).x;
    const ImVec2 from{std::round(left), std::round(middle + 0.5f * length)};
    // Written to the right of a place where nothing is clipped, then turned about its beginning.
    const ImVec2 low = list.GetClipRectMin(), high = list.GetClipRectMax();
    list.PushClipRect({low.x - 1e4f, low.y - 1e4f}, {high.x + 1e4f, high.y + 1e4f});
    list.AddText(ImGui::GetFont(), size, from, colour, text);
    list.PopClipRect();
    for (int k = first; k < list.VtxBuffer.Size; ++k) {
        ImVec2 &p = list.VtxBuffer[k].pos;
        p = {from.x + (p.y - from.y), from.y - (p.x - from.x)};
    }
}

void draw_map_scale(double range, float width) {
    constexpr int n = 48;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = em(0.5f), step = width / n;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    for (int k = 0; k < n; ++k)
        list.AddRectFilled({corner.x + static_cast<float>(k) * step, corner.y},
                           {corner.x + static_cast<float>(k + 1) * step, corner.y + height},
                           colour(2 * (k + 0.5) / n - 1));
    const int digits = range < 1e-3 ? 2 : 3;
    const std::string low = power_words(-range, digits), high = "+" + power_words(range, digits);
    const float below = corner.y + height + em(0.1f), size = em(0.85f);
    const auto write = [&](const std::string &text, float share) {
        const float wide = ImGui::GetFont()->CalcTextSizeA(size, 1e9f, 0, text.c_str()).x;
        list.AddText(ImGui::GetFont(), size, {corner.x + share * (width - wide), below},
                     ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    };
    write(low, 0);
    write("0", 0.5f);
    write(high, 1);
    ImGui::Dummy({width, height + em(1.1f)});
}

} // namespace penumbra
