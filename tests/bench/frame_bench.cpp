// Frames of one pane of 1280x720 as the window draws them, with one sample a pixel while the view moves and four when
// it rests, and bringing a snapshot to the GPU.
#include "solved.h"

#include "capture.h"
#include "core/error.h"
#include "gl/framebuffer.h"
#include "render/pane_renderer.h"
#include "window/offscreen.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace penumbra {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int width = 1280, height = 720;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Case {
    const char *scene;
    Strategy strategy;
    double threshold;
    int curve = -1; ///< in the limelight, with its critical surface
};

/// Of the whole process, as in the window; null where there is no GL.
const Offscreen *context() {
    static const auto made = []() -> std::unique_ptr<Offscreen> {
        try {
            return std::make_unique<Offscreen>();
        } catch (const Unavailable &) {
            return nullptr;
        }
    }();
    return made.get();
}

/// Keeps all cores solving for as long as it lives.
class Solving {
public:
    Solving()
        : scene_(bundled("cornell-box")), thread_([this] {
              try {
                  while (true) {
                      Solver solver(scene_, options_of(Strategy::discontinuity_wavelet, 0.002), &cancel_);
                      solver.run(&cancel_);
                  }
              } catch (const Cancelled &) {
              }
          }) {}
    ~Solving() { cancel_.raise(); }
    Solving(const Solving &) = delete;
    Solving &operator=(const Solving &) = delete;

private:
    std::shared_ptr<const Scene> scene_;
    Cancel cancel_;
    std::jthread thread_;
};

bool is_blank(const Image &image) {
    for (std::size_t i = 3; i < image.rgb.size(); ++i)
        if (image.rgb[i] != image.rgb[i - 3])
            return false;
    return true;
}

/// The camera orbits by a degree a frame. A frame ends when its pixels are there (glFinish).
void frames(benchmark::State &state, const Case &c, int samples, bool solving) {
    if (!context()) {
        state.SkipWithError("no off-screen GL here");
        return;
    }
    const auto scene = bundled(c.scene);
    Solver solver(scene, options_of(c.strategy, c.threshold));
    solver.run();
    const auto snapshot = solver.snapshot();
    PaneRenderer renderer;
    renderer.upload(snapshot);
    const gl::Framebuffer kept(width, height, gl::Framebuffer::Colour::srgb8, 1);
    std::optional<gl::Framebuffer> sampled;
    if (samples > 1)
        sampled.emplace(width, height, gl::Framebuffer::Colour::srgb8, samples);
    Camera camera = first_view(*scene, *snapshot, static_cast<double>(width) / height);
    Look look;
    look.spotlight.curve = c.curve;
    const auto draw = [&] {
        (sampled ? *sampled : kept).bind();
        renderer.draw(camera, look, {0, 0, width, height}, height);
        if (sampled)
            kept.resolve(*sampled);
        glFinish();
    };
    draw(); // the driver compiles its shaders with the first frame
    if (is_blank(read_pixels(0, 0, width, height))) {
        state.SkipWithError("nothing was drawn");
        return;
    }
    std::optional<Solving> others;
    if (solving)
        others.emplace();
    std::vector<double> times;
    for (auto _ : state) {
        camera = orbit(camera, 0.01745, 0, camera.target);
        const auto start = Clock::now();
        draw();
        times.push_back(seconds_since(start));
        state.SetIterationTime(times.back());
    }
    std::ranges::sort(times);
    state.counters["median_ms"] = 1e3 * times[times.size() / 2];
    state.counters["max_ms"] = 1e3 * times.back();
    state.counters["patches"] = static_cast<double>(snapshot->patches.size());
}

/// Two snapshots of one solution by turns, so that neither is there already.
void upload(benchmark::State &state, const Case &c) {
    if (!context()) {
        state.SkipWithError("no off-screen GL here");
        return;
    }
    Solver solver(bundled(c.scene), options_of(c.strategy, c.threshold));
    solver.run();
    const auto one = solver.snapshot(), other = solver.snapshot();
    PaneRenderer renderer;
    bool turn = false;
    for (auto _ : state) {
        renderer.upload(turn ? one : other);
        glFinish();
        turn = !turn;
    }
    state.counters["patches"] = static_cast<double>(one->patches.size());
}

const bool registered = [] {
    std::vector<Case> cases;
    for (const Strategy strategy : all_strategies)
        cases.push_back({"figure-4", strategy, 0.02});
    cases.push_back({"cornell-box", Strategy::discontinuity_wavelet, 0.02});
    for (const int curve : {-1, 60})
        cases.push_back({"skew-blockers", Strategy::discontinuity_wavelet, 0.02, curve});
    for (const Case &c : cases) {
        const std::string of = "/" + std::string(c.scene) + "/" + std::string(name(c.strategy)) +
                               (c.curve >= 0 ? "/critical_surface" : "");
        for (const int samples : {1, 4})
            for (const bool solving : {false, true}) {
                const std::string title =
                    std::string("frame/") + (samples == 1 ? "moving" : "resting") + (solving ? "/solving" : "/idle") + of;
                benchmark::RegisterBenchmark(title.c_str(), [=](benchmark::State &state) {
                    frames(state, c, samples, solving);
                })->UseManualTime()->Iterations(60)->Unit(benchmark::kMillisecond);
            }
        benchmark::RegisterBenchmark(("upload" + of).c_str(), [=](benchmark::State &state) { upload(state, c); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

} // namespace

} // namespace penumbra
