#include "transport/point_transfer.h"

#include "transport/source_moments.h"

#include <algorithm>
#include <utility>

namespace penumbra {

namespace {

bool in_solid(const Blockers &blockers, const Vec3 &x) {
    return std::ranges::any_of(blockers.all(), [&](const Blocker &b) {
        return b.solid >= 0 && !blockers.outside(b.solid, std::span(&x, 1));
    });
}

} // namespace

int n_columns(const Scene &scene, const Element &q) { return scene.reflects(q.surface) ? q.basis.n_functions() : 1; }

SourceNode source_node(const Scene &scene, const Element &q) {
    SourceNode node{q, {}, n_columns(scene, q)};
    node.whole.add(q.basis.outline());
    for (const Polygon &cover : scene.surface(q.surface).covers) {
        ConvexPieces rest;
        subtract(node.whole, half_planes(cover), rest);
        node.whole = std::move(rest);
    }
    return node;
}

PointTransfer::PointTransfer(const Transport &transport, const Element &p, const Interaction &pair,
                             std::vector<SourceNode> nodes, Work &work)
    : transport_(transport), receiver_(transport.scene.surface(p.surface)),
      source_(transport.scene.surface(pair.source)), clipping_(pair.clipping()), n_clips_of_all_(pair.n_clips_of_all()),
      nodes_(std::move(nodes)), work_(work) {
    for (const SourceNode &node : nodes_)
        n_columns_ += node.n_columns;
}

void PointTransfer::at(const Vec2 &point, std::span<double> row) {
    if (transport_.cancel)
        transport_.cancel->check();
    std::ranges::fill(row, 0.0);
    const Vec3 x = receiver_.frame.to_space(point);
    const Vec3 &n = receiver_.frame.normal;
    if (is_covered(receiver_, point) && in_solid(transport_.blockers, x + 1e-6 * n))
        return;
    if (source_.frame.height(x) <= 0)
        return;
    const std::int64_t before = work_.clips;
    scratch_.hidden.cast(x, source_.frame, transport_.blockers, clipping_, work_);
    work_.spared[Effect::visibility] += std::max<std::int64_t>(0, n_clips_of_all_ - (work_.clips - before));
    std::size_t first = 0;
    for (const SourceNode &node : nodes_) {
        const auto count = static_cast<std::size_t>(node.n_columns);
        visible_part(x, n, source_.frame, node.whole, scratch_.hidden, scratch_);
        source_moments(x, n, source_.frame, node.element.basis, scratch_.pieces, transport_.accuracy,
                       row.subspan(first, count), work_);
        first += count;
    }
}

} // namespace penumbra
