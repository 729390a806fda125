// Text and legends on a framebuffer of our own, by an ImGui context of our own: a window's context is not touched.
#pragma once

#include "render/labels.h"
#include "render/pane_renderer.h"

namespace penumbra {

class Overlay {
public:
    /// For a framebuffer of this size, with text of this height [pixels]. Needs a current GL context.
    Overlay(int width, int height, float text);
    ~Overlay();
    Overlay(const Overlay &) = delete;
    Overlay &operator=(const Overlay &) = delete;

    /// Its context is current from its making on; leave() gives the outer one back, and enter() takes it again.
    void enter();
    void leave();

    const Fonts &fonts() const { return fonts_; }
    /// Collects what is to be drawn; coordinates in pixels from the upper left.
    ImDrawList &list();
    /// Draws what lies in this part into the bound framebuffer, which holds that part alone. After the first time nothing
    /// is collected any more.
    void draw(const PixelRect &part);

private:
    ImGuiContext *outer_;
    ImGuiContext *context_;
    Fonts fonts_;
    bool collected_ = false;
};

} // namespace penumbra
