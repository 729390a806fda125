// The thread that finds out how wrong solutions are: it finds the truth about a scene, maps errors against it, and
// follows it along a line. The window tells it what it would know and takes from a queue what has been found; neither
// side ever waits for the other.
#pragma once

#include "core/cancel.h"
#include "iteration/profile.h"
#include "scene/scene.h"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace penumbra {

struct ErrorMap; // iteration/error_map.h
class ErrorMapper;

/// The truth along a line.
struct ProfileQuestion {
    int id = 0; ///< another number: another line
    ProfileLine line;
    SnapshotSurface surface;    ///< that it runs over
    std::vector<double> breaks; ///< see true_profile()
};

/// A solution that a map is wanted of.
struct Judging {
    std::shared_ptr<const Snapshot> solution;
    std::shared_ptr<const Snapshot> minus; ///< another that it is held against; null: the truth, or what the goal's change makes

    std::uint64_t against() const { return minus ? minus->version : 0; }
    bool operator==(const Judging &) const = default;
};

/// What the window would know; all of one scene.
struct TruthGoal {
    std::shared_ptr<const Scene> scene;
    std::uint64_t run = 0;                                  ///< that the solutions are of
    std::optional<EffectChange> change;     ///< maps are of what it changes; none: of what misses the truth
    std::vector<Judging> solutions;         ///< to be mapped, the most wanted first
    std::optional<ProfileQuestion> profile; ///< goes before the maps

    bool operator==(const TruthGoal &o) const {
        return scene == o.scene && run == o.run && change == o.change && solutions == o.solutions &&
               profile.has_value() == o.profile.has_value() && (!profile || profile->id == o.profile->id);
    }
};

struct TruthDoing { ///< a sentence on what it does
    std::string sentence;
};
struct TruthFound { ///< about a scene
    std::shared_ptr<const Scene> scene;
    double error = 0; ///< Truth::error
};
struct ErrorsMapped {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const ErrorMap> map;
};
struct ProfileFollowed {
    int id = 0;
    std::vector<ProfilePoint> points;
};
struct TruthFailed { ///< one line
    std::string sentence;
};
struct TruthRested {}; ///< nothing left to find out
using TruthReport = std::variant<TruthDoing, TruthFound, ErrorsMapped, ProfileFollowed, TruthFailed, TruthRested>;

class TruthWorker {
public:
    /// `wake` is called from the worker's thread after each report.
    explicit TruthWorker(std::function<void()> wake);
    /// Cancels and joins.
    ~TruthWorker();
    TruthWorker(const TruthWorker &) = delete;
    TruthWorker &operator=(const TruthWorker &) = delete;

    /// Takes the place of the goal before; what that alone wanted is cancelled. Without a scene: nothing is wanted.
    void aim(TruthGoal goal);
    /// What happened since the last call, in order.
    std::vector<TruthReport> take_reports();

private:
    enum class Kind { find, change, follow, map };
    struct Task {
        Kind kind{};
        TruthGoal goal;
        Judging judging; ///< to be mapped, or whose options are to be changed
    };

    void work(const std::stop_token &stop);
    std::optional<Task> next_task() const;
    bool still_wanted(const Task &task) const;
    void do_task(const Task &task);
    void find(const Task &task);
    void solve_changed(const Task &task);
    void map(const Task &task);
    /// Lets go of what is of another scene, run or change than the goal's. While nothing runs.
    void forget_the_past();
    /// Against what the goal's maps are made; null: not known yet.
    ErrorMapper *mapper_for(const TruthGoal &goal, const Snapshot &solution) const;
    void report(TruthReport report);

    std::function<void()> wake_;

    std::mutex mutex_; ///< guards all down to running_
    std::condition_variable_any changed_goal_;
    TruthGoal goal_;
    std::optional<Task> running_;

    std::mutex reports_mutex_;
    std::vector<TruthReport> reports_;

    // Of the worker's thread, written while the mutex is held.
    std::shared_ptr<const Scene> scene_; ///< that all of this is of
    std::unique_ptr<ErrorMapper> mapper_; ///< null: the truth has not been asked for yet, or is not to be had
    std::optional<EffectChange> change_; ///< that maps are of; none: of the truth
    std::uint64_t run_ = 0;              ///< that changed solutions are of
    std::array<std::unique_ptr<ErrorMapper>, 4> changed_; ///< by strategy: against the solution with the change
    std::set<std::pair<std::uint64_t, std::uint64_t>> mapped_; ///< versions, and what they were held against
    int followed_ = 0;               ///< id of the last profile
    bool failed_ = false;            ///< what maps are made against is not to be had
    Cancel cancel_;
    std::jthread thread_; ///< last: it uses all the above
};

} // namespace penumbra
