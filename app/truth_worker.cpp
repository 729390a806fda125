#include "truth_worker.h"

#include "core/percent.h"
#include "files/find_reference.h"
#include "iteration/error_map.h"

#include <algorithm>
#include <utility>

namespace penumbra {

TruthWorker::TruthWorker(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](const std::stop_token &stop) { work(stop); }) {}

TruthWorker::~TruthWorker() {
    thread_.request_stop();
    const std::scoped_lock lock(mutex_);
    if (running_)
        cancel_.raise();
}

void TruthWorker::aim(TruthGoal goal) {
    {
        const std::scoped_lock lock(mutex_);
        goal_ = std::move(goal);
        if (running_ && !still_wanted(*running_))
            cancel_.raise();
    }
    changed_goal_.notify_one();
}

std::vector<TruthReport> TruthWorker::take_reports() {
    const std::scoped_lock lock(reports_mutex_);
    return std::exchange(reports_, {});
}

void TruthWorker::work(const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    bool rested = true;
    const auto next = [&] {
        forget_the_past();
        return next_task();
    };
    while (!stop.stop_requested()) {
        if (auto task = next()) {
            running_ = task;
            rested = false;
            lock.unlock();
            do_task(*task);
            lock.lock();
            running_.reset();
            cancel_.lower();
        } else {
            if (!std::exchange(rested, true))
                report(TruthRested{});
            changed_goal_.wait(lock, stop, [&] { return next().has_value(); });
        }
    }
}

void TruthWorker::forget_the_past() {
    if (goal_.scene && scene_ != goal_.scene) {
        scene_ = goal_.scene;
        mapper_.reset();
        followed_ = 0;
        changed_ = {};
        mapped_.clear();
        failed_ = false;
    }
    if (change_ != goal_.change || (change_ && run_ != goal_.run)) {
        change_ = goal_.change;
        changed_ = {};
        mapped_.clear();
        failed_ = false;
    }
    run_ = goal_.run;
}

ErrorMapper *TruthWorker::mapper_for(const TruthGoal &goal, const Snapshot &solution) const {
    return goal.change ? changed_[static_cast<std::size_t>(solution.options.strategy)].get() : mapper_.get();
}

std::optional<TruthWorker::Task> TruthWorker::next_task() const {
    if (!goal_.scene || failed_)
        return std::nullopt;
    if (goal_.profile && goal_.profile->id != followed_)
        return Task{mapper_ ? Kind::follow : Kind::find, goal_, {}};
    for (const Judging &judging : goal_.solutions)
        if (!mapped_.contains({judging.solution->version, judging.against()})) {
            const Kind missing = goal_.change ? Kind::change : Kind::find;
            const bool can_map = judging.minus || mapper_for(goal_, *judging.solution);
            return Task{can_map ? Kind::map : missing, goal_, judging};
        }
    return std::nullopt;
}

bool TruthWorker::still_wanted(const Task &task) const {
    if (goal_.scene != task.goal.scene)
        return false;
    const auto wants = [&](const auto &solution) { return std::ranges::any_of(goal_.solutions, solution); };
    switch (task.kind) {
    case Kind::find:
        return goal_.profile || (!goal_.change && wants([](const Judging &j) { return !j.minus; }));
    case Kind::change:
        return goal_.change == task.goal.change && goal_.run == task.goal.run &&
               wants([&](const Judging &j) { return j.solution->options.strategy == task.judging.solution->options.strategy; });
    case Kind::follow:
        return goal_.profile && goal_.profile->id == task.goal.profile->id;
    case Kind::map:
        return goal_.change == task.goal.change && wants([&](const Judging &j) { return j == task.judging; });
    }
    return false;
}

void TruthWorker::do_task(const Task &task) {
    try {
        switch (task.kind) {
        case Kind::find:
            find(task);
            break;
        case Kind::change:
            solve_changed(task);
            break;
        case Kind::follow: {
            const ProfileQuestion &q = *task.goal.profile;
            report(TruthDoing{"following the line"});
            auto points = true_profile(mapper_->truth(), q.surface, q.line, n_profile_points, q.breaks, &cancel_);
            report(ProfileFollowed{q.id, std::move(points)});
            const std::scoped_lock lock(mutex_);
            followed_ = q.id;
            break;
        }
        case Kind::map:
            map(task);
            break;
        }
    } catch (const Cancelled &) {
        // Something else is wanted now.
    } catch (const std::exception &e) {
        report(TruthFailed{e.what()});
        const std::scoped_lock lock(mutex_);
        failed_ = true;
    }
}

void TruthWorker::find(const Task &task) {
    report(TruthDoing{"finding the truth"});
    const auto told = [&](const Counters &c) {
        report(TruthDoing{"solving a reference: step " + std::to_string(c.iteration) + ", " +
                          std::to_string(c.patches) + " patches" +
                          (c.estimated_error >= 0 ? ", good to " + percent(c.estimated_error) : "")});
    };
    const Truth truth = truth_of(task.goal.scene, find_reference(task.goal.scene, picture_tolerance, &cancel_, told));
    const double error = truth.error;
    auto mapper = std::make_unique<ErrorMapper>(truth);
    {
        const std::scoped_lock lock(mutex_);
        mapper_ = std::move(mapper);
    }
    report(TruthFound{task.goal.scene, error});
}

void TruthWorker::map(const Task &task) {
    const auto &[solution, minus] = task.judging;
    const char *mapping = minus ? "measuring the difference" : task.goal.change ? "measuring the change" : "measuring the error";
    report(TruthDoing{mapping});
    const auto told = [&](int percent) { report(TruthDoing{mapping + (": " + std::to_string(percent) + " %")}); };
    std::optional<ErrorMapper> of_two;
    if (minus)
        of_two.emplace(truth_in(minus));
    ErrorMapper &mapper = of_two ? *of_two : *mapper_for(task.goal, *solution);
    report(ErrorsMapped{task.goal.scene, mapper.map(*solution, &cancel_, told)});
    const std::scoped_lock lock(mutex_);
    mapped_.emplace(solution->version, task.judging.against());
}

void TruthWorker::solve_changed(const Task &task) {
    const std::string with = "solving with " + words(*task.goal.change);
    report(TruthDoing{with});
    const auto told = [&](const Counters &c) {
        report(TruthDoing{with + ": step " + std::to_string(c.iteration) + ", " + std::to_string(c.patches) + " patches"});
    };
    const Options &options = task.judging.solution->options;
    auto mapper = std::make_unique<ErrorMapper>(
        with_change(task.goal.scene, options, *task.goal.change, &cancel_, told));
    const std::scoped_lock lock(mutex_);
    changed_[static_cast<std::size_t>(options.strategy)] = std::move(mapper);
}

void TruthWorker::report(TruthReport report) {
    {
        const std::scoped_lock lock(reports_mutex_);
        reports_.push_back(std::move(report));
    }
    wake_();
}

} // namespace penumbra
