#include "render/overlay.h"

#include "core/error.h"

#include <backends/imgui_impl_opengl3.h>

#include <utility>

namespace penumbra {

Overlay::Overlay(int width, int height, float text)
    : outer_(ImGui::GetCurrentContext()), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_); // creating one makes it current only where there was none
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = 1;
    fonts_ = load_fonts(text);
    if (!ImGui_ImplOpenGL3_Init("#version 410 core"))
        throw Unavailable("text cannot be drawn with this graphics driver");
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void Overlay::enter() { ImGui::SetCurrentContext(context_); }
void Overlay::leave() { ImGui::SetCurrentContext(outer_); }

Overlay::~Overlay() {
    enter();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
    leave();
}

ImDrawList &Overlay::list() { return *ImGui::GetBackgroundDrawList(); }

void Overlay::draw(const PixelRect &part) {
    if (!std::exchange(collected_, true))
        ImGui::Render();
    ImDrawData &data = *ImGui::GetDrawData();
    data.DisplayPos = {static_cast<float>(part.x), static_cast<float>(part.y)};
    data.DisplaySize = {static_cast<float>(part.width), static_cast<float>(part.height)};
    ImGui_ImplOpenGL3_RenderDrawData(&data);
}

} // namespace penumbra
