// The thread that checks the shelf of hard cases. The window starts and stops it and takes from a queue what it has
// found; neither side ever waits for the other.
#pragma once

#include "core/cancel.h"
#include "study/hard_cases.h"

#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace penumbra {

struct CaseBegun {
    std::size_t index = 0; ///< of the case
    BasisFamily basis{};
};
struct CaseExamined {
    std::size_t index = 0;
    CaseResult result;
    double seconds = 0;
};
struct CaseRefused { ///< it could not be measured; one line
    std::size_t index = 0;
    BasisFamily basis{};
    std::string sentence;
};
struct CheckEnded {
    bool stopped = false; ///< before all was done
};
using CheckReport = std::variant<CaseBegun, CaseExamined, CaseRefused, CheckEnded>;

class CheckWorker {
public:
    /// `wake` is called from the worker's thread after each report.
    explicit CheckWorker(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Cancels and joins.
    ~CheckWorker() { stop(); }
    CheckWorker(const CheckWorker &) = delete;
    CheckWorker &operator=(const CheckWorker &) = delete;

    /// Examines each case in both bases, in order; the last report is CheckEnded. What went on before is stopped first.
    void start(std::vector<HardCase> cases, int threads);
    /// Within 100 ms; the answer is CheckEnded.
    void stop() { cancel_.raise(); }
    /// What happened since the last call, in order.
    std::vector<CheckReport> take_reports();

private:
    void work(const std::vector<HardCase> &cases, int threads);
    bool examine_one(std::size_t index, const HardCase &hard_case, BasisFamily basis, int threads);
    void report(CheckReport report);

    std::function<void()> wake_;
    std::mutex mutex_; ///< guards reports_
    std::vector<CheckReport> reports_;
    Cancel cancel_;
    std::jthread thread_; ///< last: it uses all the above
};

} // namespace penumbra
