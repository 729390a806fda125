// The filters between an element and the pieces it was split into.
#include "microscope_verbs.h"
#include "paper_lines.h"
#include "panels/controls.h"
#include "panels/filter_words.h"
#include "panels/matrix_map.h"
#include "panels/panels.h"
#include "panels/split_sketch.h"
#include "panels/words.h"
#include "render/event_words.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace penumbra {

namespace {

void explain(const MapWords &words) {
    ImGui::TextUnformatted(words.sentence.c_str());
    ImGui::TextDisabled("%s", words.symbol);
    ImGui::TextDisabled("%s", words.equation);
}

void tell(const MapWords &words) {
    if (!ImGui::IsItemHovered())
        return;
    note_told(words.title, words.sentence, std::string(words.symbol) + "   (" + words.equation + ")");
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(24));
    explain(words);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string row_function(const SplitFilters &f, const MapWords &words, int k) {
    return std::string(words.rows) + " " + std::to_string(k) + ": " +
           function_words(f, k, std::string_view(words.rows) == "child's function");
}

void tell_cell(AppState &state, const SplitFilters &f, const MapWords &words, const Eigen::MatrixXd &matrix,
               const MatrixCell &cell) {
    const double value = matrix(cell.row, cell.column);
    state.microscope.reading = std::string(words.name) + " " + std::to_string(cell.row) + " " +
                               std::to_string(cell.column) + " " + number_words(value);
    note_told(power_words(value, 6), words.sentence, std::string(words.symbol) + "   (" + words.equation + ")");
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(24));
    ImGui::TextUnformatted(power_words(value, 6).c_str());
    const bool child_columns = std::string_view(words.columns) == "child's function";
    ImGui::TextUnformatted(("row, " + row_function(f, words, cell.row)).c_str());
    ImGui::TextUnformatted(("column, " + std::string(words.columns) + " " + std::to_string(cell.column) + ": " +
                            function_words(f, cell.column, child_columns))
                               .c_str());
    ImGui::Separator();
    explain(words);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// At the right end of a title, which is on the line and begins the `width`.
void write_size(double largest_entry, float width) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const float room = width - ImGui::GetItemRectSize().x - em(0.4f);
    const std::string text = power_words(largest_entry, 2);
    const float needed = ImGui::CalcTextSize(text.c_str()).x, shrink = std::min(1.f, room / needed);
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), shrink * em(),
                                        {low.x + width - shrink * needed, low.y + 0.5f * (1 - shrink) * em()},
                                        ImGui::GetColorU32(ImGuiCol_CheckMark), text.c_str());
}

/// Title, the map between what its columns and rows stand for, its scale.
void draw_map(AppState &state, const SplitFilters &f, const MapWords &words, const Eigen::MatrixXd &matrix,
              double range, float left, float side, bool tells_size = false) {
    const bool zero = range < rounding;
    const float size = em(0.9f), margin = em(1.15f);
    ImGui::SetCursorPosX(left);
    ImGui::BeginGroup();
    ImGui::TextUnformatted(words.title.c_str());
    mark(state, std::string("about ") + words.name);
    tell(words);
    if (tells_size)
        write_size(range, margin + side);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string columns = std::string(words.columns) + "s", rows = std::string(words.rows) + "s";
    const ImU32 quiet = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const float length = ImGui::GetFont()->CalcTextSizeA(size, 1e9f, 0, columns.c_str()).x;
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size, {at.x + margin + 0.5f * (side - length), at.y}, quiet,
                                        columns.c_str());
    draw_upward(rows.c_str(), at.x, at.y + margin + 0.5f * side, quiet, size);
    ImGui::SetCursorScreenPos({at.x + margin, at.y + margin});
    const auto cell = draw_matrix_map(words.name, matrix, zero ? 0 : range, side);
    mark(state, std::string("map ") + words.name);
    if (cell)
        tell_cell(state, f, words, matrix, *cell);
    ImGui::SetCursorScreenPos({at.x + margin, at.y + margin + side + em(0.3f)});
    if (zero)
        ImGui::TextDisabled("0 to rounding");
    else
        draw_map_scale(range, side);
    ImGui::EndGroup();
}

void draw_which(AppState &state, const SplitFilters &f) {
    Microscope &m = state.microscope;
    const auto snapshot = state.active_solution();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted((surface_name(*snapshot, f.surface) + ": an element " + how_split(f)).c_str());
    ImGui::PopTextWrapPos();
    ImGui::TextDisabled(f.loss.rows() == 1 ? "%s, M = %d: %d function" : "%s, M = %d: %d functions",
                        name(f.basis).data(), f.order, static_cast<int>(f.loss.rows()));
    ImGui::BeginDisabled(m.outward >= m.n_splits - 1);
    if (choice(state, "microscope.outward", "larger", false, "To the split that made this element."))
        step_outward(state, 1);
    ImGui::EndDisabled();
    ImGui::SameLine(0, 1);
    ImGui::BeginDisabled(m.outward == 0);
    if (choice(state, "microscope.inward", "smaller", false,
               "To the split inside, towards the patch that was clicked."))
        step_outward(state, -1);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::TextDisabled("split %d of %d", m.n_splits - m.outward, m.n_splits);
    for (int c = 0; c < static_cast<int>(f.pieces.size()); ++c) {
        if (c > 0)
            ImGui::SameLine(0, 1);
        const std::string text = std::to_string(c + 1);
        if (choice(state, "microscope.piece " + text, text.c_str(), c == m.piece, "The filters of this child.",
                   {em(2.1f), 0}))
            m.piece = c;
    }
    ImGui::SameLine();
    const double share = f.pieces[static_cast<std::size_t>(m.piece)].share;
    ImGui::TextDisabled("C = %s", power_words(share).c_str());
    mark(state, "share of the child");
    tooltip("C", f.basis == BasisFamily::planar
                     ? "The child's share of its parent's area."
                     : "The child's share of its parent's parameter square: the mean of A(u\u2032,v\u2032).",
            {}, paper_line("share of the child"));
}

void draw_filters(AppState &state, const SplitFilters &f) {
    const PieceFilters &piece = f.pieces[static_cast<std::size_t>(state.microscope.piece)];
    const float margin = em(1.15f), gap = em(0.9f), width = ImGui::GetContentRegionAvail().x;
    const float line = ImGui::GetTextLineHeightWithSpacing(), text = line + margin + em(2.2f);
    const float rest = ImGui::GetContentRegionAvail().y - 2 * text;
    const float side = std::floor(std::min(std::max(rest / 2, em(6)), (width - gap) / 2 - margin));
    const float left = ImGui::GetCursorPosX(), right = left + margin + side + gap;
    const double range = std::max(largest(piece.push), largest(piece.pull));
    const float top = ImGui::GetCursorPosY();
    draw_map(state, f, push_words(state.microscope.piece), piece.push, range, left, side);
    ImGui::SetCursorPosY(top);
    draw_map(state, f, pull_words(state.microscope.piece), piece.pull, range, right, side);
    const float middle = ImGui::GetCursorPosY();
    draw_map(state, f, difference_words(), piece.difference, largest(piece.difference), left, side, true);
    ImGui::SetCursorPosY(middle);
    draw_map(state, f, loss_words(), f.loss, largest(f.loss), right, side, true);
}

void say_why_not(AppState &state) {
    const auto snapshot = state.active_solution();
    const auto &at = state.microscope.at;
    const bool any = snapshot && !snapshot->splits.empty();
    ImGui::PushTextWrapPos(0);
    if (any && at && at->surface < static_cast<int>(snapshot->surfaces.size()))
        ImGui::TextUnformatted((surface_name(*snapshot, at->surface) +
                                " has not been split there. Click another patch, or take a step (\u2192).")
                                   .c_str());
    else
        ImGui::TextUnformatted("Nothing has been split yet: take a step (\u2192), then click a patch.");
    ImGui::PopTextWrapPos();
    if (any &&
        choice(state, "microscope.largest", "Show the largest cut", false, "Where cuts are; or the largest split."))
        state.microscope = {};
}

} // namespace

void draw_microscope(AppState &state) {
    state.microscope.reading.clear();
    update_microscope(state);
    const auto shown = state.microscope.shown;
    if (!shown) {
        say_why_not(state);
        return;
    }
    const int clicked = draw_split_sketch(state, *shown, state.microscope.piece, em(6));
    if (clicked >= 0)
        state.microscope.piece = clicked;
    ImGui::SameLine(0, em(0.8f));
    ImGui::BeginGroup();
    draw_which(state, *shown);
    ImGui::EndGroup();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(verdict(*shown).c_str());
    ImGui::PopTextWrapPos();
    draw_filters(state, *shown);
}

} // namespace penumbra
