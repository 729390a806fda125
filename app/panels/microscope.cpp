// The filters between an element and the pieces it was split into.
#include "microscope_verbs.h"
#include "panels/controls.h"
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

constexpr double rounding = 1e-11; // what is smaller is 0 to the eye

double largest(const Eigen::MatrixXd &m) { return m.cwiseAbs().maxCoeff(); }

std::string small_number(int n, bool below) {
    static constexpr const char *raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                             "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    static constexpr const char *lowered[] = {"\u2080", "\u2081", "\u2082", "\u2083", "\u2084",
                                              "\u2085", "\u2086", "\u2087", "\u2088", "\u2089"};
    std::string text;
    for (const char digit : std::to_string(n))
        text += (below ? lowered : raised)[digit - '0'];
    return text;
}

/// "L₂(u) L₁(v)", with primes for a child; of the planar basis "x²y + …", its highest power.
std::string function_words(const SplitFilters &f, int k, bool child) {
    const auto [i, j] = function_degrees(f.basis, f.order, k);
    if (f.basis == BasisFamily::parametric) {
        const char *prime = child ? "\u2032" : "";
        return "L" + small_number(i, true) + "(u" + prime + ") L" + small_number(j, true) + "(v" + prime + ")";
    }
    const auto power = [](const char *x, int n) {
        return n == 0 ? std::string() : n == 1 ? std::string(x) : x + small_number(n, false);
    };
    return i + j == 0 ? "1" : power("x", i) + power("y", j) + " + \u2026";
}

/// How a map is labelled and explained.
struct MapWords {
    const char *name; ///< of the widget
    std::string title;
    const char *rows, *columns;
    std::string sentence; ///< plain
    const char *symbol;
    const char *equation;
};

void explain(const MapWords &words) {
    ImGui::TextUnformatted(words.sentence.c_str());
    ImGui::TextDisabled("%s", words.symbol);
    ImGui::TextDisabled("%s", words.equation);
}

void tell(const MapWords &words) {
    if (!ImGui::IsItemHovered())
        return;
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

std::string how_split(const SplitFilters &f) {
    if (f.kind == SplitKind::cut)
        return "cut in two";
    return f.pieces.size() == 4 ? "split in four" : "halved";
}

/// In words what the two numbers mean for this very split.
std::string verdict(const SplitFilters &f) {
    const bool related = std::ranges::all_of(f.pieces, [](const auto &p) { return largest(p.difference) < rounding; });
    const bool lossless = largest(f.loss) < rounding;
    if (related && lossless)
        return f.basis == BasisFamily::planar
                   ? "Pull is push transposed, times C, and a trip down and up loses nothing: in this basis for every "
                     "cut."
                   : "Here A(u\u2032,v\u2032) is constant: pull is push transposed, times C, and nothing is lost.";
    return "A(u\u2032,v\u2032) varies over a slanted cut: pull is not push transposed, and a trip down and up changes "
           "some functions, here by up to " +
           power_words(largest(f.loss), 2) + ".";
}

void draw_which(AppState &state, const SplitFilters &f) {
    Microscope &m = state.microscope;
    const auto snapshot = state.snapshot(state.active_strategy());
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
    tooltip("C", f.basis == BasisFamily::planar
                     ? "The child's share of its parent's area."
                     : "The child's share of its parent's parameter square: the mean of A(u\u2032,v\u2032).");
}

void draw_filters(AppState &state, const SplitFilters &f) {
    const PieceFilters &piece = f.pieces[static_cast<std::size_t>(state.microscope.piece)];
    const std::string child = "child " + std::to_string(state.microscope.piece + 1);
    const MapWords push{
        "push",
        "Push to " + child,
        "child's function",
        "parent's function",
        "Gives the child's coefficients from its parent's: light that was gathered above is carried down.",
        "b\u207d\u00b9\u207e\u2098 = \u03a3\u2099 c\u207d\u2070\u2192\u00b9\u207e\u2098\u2099 "
        "b\u207d\u2070\u207e\u2099",
        "Bouatouch & Pattanaik 1995, equation (6)"};
    const MapWords pull{"pull",
                        "Pull from " + child,
                        "parent's function",
                        "child's function",
                        "Gives what the child adds to its parent's coefficients: the light of the pieces is summed up.",
                        "b\u207d\u2070\u207e\u2098 = \u03a3\u2099 c\u207d\u00b9\u2192\u2070\u207e\u2098\u2099 "
                        "b\u207d\u00b9\u207e\u2099 + \u2026",
                        "Bouatouch & Pattanaik 1995, equation (7)"};
    const MapWords difference{
        "difference",
        "pull \u2212 C\u00b7push\u1d40",
        "parent's function",
        "child's function",
        "What pull has beyond push transposed and multiplied by C. Zero: one filter gives the other.",
        "c\u207d\u00b9\u2192\u2070\u207e\u2098\u2099 \u2212 C c\u207d\u2070\u2192\u00b9\u207e\u2099\u2098",
        "Bouatouch & Pattanaik 1995, below equation (7)"};
    const MapWords loss{"loss",
                        "\u03a3 pull\u00b7push \u2212 I",
                        "parent's function",
                        "parent's function",
                        "What a trip down to all children and up again changes. Zero: nothing is lost.",
                        "\u03a3 pull push \u2212 I, over all children",
                        "Bouatouch & Pattanaik 1995, equations (6) and (7)"};
    const float margin = em(1.15f), gap = em(0.9f), width = ImGui::GetContentRegionAvail().x;
    const float line = ImGui::GetTextLineHeightWithSpacing(), text = line + margin + em(2.2f);
    const float rest = ImGui::GetContentRegionAvail().y - 2 * text;
    const float side = std::floor(std::clamp(rest / 2, em(6), (width - gap) / 2 - margin));
    const float left = ImGui::GetCursorPosX(), right = left + margin + side + gap;
    const double range = std::max(largest(piece.push), largest(piece.pull));
    const float top = ImGui::GetCursorPosY();
    draw_map(state, f, push, piece.push, range, left, side);
    ImGui::SetCursorPosY(top);
    draw_map(state, f, pull, piece.pull, range, right, side);
    const float middle = ImGui::GetCursorPosY();
    draw_map(state, f, difference, piece.difference, largest(piece.difference), left, side, true);
    ImGui::SetCursorPosY(middle);
    draw_map(state, f, loss, f.loss, largest(f.loss), right, side, true);
}

void say_why_not(AppState &state) {
    const auto snapshot = state.snapshot(state.active_strategy());
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
