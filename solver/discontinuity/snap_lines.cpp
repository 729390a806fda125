#include "discontinuity/snap_lines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace penumbra {

namespace {

struct Segment {
    Vec2 a, b;
    int line;
    std::vector<std::pair<double, int>> stops; ///< parameter from a to b, and point

    Vec2 at(double t) const { return a + t * (b - a); }
};

class Snapper {
public:
    explicit Snapper(double snap) : snap_(snap) {}

    void add(int line, const std::vector<Vec2> &corners) {
        int before = -1;
        for (const Vec2 &corner : corners) {
            const int point = new_point(corner);
            if (before >= 0)
                segments_.push_back(
                    {points_[static_cast<std::size_t>(before)], corner, line, {{0, before}, {1, point}}});
            before = point;
        }
    }

    SnappedLines run() {
        meet_all();
        join_near_points();
        return pieces();
    }

private:
    int new_point(const Vec2 &p) {
        points_.push_back(p);
        return static_cast<int>(points_.size()) - 1;
    }

    /// All pairs whose boxes meet, by a sweep along x.
    void meet_all() {
        std::vector<Eigen::AlignedBox2d> boxes;
        for (const Segment &s : segments_) {
            Eigen::AlignedBox2d box(s.a);
            box.extend(s.b);
            boxes.emplace_back(box.min().array() - snap_, box.max().array() + snap_);
        }
        std::vector<std::size_t> order(segments_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return boxes[i].min().x(); });
        for (std::size_t m = 0; m < order.size(); ++m)
            for (std::size_t n = m + 1; n < order.size() && boxes[order[n]].min().x() <= boxes[order[m]].max().x(); ++n)
                if (boxes[order[m]].intersects(boxes[order[n]]))
                    meet(segments_[order[m]], segments_[order[n]]);
    }

    void meet(Segment &s, Segment &t) {
        const bool touched = stop_at_ends(s, t) | stop_at_ends(t, s);
        const Vec2 d = s.b - s.a, e = t.b - t.a;
        const double turn = cross(d, e);
        if (touched || std::abs(turn) <= 1e-12 * d.norm() * e.norm())
            return;
        const double u = cross(t.a - s.a, e) / turn, v = cross(t.a - s.a, d) / turn;
        if (u <= 0 || u >= 1 || v <= 0 || v >= 1)
            return;
        const int point = new_point(s.at(u));
        s.stops.emplace_back(u, point);
        t.stops.emplace_back(v, point);
    }

    /// Where an end of `other` lies on s, s goes through it.
    bool stop_at_ends(Segment &s, const Segment &other) const {
        bool touched = false;
        const Vec2 d = s.b - s.a;
        for (const int end : {other.stops[0].second, other.stops[1].second}) {
            const Vec2 &p = points_[static_cast<std::size_t>(end)];
            const double length2 = d.squaredNorm(),
                         t = length2 > 0 ? std::clamp((p - s.a).dot(d) / length2, 0.0, 1.0) : 0;
            if ((s.at(t) - p).norm() > snap_)
                continue;
            s.stops.emplace_back(t, end);
            touched = true;
        }
        return touched;
    }

    int first_of(int p) {
        auto &up = same_as_[static_cast<std::size_t>(p)];
        return up == p ? p : up = first_of(up);
    }

    /// Points in one cell of a grid, or in neighbouring ones, are compared.
    void join_near_points() {
        same_as_.resize(points_.size());
        std::iota(same_as_.begin(), same_as_.end(), 0);
        std::unordered_map<std::uint64_t, std::vector<int>> cells;
        const auto cell = [&](const Vec2 &p, int dx, int dy) {
            const auto x = static_cast<std::int64_t>(std::floor(p.x() / snap_)) + dx;
            const auto y = static_cast<std::int64_t>(std::floor(p.y() / snap_)) + dy;
            return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U ^ static_cast<std::uint64_t>(y);
        };
        for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
            const Vec2 &p = points_[static_cast<std::size_t>(i)];
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    if (const auto found = cells.find(cell(p, dx, dy)); found != cells.end())
                        for (const int j : found->second)
                            if ((points_[static_cast<std::size_t>(j)] - p).norm() <= snap_) {
                                const int a = first_of(i), b = first_of(j);
                                same_as_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
                            }
            cells[cell(p, 0, 0)].push_back(i);
        }
    }

    SnappedLines pieces() {
        SnappedLines out;
        std::map<int, int> number;
        const auto numbered = [&](int p) {
            const auto [at, is_new] = number.emplace(p, static_cast<int>(out.points.size()));
            if (is_new)
                out.points.push_back(points_[static_cast<std::size_t>(p)]);
            return at->second;
        };
        std::map<std::pair<int, int>, std::vector<int>> found;
        for (Segment &s : segments_) {
            std::ranges::sort(s.stops);
            for (std::size_t k = 0; k + 1 < s.stops.size(); ++k) {
                const int p = numbered(first_of(s.stops[k].second)), q = numbered(first_of(s.stops[k + 1].second));
                if (p != q)
                    found[std::minmax(p, q)].push_back(s.line);
            }
        }
        for (auto &[ends, lines] : found) {
            std::ranges::sort(lines);
            const auto twins = std::ranges::unique(lines);
            lines.erase(twins.begin(), twins.end());
            out.pieces.push_back({ends.first, ends.second, std::move(lines)});
        }
        return out;
    }

    double snap_;
    std::vector<Vec2> points_;
    std::vector<Segment> segments_;
    std::vector<int> same_as_; ///< of points: an earlier one, or itself
};

} // namespace

SnappedLines snap_lines(std::span<const std::vector<Vec2>> lines, double snap) {
    Snapper snapper(snap);
    for (std::size_t i = 0; i < lines.size(); ++i)
        snapper.add(static_cast<int>(i), lines[i]);
    return snapper.run();
}

} // namespace penumbra
