// How the window keeps up while the scene `office` is solved: times of its frames, at rest and while the view is dragged, and
// how long Esc takes to stop the solver. Under a virtual display of its own, by the software rasteriser.
#include "gui/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <unistd.h>
#include <vector>

namespace penumbra::gui {
namespace {

constexpr int width = 1280, height = 720;

void rest(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

std::string load() {
    std::ifstream in("/proc/loadavg");
    std::string one, five, fifteen;
    in >> one >> five >> fifteen;
    return one;
}

double quantile(std::vector<double> values, double q) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

void print_row(const std::string &what, const std::vector<double> &ms) {
    if (ms.empty())
        fmt::print("| {} | 0 | | | |\n", what);
    else
        fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} |\n", what, ms.size(), quantile(ms, 0.5), quantile(ms, 0.95), quantile(ms, 1));
}

/// Of those frames of the file.
std::vector<double> times(const std::filesystem::path &file, bool busy, bool moving) {
    std::ifstream in(file);
    std::vector<double> all;
    std::string row;
    std::getline(in, row); // names
    double seconds = 0, ms = 0;
    int was_busy = 0, was_moving = 0;
    while (std::getline(in, row))
        if (std::sscanf(row.c_str(), "%lf,%lf,%d,%d", &seconds, &ms, &was_busy, &was_moving) == 4 && (was_busy != 0) == busy &&
            (was_moving != 0) == moving)
            all.push_back(ms);
    return all;
}

Json wait_until_busy(Session &session) {
    return session.wait_until("the solver", [](const Json &s) { return s["busy"] == true; });
}

void drag_about(Session &session, double seconds) {
    const Point middle = session.middle("pane 0");
    session.move(middle);
    rest(2); // a frame may be long in coming; a press before it would go nowhere
    session.hold(middle);
    rest(1);
    const auto begun = std::chrono::steady_clock::now();
    for (double t = 0; t < seconds; t = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count())
        session.move({middle.x + 120 * std::sin(t), middle.y + 40 * std::sin(1.7 * t)});
    session.let_go();
}

void measure_frames(double seconds) {
    const auto file = std::filesystem::temp_directory_path() / fmt::format("penumbra-frames-{}.csv", ::getpid());
    {
        Session session({"office", "--tolerance", "0.01", "--frame-times", file.string()}, width, height);
        session.resize(width, height);
        drag_about(session, seconds);
        session.key("End");
        wait_until_busy(session);
        rest(seconds);
        drag_about(session, seconds);
        session.key("ctrl+q");
        session.program().wait(60);
    }
    fmt::print("| frames [ms] | number | median | 95 % | worst |\n| --- | ---: | ---: | ---: | ---: |\n");
    print_row("idle, view dragged", times(file, false, true));
    print_row("solving, view at rest", times(file, true, false));
    print_row("solving, view dragged", times(file, true, true));
    std::filesystem::remove(file);
}

void measure_cancel(int n) {
    std::vector<double> ms;
    Session session({"office", "--tolerance", "0.01"}, width, height);
    session.resize(width, height);
    for (int i = 0; i < n; ++i) {
        session.key("Home");
        session.settled();
        session.click("order " + std::to_string(3 + i % 2)); // starts anew
        session.settled();
        const double before = session.state()["cancel_ms"];
        session.key("End");
        wait_until_busy(session);
        rest(0.3 + 0.37 * i);
        session.key("Escape");
        ms.push_back(session.wait_until("a stop", [&](const Json &s) { return s["cancel_ms"] != before && s["busy"] == false; })["cancel_ms"]);
    }
    fmt::print("\n| Esc to cancelled [ms] | number | median | 95 % | worst |\n| --- | ---: | ---: | ---: | ---: |\n");
    print_row("office", ms);
}

} // namespace
} // namespace penumbra::gui

/// Argument: seconds that each kind of frame is measured for, 20 unless given.
int main(int argc, char **argv) {
    fmt::print("{} threads, load {} when it began\n\n", std::thread::hardware_concurrency(), penumbra::gui::load());
    penumbra::gui::measure_frames(argc > 1 ? std::atof(argv[1]) : 20);
    penumbra::gui::measure_cancel(10);
}
