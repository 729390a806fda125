#include "solve_worker.h"

#include "core/error.h"
#include "core/parallel.h"

#include <algorithm>
#include <utility>

namespace penumbra {

SolveWorker::SolveWorker(ReadFile read_file, std::function<void()> wake)
    : read_file_(std::move(read_file)), wake_(std::move(wake)),
      thread_([this](const std::stop_token &stop) { work(stop); }) {}

SolveWorker::~SolveWorker() {
    thread_.request_stop();
    // Between its look at the stop token and running_ the worker holds the mutex, so that no phase can slip through.
    const std::scoped_lock lock(mutex_);
    if (running_)
        cancel_.raise();
}

void SolveWorker::open(std::string name_or_file) {
    {
        const std::scoped_lock lock(mutex_);
        to_open_ = std::move(name_or_file);
    }
    changed_.notify_one();
}

void SolveWorker::aim(Goal goal) {
    {
        const std::scoped_lock lock(mutex_);
        goal_ = std::move(goal);
        if (running_ && !still_wanted(*running_))
            cancel_.raise();
    }
    changed_.notify_one();
}

void SolveWorker::cancel() {
    {
        const std::scoped_lock lock(mutex_);
        goal_.reset();
        to_open_.reset();
        cancel_asked_ = true;
        if (running_)
            cancel_.raise();
    }
    changed_.notify_one();
}

std::vector<Report> SolveWorker::take_reports() {
    const std::scoped_lock lock(reports_mutex_);
    return std::exchange(reports_, {});
}

void SolveWorker::work(const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    bool rested = true;
    while (!stop.stop_requested()) {
        if (std::exchange(cancel_asked_, false)) {
            report(Stopped{});
            rested = true;
        } else if (to_open_) {
            const std::string name = *std::exchange(to_open_, std::nullopt);
            lock.unlock();
            read(name);
            lock.lock();
        } else if (const auto task = next_task()) {
            running_ = task;
            rested = false;
            lock.unlock();
            if (task->kind == Kind::advance)
                advance(*task);
            else
                reconstruct(*task);
            lock.lock();
            running_.reset();
            cancel_.lower();
        } else {
            if (!std::exchange(rested, true))
                report(Rested{});
            changed_.wait(lock, stop, [&] { return cancel_asked_ || to_open_ || next_task(); });
        }
    }
}

/// The shown strategy that is farthest behind the goal goes first, so that linked panes move together.
std::optional<SolveWorker::Task> SolveWorker::next_task() const {
    if (!goal_ || !goal_->scene)
        return std::nullopt;
    std::optional<Task> next;
    for (const Strategy strategy : goal_->strategies) {
        const Course &course = courses_[static_cast<std::size_t>(strategy)];
        const bool known = run_ == goal_->run;
        const int position = known ? course.position : -1;
        const bool done = known && (course.ended || position >= goal_->position);
        if (!done && (!next || position + 1 < next->position))
            next = Task{*goal_, strategy, position + 1};
    }
    return next ? next : next_reconstruction();
}

std::optional<SolveWorker::Task> SolveWorker::next_reconstruction() const {
    for (const Strategy strategy : goal_->reconstructed) {
        const Course &course = courses_[static_cast<std::size_t>(strategy)];
        const int position = std::min(goal_->position, static_cast<int>(course.moments.size()) - 1);
        if (position >= 0 && !course.moments[static_cast<std::size_t>(position)].reconstructed)
            return Task{*goal_, strategy, position, Kind::reconstruct};
    }
    return std::nullopt;
}

bool SolveWorker::still_wanted(const Task &task) const {
    if (task.kind == Kind::reconstruct)
        return goal_ && goal_->run == task.goal.run && goal_->position == task.goal.position &&
               std::ranges::find(goal_->reconstructed, task.strategy) != goal_->reconstructed.end();
    return goal_ && goal_->run == task.goal.run && goal_->position >= task.position &&
           std::ranges::find(goal_->strategies, task.strategy) != goal_->strategies.end();
}

void SolveWorker::advance(const Task &task) {
    if (run_ != task.goal.run) {
        courses_ = {};
        run_ = task.goal.run;
        set_threads(task.goal.options.threads);
    }
    Course &course = courses_[static_cast<std::size_t>(task.strategy)];
    report(Begun{task.goal.run, task.strategy, task.position});
    try {
        if (course.solver) {
            course.solver->sub_step(&cancel_);
        } else {
            Options options = task.goal.options;
            options.strategy = task.strategy;
            course.solver = std::make_unique<Solver>(task.goal.scene, options, &cancel_);
        }
        course.position = task.position;
        const Counters &counters = course.solver->counters();
        course.ended = course.solver->phase() == Phase::pushed_pulled &&
                       (course.solver->ended() || counters.iteration >= task.goal.options.max_iterations);
        const auto snapshot = course.solver->snapshot(true);
        if (is_constant(task.strategy))
            course.moments.push_back({course.solver->state(), snapshot->version});
        report(Reached{task.goal.run, task.strategy, task.position, snapshot, course.ended});
    } catch (const Cancelled &) {
        // The solver stands where it stood before the phase.
    } catch (const std::exception &e) {
        course.ended = true;
        report(Failed{task.goal.run, task.strategy, e.what()});
    }
}

void SolveWorker::reconstruct(const Task &task) {
    Course &course = courses_[static_cast<std::size_t>(task.strategy)];
    Moment &moment = course.moments[static_cast<std::size_t>(task.position)];
    moment.reconstructed = true;
    try {
        report(Reconstructed{task.goal.run, moment.version,
                             course.solver->reconstruction(*moment.state, true, &cancel_)});
    } catch (const Cancelled &) {
        moment.reconstructed = false;
    } catch (const std::exception &e) {
        report(Failed{task.goal.run, task.strategy, e.what()});
    }
}

void SolveWorker::read(const std::string &name) {
    try {
        report(Opened{read_file_(name)});
    } catch (const std::exception &e) {
        report(Refused{e.what()});
    }
}

void SolveWorker::report(Report report) {
    {
        const std::scoped_lock lock(reports_mutex_);
        reports_.push_back(std::move(report));
    }
    wake_();
}

} // namespace penumbra
