// The interactive viewer: a window, the state, the worker, and the way of one frame:
// events -> reports of the worker -> actions -> goal -> panes that changed -> panels -> swap.
#pragma once

#include "app_state.h"
#include "check_worker.h"
#include "recorder.h"
#include "render/labels.h"
#include "script.h"
#include "solve_worker.h"
#include "truth_worker.h"
#include "window/frame_times.h"
#include "window/glfw_window.h"
#include "window/keeper.h"
#include "window/pane_canvas.h"
#include "window/take_picture.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct ViewerSetup {
    OpenedFile file;                         ///< shown first
    std::string file_name;                   ///< that it was asked for by
    std::optional<SavedState> state_in_file; ///< as it stands there, whatever else was asked for
    std::vector<std::string> bundled_scenes; ///< names offered
    Options options;
    SolveWorker::ReadFile read_file;
    std::optional<double> memory_limit;      ///< of resident memory, beyond which the solver is stopped [MiB]
    int width = 1280, height = 800;          ///< of the window [screen coordinates]
    std::optional<Script> script;            ///< played first; none: nothing is
    std::filesystem::path record;            ///< script of what is done; empty: none
    std::filesystem::path state_file;        ///< for tests: the observed state, written when it changed; empty: none
    std::filesystem::path frame_times;       ///< for measuring: how long frames took; empty: none
    bool inert = false;                      ///< for tests of the tests: actions do nothing
    bool lose_context = false;               ///< for tests: after the first step, as if the driver had lost the context
};

/// How the window came to its end.
struct ViewerEnd {
    int signal = 0;    ///< that ended it; 0: it was closed
    std::string words; ///< what was kept then, to follow on a semicolon
};

class Viewer {
public:
    /// Throws Unavailable where there is no display or no GL 4.1, BadInput where the record cannot be written.
    explicit Viewer(ViewerSetup setup);
    /// Until the window is closed or a signal comes. Throws Unavailable when nothing can be drawn any more; its line says
    /// where the state was kept. When the display's connection ends, Xlib ends the program: then it is this line and
    /// status 5 as well, from there.
    ViewerEnd run();

private:
    void show_until_closed(const class EndSignal &signal);
    bool has_lost_context() const;
    std::string rescue() const;
    void on_key(const std::string &key);
    void take_reports();
    void take_report(const Report &report);
    void begin_record();
    void serve_requests();
    void keep_memory_limit();
    double wait_time();
    void set_first_view();
    bool is_moving();
    Look look_now(int pane) const;
    float legend_height(float width) const;
    void draw_frame();
    void draw_panels(const struct Arrangement &arrangement);
    void take_pictures();
    void update_fonts();
    void play_script();
    void write_state();

    ViewerSetup setup_;
    AppState state_;
    GlfwWindow window_;
    PaneCanvas canvas_;
    Photographer photographer_;
    std::optional<ScriptPlayer> script_;
    std::optional<Recorder> recorder_;
    std::optional<FrameTimes> frame_times_;
    SolveWorker worker_;
    CheckWorker checker_;
    TruthWorker judge_;
    std::optional<Goal> aimed_;
    Keeper keeper_;
    TruthGoal judging_; ///< that the judge was told of
    std::optional<Clock::time_point> cancelled_at_;
    bool over_memory_limit_ = false; ///< that is why the worker was cancelled
    Fonts fonts_;
    double fonts_scale_ = 0;
    std::optional<Theme> theme_;
    std::optional<std::array<Camera, 4>> drawn_cameras_; ///< of the frame before, by pane
    Spotlight drawn_spotlight_;
    Clock::time_point moved_at_;         ///< when one of them was last seen to change
    int frames_owed_ = 2; ///< ImGui shows some changes a frame later
    std::string written_state_;
};

} // namespace penumbra
