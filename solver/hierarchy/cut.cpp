#include "hierarchy/cut.h"

#include "core/check.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {


struct Crossing {
    int side;
    double t; // along the side, from its first corner
    Vec2 point;
};

struct Quad {
    std::array<Vec2, 4> corners;
    std::array<SideKind, 4> sides;

    const Vec2 &corner(int i) const { return corners[static_cast<std::size_t>(i & 3)]; }
    SideKind side(int i) const { return sides[static_cast<std::size_t>(i & 3)]; }
    bool degenerate(int i) const { return corner(i) == corner(i + 1); }
};

/// The quad with another corner first; the shape stays.
Quad turned(const Quad &q, int by) {
    Quad out;
    for (int i = 0; i < 4; ++i) {
        out.corners[static_cast<std::size_t>(i)] = q.corner(i + by);
        out.sides[static_cast<std::size_t>(i)] = q.side(i + by);
    }
    return out;
}

double width(const std::array<Vec2, 4> &corners) {
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            longest = std::max(longest, (corners[i] - corners[j]).norm());
    return longest > 0 ? area(corners) / longest : 0;
}

/// Where the line meets the border, at most one crossing a corner; those within `reach` of a corner are moved there.
std::vector<Crossing> crossings(const Quad &q, const HalfPlane &line, double reach, int &n_snapped) {
    std::vector<Crossing> found;
    for (int i = 0; i < 4; ++i) {
        if (q.degenerate(i))
            continue;
        const double a = line.value(q.corner(i)), b = line.value(q.corner(i + 1));
        if ((a > 0 && b > 0) || (a < 0 && b < 0) || a == b)
            continue;
        const Vec2 side = q.corner(i + 1) - q.corner(i);
        const double length = side.norm(), met = std::clamp(a / (a - b), 0.0, 1.0);
        const double t = met * length < reach ? 0 : (1 - met) * length < reach ? 1 : met;
        const Vec2 point = t == 0 ? q.corner(i) : t == 1 ? q.corner(i + 1) : Vec2(q.corner(i) + t * side);
        const bool known = std::ranges::any_of(found, [&](const Crossing &c) { return c.point == point; });
        if (known)
            continue;
        found.push_back({i, t, point});
        n_snapped += t != met;
    }
    return found;
}

/// A cut from point p on the first side (0) to point r on the third (2) of q.
CutStep between_opposite(const Quad &q, const Vec2 &p, const Vec2 &r, int piece) {
    return {piece,
            {{{{q.corner(0), p, r, q.corner(3)}}, {{p, q.corner(1), q.corner(2), r}}}},
            {{{q.side(0), SideKind::cut, q.side(2), q.side(3)}, {q.side(0), q.side(1), q.side(2), SideKind::cut}}}};
}

bool wide_enough(const CutStep &step, double size) {
    return std::ranges::all_of(step.quads,
                               [&](const BilinearQuad &quad) { return width(quad.corners) > snap_reach(size); });
}

/// Sides on which a crossing may be counted: its own, and the neighbour's when it stands in a corner.
std::array<int, 2> sides_of(const Quad &q, const Crossing &c) {
    int next = c.side, before = c.side;
    if (c.t == 1)
        do
            next = (next + 1) & 3;
        while (q.degenerate(next));
    if (c.t == 0)
        do
            before = (before + 3) & 3;
        while (q.degenerate(before));
    return {before, next};
}

} // namespace

std::vector<BilinearQuad> CutPlan::leaves() const {
    if (steps.size() == 1)
        return {steps[0].quads[0], steps[0].quads[1]};
    const std::size_t whole = steps[1].piece == 1 ? 1 : 0;
    return {steps[0].quads[whole], steps[1].quads[0], steps[1].quads[1]};
}

std::optional<CutPlan> plan_cut(const Element &element, const HalfPlane &line) {
    Quad q{element.basis.quad().corners, element.sides};
    const double size = 2 * radius(q.corners);
    CutPlan plan;
    const std::vector<Crossing> ends = crossings(q, line, snap_reach(size), plan.n_snapped);
    if (ends.size() != 2)
        return std::nullopt;

    // A triangle falls into a triangle and a quad. A quad is turned so that the cut runs from side 0 to side 2, if it can.
    const auto add = [&](const CutStep &step) {
        if (!wide_enough(step, size))
            return false;
        plan.steps.push_back(step);
        return true;
    };
    const bool triangle = q.degenerate(0) || q.degenerate(1) || q.degenerate(2) || q.degenerate(3);
    if (triangle) {
        int first = 0;
        while (!q.degenerate(first))
            ++first;
        const Quad t = turned(q, first + 1); // now side 3 has no length
        const std::array<Vec2, 3> corner{t.corner(0), t.corner(1), t.corner(2)};
        const std::array<SideKind, 3> side{t.side(0), t.side(1), t.side(2)};
        // The lone corner: on the cut's one side alone (or on the cut itself).
        std::array<double, 3> h;
        for (std::size_t i = 0; i < 3; ++i)
            h[i] = std::ranges::find(ends, corner[i], &Crossing::point) != ends.end() ? 0 : line.value(corner[i]);
        std::size_t lone = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = h[i], y = h[(i + 1) % 3], z = h[(i + 2) % 3];
            if ((x > 0 && y <= 0 && z <= 0) || (x < 0 && y >= 0 && z >= 0))
                lone = i;
        }
        // corners A (lone), B, C; sides AB, BC, CA.
        const Vec2 A = corner[lone], B = corner[(lone + 1) % 3], C = corner[(lone + 2) % 3];
        const SideKind AB = side[lone], BC = side[(lone + 1) % 3], CA = side[(lone + 2) % 3];
        const auto on = [&](std::size_t to) {
            const double a = h[lone], b = h[to];
            return b == 0 ? corner[to] : Vec2(A + a / (a - b) * (corner[to] - A));
        };
        const Vec2 P = on((lone + 1) % 3), R = on((lone + 2) % 3);
        CutStep step;
        step.quads = {BilinearQuad{{A, P, R, R}}, BilinearQuad{{P, B, C, R}}};
        step.sides = {{{AB, SideKind::cut, SideKind::cut, CA}, {AB, BC, CA, SideKind::cut}}};
        if (!add(step))
            return std::nullopt;
        return plan;
    }

    const auto a = sides_of(q, ends[0]), b = sides_of(q, ends[1]);
    for (const int i : a)
        for (const int j : b)
            if (((i - j) & 3) == 2) {
                const Quad t = turned(q, i);
                if (!add(between_opposite(t, ends[0].point, ends[1].point, 0)))
                    return std::nullopt;
                return plan;
            }

    // Neighbouring sides i and i+1, with corner c between them: first a straight line of the parameter square from the
    // end on side i to the side opposite, then the cut, which now ends in a corner of the piece at c.
    int i = ends[0].side, j = ends[1].side;
    Crossing from = ends[0], to = ends[1];
    if (((i + 1) & 3) != j) {
        std::swap(i, j);
        std::swap(from, to);
    }
    if (((i + 1) & 3) != j)
        return std::nullopt;
    const Quad t = turned(q, i); // the line enters on side 0 at from.t and leaves on side 1 at to.t
    const Vec2 opposite = t.corner(3) + from.t * (t.corner(2) - t.corner(3));
    const CutStep extra = between_opposite(t, from.point, opposite, 0);
    const Quad right{extra.quads[1].corners, extra.sides[1]}; // corners from, c1, c2, opposite
    // From `to` on its side 1 to its corner 0, which ends its side 3: turned by one, from side 0 to side 2.
    const CutStep last = between_opposite(turned(right, 1), to.point, from.point, 2);
    if (!add(extra) || !add(last))
        return std::nullopt;
    return plan;
}

void cut(Forest &forest, ElementId leaf, const CutPlan &plan, int iteration) {
    PENUMBRA_CHECK(forest[leaf].n_children, ==, 0);
    ElementId first_pieces;
    for (const CutStep &step : plan.steps) {
        const ElementId parent = step.piece == 0 ? leaf : ElementId(first_pieces.index + step.piece - 1);
        const ElementId first(forest.elements.size());
        const int deeper = step.piece == 0 ? plan.half_depth : 0;
        for (std::size_t c = 0; c < 2; ++c) {
            const Element above = forest[parent];
            const ElementBasis basis(above.basis.order(), step.quads[c]);
            add_child(forest, parent, step.quads[c], step.sides[c], above.half_depth + deeper, above.n_cuts + 1, iteration,
                      std::make_shared<const TwoScale>(two_scale(above.basis, basis)));
        }
        forest[parent].first_child = first;
        forest[parent].n_children = 2;
        forest[parent].split = SplitKind::cut;
        if (step.piece == 0)
            first_pieces = first;
    }
}

} // namespace penumbra
