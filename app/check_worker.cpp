#include "check_worker.h"

#include <chrono>
#include <utility>

namespace penumbra {

void CheckWorker::start(std::vector<HardCase> cases, int threads) {
    if (thread_.joinable()) {
        stop();
        thread_.join();
    }
    cancel_.lower();
    take_reports(); // of before
    thread_ = std::jthread([this, all = std::move(cases), threads] { work(all, threads); });
}

std::vector<CheckReport> CheckWorker::take_reports() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(reports_, {});
}

void CheckWorker::work(const std::vector<HardCase> &cases, int threads) {
    bool on = true;
    for (std::size_t i = 0; on && i < cases.size(); ++i)
        for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar})
            on = on && examine_one(i, cases[i], basis, threads);
    report(CheckEnded{!on});
}

bool CheckWorker::examine_one(std::size_t index, const HardCase &hard_case, BasisFamily basis, int threads) {
    if (cancel_.raised())
        return false;
    report(CaseBegun{index, basis});
    const auto start = std::chrono::steady_clock::now();
    try {
        CaseResult result = examine(hard_case, basis, &cancel_, threads);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        report(CaseExamined{index, std::move(result), taken.count()});
    } catch (const Cancelled &) {
        return false;
    } catch (const std::exception &e) {
        report(CaseRefused{index, basis, e.what()});
    }
    return true;
}

void CheckWorker::report(CheckReport report) {
    {
        const std::scoped_lock lock(mutex_);
        reports_.push_back(std::move(report));
    }
    wake_();
}

} // namespace penumbra
