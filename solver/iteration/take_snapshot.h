// From the solver's state to plain arrays.
#pragma once

#include "iteration/state.h"

namespace penumbra {

struct QuadraticField; // iteration/quadratic.h

/// Everything but the error.
std::shared_ptr<Snapshot> take_snapshot(const Setting &setting, const State &state);
/// The same with the quadratics that were made of the state, and without what was measured of its own radiosity.
std::shared_ptr<Snapshot> take_snapshot(const Setting &setting, const State &state, const QuadraticField &field);

/// As SnapshotLink tells it.
constexpr int link_kind(PairKind kind) { return kind == PairKind::clear ? 0 : kind == PairKind::near ? 1 : 2; }

/// A curve as a polyline in the scene's own frame.
SnapshotCurve draw_curve(const Scene &scene, const Curve &curve);

} // namespace penumbra
