// The objects of the scene: which is in hand, where it is and how large.
#include "move_verbs.h"
#include "panels/controls.h"
#include "panels/panels.h"

#include <string>

namespace penumbra {

namespace {

const char *kind_of(const Scene &scene, int surface) {
    const SurfaceId s(surface);
    return scene.emits(s) ? "light" : scene.reflects(s) ? "reflects" : "blocker";
}

void draw_list(AppState &state) {
    const Scene &scene = *state.scene;
    ImGui::BeginChild("objects", {0, em(13)}, true);
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        if (scene.surface(SurfaceId(s)).back || object_surfaces(scene, SurfaceId(s)).front() != s)
            continue;
        const std::string name = object_name(scene, s);
        if (ImGui::Selectable((name + "##" + std::to_string(s)).c_str(), state.objects.chosen == s))
            choose_object(state, s);
        mark(state, "object." + name);
        const char *kind = kind_of(scene, s);
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(kind).x);
        ImGui::TextDisabled("%s", kind);
    }
    ImGui::EndChild();
}

/// A number to type or to drag; done when it is let go.
bool number_field(AppState &state, const char *name, const char *sentence, double &value, double speed) {
    field_label(name);
    float shown = static_cast<float>(value);
    const bool changed = ImGui::DragFloat(("##" + std::string(name)).c_str(), &shown, static_cast<float>(speed), 0, 0, "%.4g");
    mark(state, "object " + std::string(name));
    tooltip(name, sentence);
    if (changed)
        value = static_cast<double>(shown);
    return changed;
}

void draw_place(AppState &state) {
    const Scene &original = *state.objects.original;
    const SurfaceId surface(state.objects.chosen);
    heading(object_name(original, state.objects.chosen).c_str());
    ObjectMove move = move_in_hand(state);
    const Vec3 centre = object_centre(original, surface);
    Vec3 place = centre + move.offset;
    const double speed = 2e-3 * original.own.size;
    constexpr const char *axes[] = {"centre x", "centre y", "centre z"};
    bool changed = false;
    for (int a = 0; a < 3; ++a)
        changed |= number_field(state, axes[a], "Of the box about it, in the scene's unit of length. Drag, or double-click to type.",
                                place[a], speed);
    changed |= number_field(state, "size", "Times what the file has, about its centre.", move.scale, 0.005);
    if (changed) {
        move.offset = place - centre;
        move_object(state, move);
    }
    if (choice(state, "object back", "Put it back", false, "Where the file has it, as large as there.")) {
        ObjectMove none;
        none.surface = move.surface;
        move_object(state, none);
    }
}

} // namespace

void draw_objects(AppState &state) {
    if (!state.scene || !state.objects.original)
        return;
    heading("Objects");
    draw_list(state);
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("Click one here or in a pane; then drag it in the pane: level with the floor, with Shift up and down.");
    ImGui::PopTextWrapPos();
    if (state.objects.chosen >= 0)
        draw_place(state);
    action_button(state, "edit.put_back");
}

} // namespace penumbra
