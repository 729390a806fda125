// The real window on a virtual display, driven by xdotool as a hand would, and the state that it reports.
#pragma once

#include "gui/process.h"
#include "gui/screen.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra::gui {

using Json = nlohmann::json;

struct Point {
    double x = 0, y = 0;
};

/// What a start finds.
struct Start {
    bool first = false;          ///< else the tour has been seen
    std::filesystem::path home{}; ///< of an earlier session, which stays; empty: a new one
};

/// A home that outlives its sessions.
class Home {
public:
    Home();
    ~Home();
    Home(const Home &) = delete;
    Home &operator=(const Home &) = delete;
    const std::filesystem::path &path() const { return path_; }

private:
    std::filesystem::path path_;
};

class Session {
public:
    /// Starts the viewer and waits until its first picture is there. HOME and all XDG folders are new and empty, but for the
    /// settings, unless `start` says otherwise.
    explicit Session(std::vector<std::string> arguments = {}, int width = 1280, int height = 800, const Start &start = {});
    /// Ends it; the test fails when a sanitizer's report stands in the program's log.
    ~Session();
    Session(const Session &) = delete;
    Session &operator=(const Session &) = delete;

    /// The last state that was written.
    Json state() const;
    /// Waits until it holds; fails the test with `what` and the last state when it does not within `seconds`, times
    /// time_factor.
    Json wait_until(const std::string &what, const std::function<bool(const Json &)> &holds, double seconds = 30);
    /// Waits until nothing is computed and nothing changes any more.
    Json settled();

    /// Presses and waits until the window has taken it. Names as xdotool has them: "Right", "shift+Right", "question".
    void key(const std::string &name);
    /// Presses it and keeps it down until let_go().
    void hold(const std::string &name);
    void let_go(const std::string &name);
    /// The same with the left mouse button.
    void hold(Point p);
    void let_go();
    /// Into the text field that has the focus; enter() is the key that ends it.
    void type(const std::string &text);
    void enter();
    void move(Point p);
    /// Buttons: 1 left, 2 middle, 3 right, 4 wheel up, 5 wheel down.
    void click(Point p, int button = 1, int times = 1);
    void drag(Point from, Point to, int button = 1, const std::string &modifier = "");
    void drop(const std::filesystem::path &file);
    std::string clipboard() const; ///< what another program would paste
    /// The window, which is 1280 by 800 at first; not beyond the screen.
    void resize(int width, int height);

    /// Where a control stands; fails the test when it is not shown.
    Box widget(const std::string &name) const;
    void click(const std::string &widget_name);
    Point middle(const std::string &widget_name) const;
    /// Opens the list of objects and takes its first in hand.
    void take_first_object();
    Screenshot shot();

    Process &program() { return *program_; }
    std::string log() const; ///< what the program has said so far
    void end_display();      ///< the window's server goes away; nothing more can be pressed
    const std::filesystem::path &home() const { return home_; }
    const std::filesystem::path &folder() const { return work_; } ///< that the program was started in

private:
    void xdotool(std::vector<std::string> words) const;
    void press(const std::string &how, const std::string &name);

    std::filesystem::path root_, home_, work_;
    std::unique_ptr<Screen> screen_;
    std::unique_ptr<Process> program_;
    std::string window_;
};

} // namespace penumbra::gui
