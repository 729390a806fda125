#include "discontinuity/local_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace penumbra {

namespace {

/// A facet's border this close to the line is touched [solver units]: several roundings of `coincidence` meet here.
constexpr double touch = 4 * coincidence;
/// Lengths, sines and angles in the picture, whose scale is 1.
constexpr double slight = 1e-7;

} // namespace

LocalPicture::LocalPicture(const SightLine &line, const Vec3 &step)
    : eye_(line), u_(line.along.unitOrthogonal()), v_(line.along.cross(u_)),
      displacement_(-Vec2(step.dot(u_), step.dot(v_)).normalized()) {}

Meeting LocalPicture::add(const Facet &facet, bool source) {
    Figure figure{facet.surface, source};
    const Meeting meeting = meet(facet, figure);
    if (meeting == Meeting::pierced && !source)
        hidden_ = true;
    if (meeting == Meeting::grazed || (meeting == Meeting::pierced && source))
        figures_.push_back(figure);
    any_source_ |= source && meeting != Meeting::apart;
    return meeting;
}

void LocalPicture::add_border(Figure &figure, double nearness, const Vec2 &along, double inside) {
    if (figure.n_borders == static_cast<int>(figure.borders.size()))
        return;
    nearest_ = std::max(nearest_, nearness);
    std::size_t line = 0;
    while (line < lines_.size() && (std::abs(cross(lines_[line].along, along)) > slight ||
                                    std::abs(lines_[line].nearness - nearness) > slight * nearness))
        ++line;
    if (line == lines_.size())
        lines_.push_back({along, nearness});
    const double same_way = lines_[line].along.dot(along) > 0 ? 1 : -1;
    figure.borders[static_cast<std::size_t>(figure.n_borders++)] = {line, same_way * inside};
}

Meeting LocalPicture::meet(const Facet &facet, Figure &figure) {
    const double facing = facet.frame.normal.dot(eye_.along), slack = touch + 2 * facet.bend;
    if (facet.radius * std::abs(facing) <= slack)
        return meet_edge_on(facet, figure);
    const std::size_t n = facet.corners.size();
    const auto project = [&](const Vec3 &c) { return Vec2((c - eye_.from).dot(u_), (c - eye_.from).dot(v_)); };
    const double turn = facing > 0 ? 1 : -1;
    Vec2 a = project(facet.corners[n - 1]);
    for (std::size_t j = 0; j < n; ++j) {
        const Vec3 &start = facet.corners[(j + n - 1) % n];
        const Vec2 b = project(facet.corners[j]), edge = b - a;
        const double length = edge.norm();
        if (length > touch) {
            const double depth = -turn * cross(edge, a) / length, foot = -a.dot(edge) / length;
            if (depth < -touch)
                return Meeting::apart;
            if (depth <= touch && foot >= -touch && foot <= length + touch) {
                const Vec3 touched = start + foot / length * (facet.corners[j] - start);
                add_border(figure, 1 / std::max((touched - eye_.from).dot(eye_.along), coincidence), edge / length,
                           turn);
            }
        }
        a = b;
    }
    return figure.n_borders > 0 ? Meeting::grazed : Meeting::pierced;
}

Meeting LocalPicture::meet_edge_on(const Facet &facet, Figure &figure) {
    const double slack = touch + 2 * facet.bend;
    if (std::abs((facet.corners[0] - eye_.from).dot(facet.frame.normal)) > slack)
        return Meeting::apart;
    const Vec3 beside = facet.frame.normal.cross(eye_.along).normalized();
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 a = facet.corners[i] - eye_.from, b = facet.corners[(i + 1) % n] - eye_.from;
        const double off_a = a.dot(beside), off_b = b.dot(beside);
        if ((off_a < 0) == (off_b < 0))
            continue;
        const double distance = (a + off_a / (off_a - off_b) * (b - a)).dot(eye_.along);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    if (farthest - nearest <= touch || farthest <= coincidence)
        return Meeting::apart;
    const Vec2 trace(beside.dot(u_), beside.dot(v_));
    // Seen from the step's side the farther border lies against the displacement of the nearer one.
    const double left = cross(trace, displacement_) > 0 ? 1 : -1;
    figure.strip = true;
    add_border(figure, 1 / std::max(nearest, coincidence), trace, -left);
    add_border(figure, 1 / farthest, trace, left);
    return Meeting::grazed;
}

template <class Depth> bool LocalPicture::sees(double side, const Depth &depth) const {
    const auto inside = [&](const Figure &figure) {
        for (int k = 0; k < figure.n_borders; ++k) {
            const Border &border = figure.borders[static_cast<std::size_t>(k)];
            if (border.inside * (figure.strip ? side : 1.0) * depth(lines_[border.line]) <= 0)
                return false;
        }
        return true;
    };
    bool lit = false;
    for (const Figure &figure : figures_) {
        if (!inside(figure))
            continue;
        if (!figure.source)
            return false;
        lit = true;
    }
    return lit;
}

bool LocalPicture::sees_beside(const Vec2 &at, const Vec2 &towards, double side) const {
    return sees(side, [&](const Line &line) {
        const double depth = cross(line.along, at - place(line, side));
        return std::abs(depth) > slight ? depth : cross(line.along, towards);
    });
}

bool LocalPicture::is_corner(const Vec2 &at, double side) const {
    std::vector<double> angles;
    for (const Line &line : lines_)
        if (std::abs(cross(line.along, at - place(line, side))) <= slight) {
            angles.push_back(std::atan2(line.along.y(), line.along.x()));
            angles.push_back(angles.back() > 0 ? angles.back() - std::numbers::pi : angles.back() + std::numbers::pi);
        }
    std::ranges::sort(angles);
    angles.push_back(angles.front() + 2 * std::numbers::pi);
    double seen = 0;
    int n_changes = 0;
    std::optional<bool> first;
    bool previous = false;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        if (angles[i + 1] - angles[i] < slight)
            continue;
        const double angle = (angles[i] + angles[i + 1]) / 2;
        const bool sees = sees_beside(at, Vec2(std::cos(angle), std::sin(angle)), side);
        if (first)
            n_changes += sees != previous;
        else
            first = sees;
        previous = sees;
        if (sees)
            seen += angles[i + 1] - angles[i];
    }
    n_changes += first.value_or(previous) != previous;
    return n_changes > 0 && !(n_changes == 2 && std::abs(seen - std::numbers::pi) < 10 * slight);
}

LocalPicture::Shape LocalPicture::shape(double side) const {
    Shape corners;
    for (std::size_t i = 0; i < lines_.size(); ++i)
        for (std::size_t j = i + 1; j < lines_.size(); ++j) {
            const double turn = cross(lines_[i].along, lines_[j].along);
            if (std::abs(turn) <= slight)
                continue;
            const Vec2 p = place(lines_[i], side), q = place(lines_[j], side);
            if (is_corner(p + cross(q - p, lines_[j].along) / turn * lines_[i].along, side))
                corners.emplace_back(i, j);
        }
    return corners;
}

bool LocalPicture::changes() {
    bounding_.assign(lines_.size(), 0);
    if (hidden_ || !any_source_)
        return false;
    const Shape one = shape(1), other = shape(-1);
    for (const Shape *corners : {&one, &other})
        for (const auto &[i, j] : *corners)
            bounding_[i] = bounding_[j] = 1;
    return one != other;
}

template <class Visit>
void LocalPicture::for_each_strip(const Vec2 &towards, double side, const Visit &visit) const {
    constexpr double reach = 4;
    const Vec2 across(-towards.y(), towards.x());
    std::vector<std::pair<double, std::size_t>> borders{{-reach, lines_.size()}, {reach, lines_.size()}};
    for (std::size_t i = 0; i < lines_.size(); ++i)
        if (std::abs(cross(lines_[i].along, towards)) <= slight)
            borders.emplace_back(place(lines_[i], side).dot(across), i);
    std::ranges::sort(borders);
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const double width = borders[i + 1].first - borders[i].first;
        if (width <= slight)
            continue;
        const double offset = borders[i].first + width / 2;
        visit(width, sees(side, [&](const Line &line) {
                  const double away = cross(line.along, towards);
                  return std::abs(away) > slight ? away
                                                 : line.along.dot(towards) * (offset - place(line, side).dot(across));
              }),
              borders[i + 1].second);
    }
}

double LocalPicture::seen_far_away(const Vec2 &towards, double side) const {
    double sum = 0;
    for_each_strip(towards, side, [&](double width, bool seen, std::size_t) { sum += seen ? width : 0; });
    return sum;
}

bool LocalPicture::kinks(const Vec3 &trace) const {
    const Vec2 towards = in_picture(trace);
    for (const Vec2 &end : {towards, Vec2(-towards)})
        if (std::abs(seen_far_away(end, 1) + seen_far_away(end, -1) - 2 * seen_far_away(end, 0)) > 10 * slight)
            return true;
    return false;
}

bool LocalPicture::strips_change(const Vec3 &trace) {
    bounding_.assign(lines_.size(), 0);
    if (hidden_ || !any_source_)
        return false;
    const Vec2 towards = in_picture(trace);
    const auto bounds = [&](double side) {
        std::vector<std::size_t> lines;
        std::optional<std::pair<bool, std::size_t>> before;
        for_each_strip(towards, side, [&](double, bool seen, std::size_t line) {
            if (before && before->first != seen)
                lines.push_back(before->second);
            before = {seen, line};
        });
        for (const std::size_t line : lines)
            bounding_[line] = 1;
        return lines;
    };
    const auto one = bounds(1), other = bounds(-1);
    return one != other;
}

std::vector<SurfaceId> LocalPicture::bounding() const {
    std::vector<SurfaceId> surfaces;
    for (const Figure &figure : figures_)
        for (int k = 0; k < figure.n_borders && !figure.source; ++k)
            if (bounding_[figure.borders[static_cast<std::size_t>(k)].line]) {
                surfaces.push_back(figure.surface);
                break;
            }
    std::ranges::sort(surfaces);
    const auto twins = std::ranges::unique(surfaces);
    surfaces.erase(twins.begin(), twins.end());
    return surfaces;
}

} // namespace penumbra
