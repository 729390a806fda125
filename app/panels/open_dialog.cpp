#include "panels/controls.h"
#include "panels/panels.h"

#include <algorithm>
#include <string>

namespace penumbra {

namespace {
constexpr std::size_t longest_path = 4096;
}

void draw_open_dialog(AppState &state) {
    if (!state.open_dialog)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(em(40), window.x - em(2));
    ImGui::SetNextWindowPos({0.5f * window.x, 0.3f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("Open a scene", &state.open_dialog,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextDisabled("Path of an OBJ or glTF file, a saved state or a picture, or a bundled scene's name.");
    ImGui::TextDisabled("Files may also be dropped on the window.");
    if (ImGui::IsWindowAppearing())
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-em(5));
    state.open_path.resize(longest_path);
    const bool entered =
        ImGui::InputText("##path", state.open_path.data(), longest_path, ImGuiInputTextFlags_EnterReturnsTrue);
    state.open_path.resize(state.open_path.find('\0'));
    mark(state, "open.path");
    tooltip("Path", "Of an OBJ or glTF file, a saved state or a picture; or a bundled scene's name.");
    ImGui::SameLine();
    const bool clicked = ImGui::Button("Open", {-1, 0});
    mark(state, "open.open");
    tooltip("Open", "Opens what is named on the left; so does Return.");
    if ((entered || clicked) && !state.open_path.empty()) {
        state.open_request = state.open_path;
        state.open_dialog = false;
    }
    ImGui::End();
}

} // namespace penumbra
