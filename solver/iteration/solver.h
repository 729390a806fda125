// The method of Bouatouch & Pattanaik (1995), a phase at a time.
#pragma once

#include "core/cancel.h"
#include "core/options.h"
#include "effects/plan.h"
#include "iteration/snapshot.h"
#include "scene/scene.h"

#include <memory>

namespace penumbra {

struct State; // iteration/state.h; immutable, shares what did not change with the state before
struct ElementQuestion; // iteration/element_report.h
struct ElementReport;   // the same

/// Steps one scene with one set of options. A phase works on a copy and is taken over only when it is complete: when
/// `cancel` is raised in the middle, Cancelled is thrown (within 100 ms) and the solver stands where it stood before.
/// Results are the same to the last bit for any number of threads.
class Solver {
public:
    /// Keeps the scene. Builds what does not depend on the iteration: blockers and the curves of all emitters
    /// (those of reflectors are made while refining).
    Solver(std::shared_ptr<const Scene> scene, const Options &options, const Cancel *cancel = nullptr);
    ~Solver();
    Solver(const Solver &) = delete;
    Solver &operator=(const Solver &) = delete;

    /// One iteration: whatever phases of the present one are left (refine, gather, push and pull).
    void step(const Cancel *cancel = nullptr);
    /// The next phase alone.
    void sub_step(const Cancel *cancel = nullptr);
    /// Steps until converged or options.max_iterations. Returns whether it converged.
    bool run(const Cancel *cancel = nullptr);

    /// Estimates the error of the present state from fresh points (measure/error_estimate.h) where that was not done yet;
    /// takes no part in its time.
    void measure(const Cancel *cancel = nullptr);

    Phase phase() const;
    const Counters &counters() const;
    bool converged() const { return counters().converged; }
    /// Whether steps have nothing more to give: converged, or exhausted.
    bool ended() const { return converged() || counters().exhausted; }
    /// Everything about the present state. `with_error` adds the error against the exact direct solution where the
    /// scene has one bounce (no time of it is counted).
    std::shared_ptr<const Snapshot> snapshot(bool with_error = false) const;
    /// A state of this solver, whose basis is constant, drawn as the quadratics of quadratic.h; figures are the solution's
    /// but for the error, which is the quadratics' own.
    std::shared_ptr<const Snapshot> reconstruction(const State &state, bool with_error = false,
                                                   const Cancel *cancel = nullptr) const;
    /// About one element of a state of this solver.
    std::shared_ptr<const ElementReport> inspect(const State &state, const ElementQuestion &question,
                                                 const Cancel *cancel = nullptr) const;
    /// As it is solved (effects/plan.h, without_colour).
    const Scene &scene() const;
    const Options &options() const;

    /// The present state, to come back to; cheap (a reference).
    std::shared_ptr<const State> state() const;
    void restore(std::shared_ptr<const State> state);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace penumbra
