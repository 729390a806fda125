#include "visible_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra {

namespace {
constexpr double near = 1e-8; ///< radius of the neighbourhood in which a corner shows [solver units]
}

ShapeReader::ShapeReader(const Scene &scene, SurfaceId source, SurfaceId receiver)
    : scene_(scene), source_(source), receiver_(receiver) {
    lamp_ = named(source);
    for (int s = 0; s < scene.n_surfaces(); ++s)
        if (s != source.index && s != receiver.index)
            faces_.push_back(named(SurfaceId(s)));
    const Surface &lamp = scene.surface(source);
    const Vec2 centre = centroid(lamp.outline);
    const double half = 4 * radius(lamp.outline);
    for (const Vec2 &c : {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)})
        frame_.push_back(lamp.frame.to_space(centre + c));
}

ShapeReader::Face ShapeReader::named(SurfaceId surface) {
    Face face{std::to_string(surface.index) + "f", {}};
    for (const Vec3 &c : scene_.surface(surface).corners)
        face.corners.push_back({c, name_of(c), ""});
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        face.corners[i].edge = name_of_line(face.corners[i].at, face.corners[(i + 1) % face.corners.size()].at);
    }
    return face;
}

std::string ShapeReader::name_of(const Vec3 &corner) {
    auto found = std::ranges::find_if(known_, [&](const Vec3 &k) { return (k - corner).norm() < 1e-9; });
    if (found == known_.end())
        found = known_.insert(known_.end(), corner);
    return std::to_string(found - known_.begin());
}

std::string ShapeReader::name_of_line(const Vec3 &a, const Vec3 &b) {
    const auto on_line = [](const Vec3 &p, const Vec3 &q, const Vec3 &x) {
        return (q - p).normalized().cross(x - p).norm() < 1e-9;
    };
    auto found = std::ranges::find_if(lines_, [&](const auto &line) {
        const auto &[p, q] = line;
        return (q - p).squaredNorm() > (b - a).squaredNorm() ? on_line(p, q, a) && on_line(p, q, b)
                                                             : on_line(a, b, p) && on_line(a, b, q);
    });
    if (found == lines_.end())
        found = lines_.insert(lines_.end(), {a, b});
    return "line " + std::to_string(found - lines_.begin());
}

ShapeReader::Face ShapeReader::clip(const Face &face, const Vec3 &origin, const Vec3 &normal, double least,
                                    const std::string &name) {
    Face kept{face.name, {}};
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Corner &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
        const double ha = (a.at - origin).dot(normal) - least, hb = (b.at - origin).dot(normal) - least;
        if (ha >= 0)
            kept.corners.push_back(a);
        if ((ha < 0) != (hb < 0))
            kept.corners.push_back(
                {a.at + ha / (ha - hb) * (b.at - a.at), a.edge + "/" + name, ha < 0 ? a.edge : face.name + "/" + name});
    }
    return kept;
}

ShapeReader::Figure ShapeReader::project(const Face &face, const Vec3 &x, bool source) const {
    const PlaneFrame &plane = scene_.surface(source_).frame;
    Figure figure{source, {}, {}};
    for (const Corner &c : face.corners) {
        const double d = plane.height(x);
        figure.outline.push_back(plane.to_plane(x + d / (d - plane.height(c.at)) * (c.at - x)));
    }
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const std::size_t j = (i + 1) % face.corners.size();
        figure.edges.push_back(
            {figure.outline[i], figure.outline[j], face.corners[i].edge, face.corners[i].name, face.corners[j].name});
    }
    return figure;
}

bool ShapeReader::inside(const Polygon &outline, const Vec2 &p) {
    bool odd = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i] - p, b = outline[(i + 1) % outline.size()] - p;
        if ((a.y() > 0) != (b.y() > 0) && (cross(a, b) > 0) == (b.y() > a.y()))
            odd = !odd;
    }
    return odd;
}

bool ShapeReader::is_corner(const std::vector<Figure> &figures, const Vec2 &at) {
    // Where the small circle about the point meets borders; between two such places it is seen or hidden throughout.
    std::vector<double> angles;
    for (const Figure &figure : figures)
        for (const Edge &e : figure.edges) {
            const double length = (e.q - e.p).norm();
            if (length == 0)
                continue;
            const Vec2 d = (e.q - e.p) / length, o = e.p - at;
            const double off = cross(d, o), foot = -o.dot(d);
            if (std::abs(off) >= near)
                continue;
            const double half = std::sqrt(near * near - off * off);
            for (const double t : {foot - half, foot + half})
                if (t >= 0 && t <= length)
                    angles.push_back(std::atan2((o + t * d).y(), (o + t * d).x()));
        }
    if (angles.empty())
        return false;
    std::ranges::sort(angles);
    angles.push_back(angles.front() + 2 * std::numbers::pi);
    double seen = 0;
    int n_changes = 0;
    bool first = false, previous = false, any = false;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        if (angles[i + 1] - angles[i] < 1e-6)
            continue;
        const double angle = (angles[i] + angles[i + 1]) / 2;
        const Vec2 p = at + near * Vec2(std::cos(angle), std::sin(angle));
        const bool visible =
            std::ranges::all_of(figures, [&](const Figure &f) { return inside(f.outline, p) == f.source; });
        if (!any)
            first = visible;
        else
            n_changes += visible != previous;
        previous = visible;
        any = true;
        if (visible)
            seen += angles[i + 1] - angles[i];
    }
    n_changes += first != previous;
    return n_changes > 0 && !(n_changes == 2 && std::abs(seen - std::numbers::pi) < 1e-6);
}

bool ShapeReader::on_receiver(const Vec2 &x) const { return inside(scene_.surface(receiver_).outline, x); }

bool ShapeReader::covered(const Vec2 &x) const {
    return std::ranges::any_of(scene_.surface(receiver_).covers,
                               [&](const Polygon &cover) { return inside(cover, x); });
}

VisibleShape ShapeReader::at(const Vec2 &x2) const {
    const PlaneFrame &plane = scene_.surface(source_).frame, &floor = scene_.surface(receiver_).frame;
    const Vec3 x = floor.to_space(x2);
    const double distance = plane.height(x);
    if (!on_receiver(x2) || covered(x2) || distance <= 0)
        return {};
    std::vector<Figure> figures{project(clip(lamp_, floor.origin, floor.normal, 1e-9, "horizon"), x, true)};
    if (figures[0].outline.empty())
        return {};
    for (const Face &face : faces_) {
        // What blocks lies in front of both planes, between x and the source.
        const auto rises = [&](const PlaneFrame &over) {
            return std::ranges::any_of(face.corners, [&](const Corner &c) { return over.height(c.at) > 1e-9; });
        };
        if (!rises(floor) || !rises(plane))
            continue;
        Face part = clip(face, floor.origin, floor.normal, 1e-12, "floor"); // off the horizon's own line
        part = clip(part, plane.origin, plane.normal, 0, "source");
        for (std::size_t i = 0; i < 4; ++i)
            part = clip(part, x, (frame_[i] - x).cross(frame_[(i + 1) % 4] - x).normalized() * -1, 0, "frame");
        if (part.corners.size() > 2)
            figures.push_back(project(part, x, false));
    }
    std::vector<const Edge *> edges;
    for (const Figure &figure : figures)
        for (const Edge &e : figure.edges)
            edges.push_back(&e);
    VisibleShape shape;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge &e = *edges[i];
        if (!shape.contains(e.p_name) && is_corner(figures, e.p))
            shape.insert(e.p_name);
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Edge &f = *edges[j];
            const Vec2 d = e.q - e.p, g = f.q - f.p;
            const double turn = cross(d, g);
            if (e.p_name == f.p_name || e.p_name == f.q_name || e.q_name == f.p_name || e.q_name == f.q_name ||
                std::abs(turn) < 1e-12 * d.norm() * g.norm())
                continue;
            const double s = cross(f.p - e.p, g) / turn, t = cross(f.p - e.p, d) / turn;
            if (s > 0 && s < 1 && t > 0 && t < 1 && is_corner(figures, e.p + s * d))
                shape.insert(std::min(e.name, f.name) + " x " + std::max(e.name, f.name));
        }
    }
    return shape;
}

} // namespace penumbra
