// The ledger of effects: what the scene calls for and why, what that spared, and the switches.
#include "core/sentence.h"
#include "effect_verbs.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "paper_lines.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace penumbra {

namespace {

struct Naming {
    const char *title, *what;
};

Naming naming(Effect effect) {
    switch (effect) {
    case Effect::emission:
        return {"Light", "Whether anything emits."};
    case Effect::two_sided:
        return {"Both sides", "Sides of surfaces that light may never reach."};
    case Effect::hidden_pairs:
        return {"Hidden pairs", "Pairs of surfaces that something hides from each other altogether, as walls hide rooms."};
    case Effect::visibility:
        return {"Visibility", "What stands between two surfaces that see each other in part: shadows."};
    case Effect::curves_ve_ev:
        return {"Curves VE and EV", "Discontinuities that an edge and a corner throw, and the planes of lights and blockers."};
    case Effect::curves_eee:
        return {"Curves EEE", "Discontinuities that three edges throw."};
    case Effect::curves_contact:
        return {"Curves of contact", "Discontinuities where a blocker stands on a receiver."};
    case Effect::curves_secondary:
        return {"Curves of reflectors", "Discontinuities of light that has been reflected."};
    case Effect::interreflection:
        return {"Interreflection", "Light that one surface reflects onto another."};
    case Effect::colour:
        return {"Colour", "Channels that are no multiple of each other."};
    case Effect::order:
        return {"Order", "Polynomials of the order asked for on every link, where lower ones would do."};
    }
    return {"", ""};
}

/// Okabe & Ito's colours (2008), told apart by colour-blind people; the words say the same.
ImVec4 colour(Decision decision) {
    switch (decision) {
    case Decision::on:
        return {0.00f, 0.45f, 0.33f, 1};
    case Decision::partial:
        return {0.00f, 0.35f, 0.55f, 1};
    case Decision::off:
        break;
    }
    return {0.33f, 0.33f, 0.33f, 1};
}

void draw_badge(const LedgerEntry &entry) {
    const std::string text(name(entry.decision));
    const float width = em(3.6f), height = ImGui::GetTextLineHeight() + em(0.1f);
    const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text.c_str());
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::ColorConvertFloat4ToU32(colour(entry.decision)), em(0.2f));
    list.AddText({at.x + (width - size.x) / 2, at.y + (height - size.y) / 2}, IM_COL32_WHITE, text.c_str());
    ImGui::Dummy({width, height});
}

/// "kernel_evaluations" as "kernel evaluations".
std::string unit_words(Effect effect) {
    std::string text(unit(effect));
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string spared_words(const LedgerEntry &entry) {
    if (entry.saved <= 0)
        return "";
    return count_words(entry.saved) + " " + unit_words(entry.effect) + " spared, " + count_words(entry.done) + " done.";
}

/// What was asked for in the row; done after all rows, as it changes what they stand on.
struct Asked {
    std::optional<EffectChange> change;
    std::optional<Switch> value;
    Effect effect{};
};

void draw_entry(AppState &state, const LedgerEntry &entry, Asked &asked) {
    const Naming words_of = naming(entry.effect);
    const std::string id(name(entry.effect));
    ImGui::PushID(id.c_str());
    ImGui::BeginGroup();
    draw_badge(entry);
    ImGui::SameLine();
    ImGui::TextUnformatted(words_of.title);
    ImGui::EndGroup();
    mark(state, "effect " + id);
    tooltip(words_of.title, words_of.what, {}, paper_line("effect " + id));
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", as_sentence(entry.reason).c_str());
    if (const std::string spared = spared_words(entry); !spared.empty())
        ImGui::TextDisabled("%s", spared.c_str());
    ImGui::PopTextWrapPos();
    bool first = true;
    for (const Switch value : all_switches) {
        if (!std::exchange(first, false))
            ImGui::SameLine(0, 1);
        const std::string text(name(value));
        if (choice(state, "effect " + id + " " + text, text.c_str(), state.options.effects[entry.effect] == value,
                   value == Switch::automatic ? "As much as the scene calls for. Starts anew."
                   : value == Switch::on      ? "All of its work, called for or not. Starts anew."
                                              : "None of it, whatever that leaves out of the picture. Starts anew.",
                   {em(3.2f), 0})) {
            asked.effect = entry.effect;
            asked.value = value;
        }
    }
    go_on(em(0.6f), button_width("show what this changes"));
    const EffectChange change = opposite(entry);
    const std::string tells = "Solves with " + words(change) + " as well, and shows the difference in place of the light.";
    if (choice(state, "change " + id, "show what this changes", state.look.shading == Shading::error && state.look.change == change,
               tells.c_str(), {ImGui::GetContentRegionAvail().x, 0}))
        asked.change = change;
    ImGui::PopID();
    ImGui::Dummy({0, em(0.25f)});
}

} // namespace

void draw_effects(AppState &state) {
    const auto entries = effects_ledger(state);
    if (entries.empty()) {
        ImGui::TextDisabled("Not known yet.");
        return;
    }
    ImGui::PushTextWrapPos(0);
    const auto simulated = std::ranges::count_if(entries, [](const LedgerEntry &e) { return e.decision != Decision::off; });
    ImGui::TextDisabled("%d of %d effects are simulated in the active pane.", static_cast<int>(simulated),
                        static_cast<int>(entries.size()));
    ImGui::PopTextWrapPos();
    action_button(state, "effects.by_scene", "Leave all to the scene", {-1, 0});
    Asked asked;
    if (ImGui::BeginChild("ledger")) {
        for (const LedgerEntry &entry : entries)
            draw_entry(state, entry, asked);
    }
    ImGui::EndChild();
    if (asked.value)
        set_effect(state, asked.effect, *asked.value);
    else if (asked.change)
        show_change(state, *asked.change);
}

} // namespace penumbra
