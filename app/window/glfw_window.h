// A window with a GL core context and ImGui in it. One at a time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace penumbra {

class GlfwWindow {
public:
    struct Events {
        std::function<void(const std::string &key)> key; ///< words of keys.h; not while text is being typed
        std::function<void(const std::string &file)> drop;
        std::function<void(const std::string &key)> release; ///< the same words, without modifiers
    };

    /// Opens the window. Throws Unavailable where there is no display or no GL 4.1.
    GlfwWindow(const std::string &title, int width, int height, Events events);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow &) = delete;
    GlfwWindow &operator=(const GlfwWindow &) = delete;

    bool should_close() const;
    /// Sleeps until something happens, or for this long [s] when it is not negative.
    void wait(double seconds);
    /// Whether any event that may change the picture came since the last call.
    bool take_touched();
    /// Whether ImGui holds input back for later frames: from 1.87 on it takes one change of a key a frame.
    bool has_input_waiting() const;
    /// From any thread: makes wait() return.
    static void wake();

    /// Framebuffer pixels to a screen coordinate: 1, or more on dense screens.
    double pixel_ratio() const;
    /// What the desktop wants text to be scaled by.
    double content_scale() const;
    void framebuffer_size(int &width, int &height) const;
    void begin_frame();
    /// Draws what ImGui has collected over what was drawn since begin_frame.
    void draw_interface();
    void swap();
    /// Puts other fonts in the place of those there are; `load` adds them to the atlas. Between frames.
    void replace_fonts(const std::function<void()> &load);

private:
    struct Callbacks;
    void show_short_presses();

    GLFWwindow *window_ = nullptr;
    Events events_;
    std::vector<int> pressed_; ///< GLFW keys, since the last frame
    bool touched_ = true, drawn_ = false;
};

} // namespace penumbra
