#include "solve_worker.h"

#include "core/error.h"
#include "core/parallel.h"
#include "iteration/own_bytes.h"

#include <algorithm>
#include <utility>

namespace penumbra {

namespace {
constexpr std::int64_t most_kept = std::int64_t(512) << 20; // bytes of states that are looked back at
}

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
            else if (task->kind == Kind::reconstruct)
                reconstruct(*task);
            else
                inspect(*task);
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
    if (auto inspection = next_inspection())
        return inspection;
    std::optional<Task> next;
    for (const Stand &stand : goal_->stands) {
        const Course &course = courses_[static_cast<std::size_t>(stand.strategy)];
        const bool known = run_ == goal_->run;
        const int position = known ? course.position : -1;
        const bool done = known && (course.ended || position >= stand.position);
        if (!done && (!next || position + 1 < next->position))
            next = Task{*goal_, stand.strategy, position + 1};
    }
    return next ? next : next_reconstruction();
}

std::optional<SolveWorker::Task> SolveWorker::next_reconstruction() const {
    for (const Stand &stand : goal_->reconstructed) {
        const Course &course = courses_[static_cast<std::size_t>(stand.strategy)];
        const int position = std::min(stand.position, static_cast<int>(course.moments.size()) - 1);
        if (position >= 0 && !course.moments[static_cast<std::size_t>(position)].reconstructed)
            return Task{*goal_, stand.strategy, position, Kind::reconstruct};
    }
    return std::nullopt;
}

std::optional<SolveWorker::Task> SolveWorker::next_inspection() const {
    if (!goal_->inspected || run_ != goal_->run)
        return std::nullopt;
    const auto &[strategy, wanted] = goal_->inspected->stand;
    const auto &moments = courses_[static_cast<std::size_t>(strategy)].moments;
    const int position = std::min(wanted, static_cast<int>(moments.size()) - 1);
    if (position < 0 || (answered_ && answered_->asked == *goal_->inspected &&
                         answered_->version == moments[static_cast<std::size_t>(position)].version))
        return std::nullopt;
    return Task{*goal_, strategy, position, Kind::inspect};
}

bool SolveWorker::still_wanted(const Task &task) const {
    if (!goal_ || goal_->run != task.goal.run)
        return false;
    const auto reaches = [&](const Stand &stand) { return stand.strategy == task.strategy && stand.position >= task.position; };
    if (task.kind == Kind::inspect)
        return goal_->inspected == task.goal.inspected;
    if (task.kind == Kind::reconstruct)
        return goal_->reconstructed == task.goal.reconstructed;
    return std::ranges::any_of(goal_->stands, reaches);
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
        keep(course, snapshot->version);
        report(Reached{task.goal.run, task.strategy, task.position, snapshot, course.ended});
    } catch (const Cancelled &) {
        // The solver stands where it stood before the phase.
    } catch (const std::exception &e) {
        course.ended = true;
        report(Failed{task.goal.run, task.strategy, e.what()});
    }
}

/// Remembers the solver's state; where all take too much room, the oldest of multiwavelets go (of constants quadratics
/// are made).
void SolveWorker::keep(Course &course, std::uint64_t version) {
    const auto state = course.solver->state();
    const State *before = course.moments.empty() ? nullptr : course.moments.back().state.get();
    course.moments.push_back({state, version, own_bytes(*state, before)});
    std::int64_t bytes = 0;
    for (const Course &c : courses_)
        for (const Moment &m : c.moments)
            bytes += m.bytes;
    for (std::size_t position = 0; bytes > most_kept; ++position) {
        bool any_left = false;
        for (Course &c : courses_) {
            if (position + 1 >= c.moments.size())
                continue; // the newest stays
            any_left = true;
            Moment &old = c.moments[position];
            if (is_constant(c.solver->options().strategy) || !old.state)
                continue;
            old.state.reset();
            bytes -= std::exchange(old.bytes, 0);
        }
        if (!any_left)
            break;
    }
}

void SolveWorker::inspect(const Task &task) {
    const Course &course = courses_[static_cast<std::size_t>(task.strategy)];
    const Moment &moment = course.moments[static_cast<std::size_t>(task.position)];
    const Inspection &asked = *task.goal.inspected;
    try {
        auto answer = moment.state ? course.solver->inspect(*moment.state, asked.question, &cancel_) : nullptr;
        answered_ = Answered{asked, moment.version};
        report(Inspected{task.goal.run, moment.version, asked, std::move(answer)});
    } catch (const Cancelled &) {
        // Asked again, if it still is wanted.
    } catch (const std::exception &e) {
        answered_ = Answered{asked, moment.version};
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
        report(Opened{read_file_(name), name});
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
