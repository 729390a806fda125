// The thread that solves. The window tells it where the solutions should stand (a goal, the newest counts) and takes
// what has been computed from a queue; neither side ever waits for the other.
#pragma once

#include "core/cancel.h"
#include "files/open_file.h"
#include "iteration/element_report.h"
#include "iteration/solver.h"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace penumbra {

/// Where a strategy's solution is wanted: phases from the start, see timeline.h.
struct Stand {
    Strategy strategy{};
    int position = 0;

    bool operator==(const Stand &) const = default;
};

/// About an element of a strategy's solution where that stands, or where it ends before.
struct Inspection {
    Stand stand;
    ElementQuestion question;

    bool operator==(const Inspection &) const = default;
};

/// Where the solutions of one run should stand. A run is one scene with one set of options, for all strategies.
struct Goal {
    std::uint64_t run = 0;            ///< another number: start anew
    std::shared_ptr<const Scene> scene;
    Options options;                  ///< of the run; its strategy is not looked at
    std::vector<Stand> stands{};        ///< of the panes
    std::vector<Stand> reconstructed{}; ///< those of them whose constants are drawn as quadratics
    std::optional<Inspection> inspected{}; ///< answered between two phases, at each position

    bool operator==(const Goal &o) const {
        return run == o.run && scene == o.scene && stands == o.stands && reconstructed == o.reconstructed &&
               inspected == o.inspected;
    }
};

struct Opened { ///< a file was read
    OpenedFile file;
    std::string name = {}; ///< that was asked for; empty: it came from no file
};
struct Refused { ///< a file could not be read; one line
    std::string sentence;
};
struct Begun { ///< a phase is being computed
    std::uint64_t run = 0;
    Strategy strategy{};
    int position = 0; ///< that it leads to
};
struct Reached { ///< a strategy stands at a new position
    std::uint64_t run = 0;
    Strategy strategy{};
    int position = 0;
    std::shared_ptr<const Snapshot> snapshot;
    bool ended = false;
};
struct Reconstructed { ///< constants were made into quadratics
    std::uint64_t run = 0;
    std::uint64_t version = 0; ///< of the snapshot of the constants
    std::shared_ptr<const Snapshot> snapshot;
};
struct Inspected { ///< an element was looked at
    std::uint64_t run = 0;
    std::uint64_t version = 0; ///< of the snapshot of the same state
    Inspection asked;
    std::shared_ptr<const ElementReport> report; ///< null: that state is kept no longer
};
struct Failed { ///< a strategy can't go on; one line
    std::uint64_t run = 0;
    Strategy strategy{};
    std::string sentence;
};
struct Stopped {}; ///< cancelled; what was complete stays
struct Rested {};  ///< nothing left to do
using Report = std::variant<Opened, Refused, Begun, Reached, Reconstructed, Inspected, Failed, Stopped, Rested>;

class SolveWorker {
public:
    using ReadFile = std::function<OpenedFile(const std::string &)>;

    /// `read_file` throws what its caller should be told; `wake` is called from the worker's thread after each report.
    SolveWorker(ReadFile read_file, std::function<void()> wake);
    /// Cancels and joins.
    ~SolveWorker();
    SolveWorker(const SolveWorker &) = delete;
    SolveWorker &operator=(const SolveWorker &) = delete;

    /// Reads a file as soon as the present phase is over; the answer is Opened or Refused.
    void open(std::string name_or_file);
    /// Takes the place of the goal before. A phase that the new goal has no use for is cancelled.
    void aim(Goal goal);
    /// Stops within 100 ms and forgets the goal; the answer is Stopped, also when nothing was going on.
    void cancel();
    /// What happened since the last call, in order.
    std::vector<Report> take_reports();

private:
    struct Moment { ///< what quadratics are made of, and reports on elements
        std::shared_ptr<const State> state; ///< null: let go, for want of room
        std::uint64_t version = 0;          ///< of its snapshot
        std::int64_t bytes = 0;             ///< that are its own, not shared with the state before
        bool reconstructed = false;
    };
    struct Course { ///< one strategy's solver, made when first needed
        std::unique_ptr<Solver> solver;
        int position = -1; ///< of the solver; -1: not made yet
        bool ended = false;
        std::vector<Moment> moments; ///< by position
    };
    struct Answered {
        Inspection asked;
        std::uint64_t version = 0;
    };
    enum class Kind { advance, reconstruct, inspect };
    struct Task { ///< one phase of one strategy, or the quadratics or an element at one position
        Goal goal;
        Strategy strategy{};
        int position = 0; ///< that it leads to; 0: make the solver
        Kind kind = Kind::advance;
    };

    void work(const std::stop_token &stop);
    std::optional<Task> next_task() const;
    bool still_wanted(const Task &task) const;
    std::optional<Task> next_reconstruction() const;
    std::optional<Task> next_inspection() const;
    void advance(const Task &task);
    void keep(Course &course, std::uint64_t version);
    void reconstruct(const Task &task);
    void inspect(const Task &task);
    void read(const std::string &name);
    void report(Report report);

    ReadFile read_file_;
    std::function<void()> wake_;

    std::mutex mutex_; ///< guards all down to running_
    std::condition_variable_any changed_;
    std::optional<Goal> goal_;
    std::optional<std::string> to_open_;
    bool cancel_asked_ = false;
    std::optional<Task> running_;

    std::mutex reports_mutex_;
    std::vector<Report> reports_;

    std::array<Course, 4> courses_; ///< by strategy; of the worker's thread alone
    std::uint64_t run_ = 0;         ///< that the courses belong to
    std::optional<Answered> answered_; ///< the last one
    Cancel cancel_;
    std::jthread thread_; ///< last: it uses all the above
};

} // namespace penumbra
