#include "gui/session.h"

#include "sanitizers/time_factor.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace penumbra::gui {

namespace {

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

std::string text_of(const std::filesystem::path &file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::filesystem::path temporary_folder() {
    char name[] = "/tmp/penumbra-session-XXXXXX";
    if (!::mkdtemp(name))
        throw std::runtime_error("cannot make a temporary folder");
    return name;
}

/// Where there are no settings yet.
void see_tour(const std::filesystem::path &home) {
    const auto settings = home / ".config/penumbra/settings.json";
    if (std::filesystem::exists(settings))
        return;
    std::filesystem::create_directories(settings.parent_path());
    std::ofstream(settings) << R"({"tour_seen": true})";
}

std::string whole(double x) { return std::to_string(std::lround(x)); }

} // namespace

Home::Home() : path_(temporary_folder()) {}

Home::~Home() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

Session::Session(std::vector<std::string> arguments, int width, int height, const Start &start) : root_(temporary_folder()) {
    home_ = start.home.empty() ? root_ / "home" : start.home;
    work_ = root_ / "work";
    std::filesystem::create_directories(home_);
    std::filesystem::create_directories(work_);
    if (!start.first)
        see_tour(home_);
    screen_ = std::make_unique<Screen>(width, height);
    arguments.insert(arguments.begin(), {PENUMBRA_PROGRAM, "view", "--state-file", (root_ / "state.json").string()});
    const Environment environment{{"DISPLAY", screen_->display()},
                                  {"HOME", home_.string()},
                                  {"XDG_CONFIG_HOME", (home_ / ".config").string()},
                                  {"XDG_STATE_HOME", (home_ / ".local/state").string()},
                                  {"XDG_CACHE_HOME", (home_ / ".cache").string()},
                                  {"WAYLAND_DISPLAY", ""}};
    program_ = std::make_unique<Process>(arguments, environment, work_.string(), (root_ / "log").string());
    wait_until("the first picture", [](const Json &s) { return !s["panes"].empty() && s["panes"][0].contains("version"); },
               60);
    window_ = output_of({"xdotool", "search", "--sync", "--onlyvisible", "--name", "Penumbra"},
                        {{"DISPLAY", screen_->display()}});
    window_ = window_.substr(0, window_.find('\n'));
    xdotool({"windowfocus", "--sync", window_}); // there is no window manager to do it
    settled();
}

Session::~Session() {
    program_.reset();
    screen_.reset();
    for (const char *report : {"Sanitizer:", "runtime error:"})
        EXPECT_EQ(log().find(report), std::string::npos) << log();
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
}

Json Session::state() const {
    const std::string text = text_of(root_ / "state.json");
    return text.empty() ? Json{{"panes", Json::array()}} : Json::parse(text);
}

Json Session::wait_until(const std::string &what, const std::function<bool(const Json &)> &holds, double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(time_factor * seconds);
    for (;;) {
        Json now = state();
        if (now.contains("scene") && holds(now))
            return now;
        if (std::chrono::steady_clock::now() > end || !program_->running()) {
            now.erase("widgets");
            ADD_FAILURE() << "waited in vain for: " << what << (program_->running() ? "" : " (the program has ended)")
                          << "\nstate: " << now.dump() << "\nlog: " << text_of(root_ / "log");
            return state();
        }
        sleep(0.01);
    }
}

Json Session::settled() {
    Json before = wait_until("rest", [](const Json &s) { return !s["busy"] && s["opening"] == ""; }, 120);
    for (int calm = 0, i = 0; calm < 3 && i < 200; ++i) {
        sleep(0.05);
        Json now = state();
        calm = now == before ? calm + 1 : 0;
        before = std::move(now);
    }
    return before;
}

void Session::xdotool(std::vector<std::string> words) const {
    words.insert(words.begin(), "xdotool");
    output_of(words, {{"DISPLAY", screen_->display()}});
}

void Session::key(const std::string &name) { press("key", name); }

void Session::hold(const std::string &name) { press("keydown", name); }

void Session::let_go(const std::string &name) { xdotool({"keyup", name}); }

void Session::hold(Point p) {
    move(p);
    sleep(0.1); // the control under the mouse is known with the next frame
    xdotool({"mousedown", "1"});
}

void Session::let_go() { xdotool({"mouseup", "1"}); }

void Session::press(const std::string &how, const std::string &name) {
    const int before = state().value("inputs", 0);
    xdotool({how, name});
    for (int i = 0; i < 1000 * time_factor && program_->running() && state().value("inputs", 0) == before; ++i)
        sleep(0.005);
}

void Session::type(const std::string &text) { xdotool({"type", "--delay", "20", text}); }

void Session::enter() { xdotool({"key", "Return"}); }

void Session::move(Point p) { xdotool({"mousemove", whole(p.x), whole(p.y)}); }

void Session::click(Point p, int button, int times) {
    move(p);
    sleep(0.1); // the control under the mouse is known with the next frame
    xdotool({"click", "--repeat", std::to_string(times), "--delay", "120", std::to_string(button)});
}

void Session::drag(Point from, Point to, int button, const std::string &modifier) {
    move(from);
    sleep(0.1);
    if (!modifier.empty())
        xdotool({"keydown", modifier});
    xdotool({"mousedown", std::to_string(button)});
    sleep(0.1);
    constexpr int n = 8;
    for (int i = 1; i <= n; ++i) {
        const double t = static_cast<double>(i) / n;
        move({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
        sleep(0.02);
    }
    sleep(0.1);
    xdotool({"mouseup", std::to_string(button)});
    if (!modifier.empty())
        xdotool({"keyup", modifier});
}

void Session::drop(const std::filesystem::path &file) {
    output_of({PENUMBRA_DROP_FILE, window_, file.string()}, {{"DISPLAY", screen_->display()}});
}

std::string Session::clipboard() const {
    return output_of({PENUMBRA_READ_CLIPBOARD}, {{"DISPLAY", screen_->display()}});
}

void Session::resize(int width, int height) {
    xdotool({"windowsize", "--sync", window_, whole(width), whole(height)});
    settled();
}

Box Session::widget(const std::string &name) const {
    const Json widgets = state().value("widgets", Json::object());
    if (!widgets.contains(name)) {
        ADD_FAILURE() << "no control " << name << " is shown; there are: " << [&] {
            std::string all;
            for (const auto &[key, value] : widgets.items())
                all += key + " ";
            return all;
        }();
        return {};
    }
    const auto &r = widgets[name];
    return {static_cast<int>(r[0].get<double>()), static_cast<int>(r[1].get<double>()),
            static_cast<int>(r[2].get<double>()), static_cast<int>(r[3].get<double>())};
}

Point Session::middle(const std::string &name) const {
    const Box b = widget(name);
    return {b.x + 0.5 * b.width, b.y + 0.5 * b.height};
}

void Session::click(const std::string &name) { click(middle(name)); }

std::string Session::log() const { return text_of(root_ / "log"); }

void Session::end_display() { screen_.reset(); }

void Session::take_first_object() {
    key("o");
    wait_until("the objects", [](const Json &s) { return s["inspector"] == "objects"; });
    const Json objects = settled();
    for (const auto &[name, box] : objects["widgets"].items())
        if (name.starts_with("object.")) {
            click(name);
            break;
        }
}

Screenshot Session::shot() {
    settled();
    return screen_->shot();
}

} // namespace penumbra::gui
