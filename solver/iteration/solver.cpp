#include "iteration/solver.h"

#include "core/parallel.h"
#include "iteration/element_report.h"
#include "iteration/known_curves.h"
#include "iteration/state.h"
#include "iteration/quadratic.h"
#include "iteration/take_snapshot.h"
#include "iteration/tolerance_control.h"
#include "measure/direct.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace penumbra {

double Setting::largest_reflectance() const {
    double most = 0;
    for (int s = 0; s < scene->n_surfaces(); ++s)
        most = std::max(most, scene->reflectance(SurfaceId(s)).maxCoeff());
    return most;
}

Transport Setting::transport(double threshold, const Cancel *cancel) const {
    // On the way to a tolerance links of the first, loose thresholds stay to the end.
    if (options.tolerance)
        threshold = std::min(threshold, *options.tolerance > 0 ? 2 * *options.tolerance : 1e-3);
    const double accuracy = std::clamp(0.1 * threshold, 1e-7, 1e-2);
    const double share = std::min(1.0, 10 * (1 - largest_reflectance()));
    return {*scene, *blockers, accuracy, std::max(accuracy * share, 1e-9), cancel,
            options.effects[Effect::visibility] == Switch::on, options.effects[Effect::hidden_pairs] == Switch::on};
}

/// Light after the last bounce that is simulated, of the error that is asked for.
constexpr double bounces_share = 0.05;

struct Solver::Parts {
    Setting setting;
    std::shared_ptr<const State> state;
};

namespace {

std::shared_ptr<const State> first_state(const Setting &setting, const Cancel *cancel) {
    auto state = std::make_shared<State>();
    const Scene &scene = *setting.scene;
    state->forest = plant(scene, setting.options.effective_order(), setting.options.basis);
    state->interactions.resize(state->forest.elements.size());
    state->linked.assign(scene.surfaces.size(), std::vector<char>(scene.surfaces.size(), 0));
    state->irradiance.setZero(state->forest.n_coefficients, 3);
    push_pull(state->forest, scene, state->irradiance, state->radiosity);
    for (int s = 0; s < scene.n_surfaces(); ++s)
        if (scene.reflects(SurfaceId(s)))
            state->counters.patches += static_cast<int>(state->forest.roots[static_cast<std::size_t>(s)].size());
    const int n = state->forest.elements.front().basis.n_functions();
    state->counters.coefficients = state->counters.patches * n;
    state->counters.threshold = first_threshold(setting.options);
    state->counters.channels = setting.plan.channels.n_solved();
    trace_emitters(setting, *state, cancel);
    state->counters.curves = static_cast<int>(state->curves->curves().size());
    state->sentence = "only the emitters shine: nothing has been gathered yet";
    return state;
}

double seconds_of(const auto &work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

Solver::Solver(std::shared_ptr<const Scene> scene, const Options &options, const Cancel *cancel)
    : parts_(std::make_unique<Parts>()) {
    Setting &setting = parts_->setting;
    setting.scene = options.effects[Effect::colour] == Switch::off
                        ? std::make_shared<const Scene>(without_colour(*scene))
                        : std::move(scene);
    setting.options = options;
    setting.plan = make_plan(*setting.scene, options.effects, bounces_share * options.tolerance.value_or(options.threshold));
    setting.blockers = std::make_unique<const Blockers>(*setting.scene, setting.plan.can_block);
    if (setting.plan.interreflection && setting.plan.anything_blocks())
        setting.rays = std::make_unique<const RayScene>(*setting.scene);
    if (options.effects[Effect::hidden_pairs] != Switch::on && setting.plan.anything_blocks())
        setting.hidden_pairs = std::make_unique<const HiddenPairs>(*setting.scene);
    if (cancel)
        cancel->check();
    parts_->state = first_state(setting, cancel);
}

Solver::~Solver() = default;

void Solver::sub_step(const Cancel *cancel) {
    const Setting &setting = parts_->setting;
    set_threads(setting.options.threads);
    auto next = std::make_shared<State>(*parts_->state);
    Counters &c = next->counters;
    double seconds = 0;
    switch (next->phase) {
    case Phase::start:
    case Phase::pushed_pulled: {
        const Counters before = c;
        c = {};
        c.iteration = before.iteration + 1;
        c.total_work = before.total_work;
        c.seconds = before.seconds;
        c.threshold = before.threshold;
        c.channels = before.channels;
        seconds = c.refine_s = seconds_of([&] { refine(setting, *next, cancel); });
        c.total_work += c.work;
        if (!c.refined) { // the same elements and links as before
            c.estimated_error = before.estimated_error;
            c.error_limit = before.error_limit;
            c.error_bound = before.error_bound;
        }
        next->phase = Phase::refined;
        break;
    }
    case Phase::refined:
        next->events.reset();
        seconds = c.gather_s = seconds_of([&] { gather(setting, *next, cancel); });
        next->phase = Phase::gathered;
        break;
    case Phase::gathered:
        c.push_pull_s = seconds_of([&] { push_pull(setting, *next); });
        c.measure_s = seconds_of([&] { control(setting, *next, cancel); });
        seconds = c.push_pull_s + c.measure_s;
        next->phase = Phase::pushed_pulled;
        break;
    }
    c.seconds += seconds;
    parts_->state = std::move(next);
}

void Solver::step(const Cancel *cancel) {
    const auto before = parts_->state;
    try {
        do
            sub_step(cancel);
        while (phase() != Phase::pushed_pulled);
    } catch (...) {
        parts_->state = before;
        throw;
    }
}

bool Solver::run(const Cancel *cancel) {
    while (!ended() && counters().iteration < options().max_iterations)
        step(cancel);
    return converged();
}

void Solver::measure(const Cancel *cancel) {
    const auto &state = parts_->state;
    if (state->counters.estimated_error >= 0 || state->counters.iteration == 0)
        return;
    auto measured = std::make_shared<State>(*state);
    penumbra::measure(parts_->setting, *measured, 0, cancel);
    parts_->state = std::move(measured);
}

Phase Solver::phase() const { return parts_->state->phase; }
const Counters &Solver::counters() const { return parts_->state->counters; }
const Scene &Solver::scene() const { return *parts_->setting.scene; }
const Options &Solver::options() const { return parts_->setting.options; }
std::shared_ptr<const State> Solver::state() const { return parts_->state; }
void Solver::restore(std::shared_ptr<const State> state) { parts_->state = std::move(state); }

std::shared_ptr<const Snapshot> Solver::snapshot(bool with_error) const {
    auto snapshot = take_snapshot(parts_->setting, *parts_->state);
    if (with_error && parts_->setting.one_bounce())
        snapshot->error = direct_error(scene(), *parts_->setting.blockers, parts_->state->forest, parts_->state->radiosity);
    return snapshot;
}

std::shared_ptr<const Snapshot> Solver::reconstruction(const State &state, bool with_error,
                                                       const Cancel *cancel) const {
    const QuadraticField field = reconstruct(parts_->setting, state, cancel);
    auto snapshot = take_snapshot(parts_->setting, state, field);
    if (with_error && parts_->setting.one_bounce())
        snapshot->error = direct_error(scene(), *parts_->setting.blockers, field.forest, field.radiosity);
    return snapshot;
}

std::shared_ptr<const ElementReport> Solver::inspect(const State &state, const ElementQuestion &question,
                                                     const Cancel *cancel) const {
    return std::make_shared<const ElementReport>(element_report(parts_->setting, state, question, cancel));
}

} // namespace penumbra
