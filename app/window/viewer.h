// The interactive viewer: a window, the state, the worker, and the way of one frame:
// events -> reports of the worker -> actions -> goal -> panes that changed -> panels -> swap.
#pragma once

#include "app_state.h"
#include "render/labels.h"
#include "solve_worker.h"
#include "window/glfw_window.h"
#include "window/pane_canvas.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct ViewerSetup {
    OpenedFile file;                         ///< shown first
    std::vector<std::string> bundled_scenes; ///< names offered
    Options options;
    SolveWorker::ReadFile read_file;
    int width = 1280, height = 800;          ///< of the window [screen coordinates]
    std::filesystem::path state_file;        ///< for tests: the observed state, written when it changed; empty: none
    bool inert = false;                      ///< for tests of the tests: actions do nothing
};

class Viewer {
public:
    /// Throws Unavailable where there is no display or no GL 4.1.
    explicit Viewer(ViewerSetup setup);
    /// Until the window is closed.
    void run();

private:
    void on_key(const std::string &key);
    void take_reports();
    void serve_requests();
    double wait_time();
    void set_first_view();
    void update_range();
    bool is_moving();
    Look look_now() const;
    float legend_height(float width) const;
    void draw_frame();
    void draw_panels(const struct Arrangement &arrangement);
    void take_pictures();
    void update_fonts();
    void write_state();

    ViewerSetup setup_;
    AppState state_;
    GlfwWindow window_;
    PaneCanvas canvas_;
    SolveWorker worker_;
    std::optional<Goal> aimed_;
    std::optional<Clock::time_point> cancelled_at_;
    Fonts fonts_;
    double fonts_scale_ = 0;
    std::optional<Theme> theme_;
    std::optional<Camera> drawn_camera_; ///< of the frame before
    Spotlight drawn_spotlight_;
    Clock::time_point moved_at_;         ///< when one of them was last seen to change
    int frames_owed_ = 2; ///< ImGui shows some changes a frame later
    std::string written_state_;
};

} // namespace penumbra
