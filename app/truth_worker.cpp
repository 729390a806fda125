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
    changed_.notify_one();
}

std::vector<TruthReport> TruthWorker::take_reports() {
    const std::scoped_lock lock(reports_mutex_);
    return std::exchange(reports_, {});
}

void TruthWorker::work(const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    bool rested = true;
    while (!stop.stop_requested()) {
        if (auto task = next_task()) {
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
            changed_.wait(lock, stop, [&] { return next_task().has_value(); });
        }
    }
}

std::optional<TruthWorker::Task> TruthWorker::next_task() const {
    const bool follow = goal_.profile.has_value();
    if (!goal_.scene || (goal_.solutions.empty() && !follow))
        return std::nullopt;
    if (scene_ != goal_.scene)
        return Task{Kind::find, goal_, nullptr};
    if (failed_ || !mapper_)
        return std::nullopt;
    if (follow && goal_.profile->id != followed_)
        return Task{Kind::follow, goal_, nullptr};
    for (const auto &solution : goal_.solutions)
        if (!mapped_.contains(solution->version))
            return Task{Kind::map, goal_, solution};
    return std::nullopt;
}

bool TruthWorker::still_wanted(const Task &task) const {
    if (goal_.scene != task.goal.scene)
        return false;
    switch (task.kind) {
    case Kind::find:
        return !goal_.solutions.empty() || goal_.profile;
    case Kind::follow:
        return goal_.profile && goal_.profile->id == task.goal.profile->id;
    case Kind::map:
        return std::ranges::find(goal_.solutions, task.solution) != goal_.solutions.end();
    }
    return false;
}

void TruthWorker::do_task(const Task &task) {
    try {
        switch (task.kind) {
        case Kind::find:
            find(task);
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
        case Kind::map: {
            report(TruthDoing{"measuring the error"});
            const auto told = [&](int percent) {
                report(TruthDoing{"measuring the error: " + std::to_string(percent) + " %"});
            };
            report(ErrorsMapped{task.goal.scene, mapper_->map(*task.solution, &cancel_, told)});
            const std::scoped_lock lock(mutex_);
            mapped_.insert(task.solution->version);
            break;
        }
        }
    } catch (const Cancelled &) {
        // Something else is wanted now.
    } catch (const std::exception &e) {
        report(TruthFailed{e.what()});
        const std::scoped_lock lock(mutex_);
        scene_ = task.goal.scene;
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
        scene_ = task.goal.scene;
        mapper_ = std::move(mapper);
        mapped_.clear();
        followed_ = 0;
        failed_ = false;
    }
    report(TruthFound{task.goal.scene, error});
}

void TruthWorker::report(TruthReport report) {
    {
        const std::scoped_lock lock(reports_mutex_);
        reports_.push_back(std::move(report));
    }
    wake_();
}

} // namespace penumbra
