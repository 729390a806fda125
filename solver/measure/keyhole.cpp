#include "measure/keyhole.h"

#include "measure/visible_corners.h"
#include "transport/lambert.h"
#include "visibility/visible_part.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace penumbra {

namespace {

constexpr double coincide = 1e-10; ///< solver units

struct HalfSpace {
    Vec3 origin, normal; ///< inside: (x - origin) . normal >= 0
    double height(const Vec3 &x) const { return (x - origin).dot(normal); }
};

std::vector<Vec3> clip(std::vector<Vec3> polygon, const std::vector<HalfSpace> &spaces) {
    std::vector<Vec3> kept;
    for (const HalfSpace &space : spaces) {
        kept.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double ha = space.height(a), hb = space.height(b);
            if (ha >= 0)
                kept.push_back(a);
            if ((ha < 0) != (hb < 0))
                kept.emplace_back(a + ha / (ha - hb) * (b - a));
        }
        std::swap(polygon, kept);
    }
    return polygon.size() > 2 ? polygon : std::vector<Vec3>();
}

bool clip(Vec3 &a, Vec3 &b, const std::vector<HalfSpace> &spaces) {
    for (const HalfSpace &space : spaces) {
        const double ha = space.height(a), hb = space.height(b);
        if (ha < 0 && hb < 0)
            return false;
        if (ha < 0)
            a = a + ha / (ha - hb) * (b - a);
        else if (hb < 0)
            b = b + hb / (hb - ha) * (a - b);
    }
    return true;
}

/// The eye's frame.
struct Eye {
    Vec3 at, right, up, ahead;
    Vec2 place(const Vec3 &y) const {
        const Vec3 r = y - at;
        return {r.dot(right) / r.dot(ahead), r.dot(up) / r.dot(ahead)};
    }
    /// Directions of the picture with v . direction >= limit.
    HalfSpace side(const Vec2 &v, double limit) const { return {at, v.x() * right + v.y() * up - limit * ahead}; }
};

Eye eye_towards(const Scene &scene, const Vec3 &x, const PlaneFrame &source, const Vec3 &target) {
    const Vec3 &n = source.normal;
    Vec3 up = scene.up - scene.up.dot(n) * n;
    if (up.norm() < 0.1) {
        const Vec3 axis = std::abs(scene.up.x()) < 0.5 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
        up = n.cross(axis);
    }
    up.normalize();
    const Vec3 ahead = (target - x).normalized();
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(-n, ahead);
    return {x, turn * up.cross(n), turn * up, ahead};
}

KeyholeFigure figure(const Eye &eye, SurfaceId id, const Surface &surface, const std::vector<std::vector<Vec3>> &parts,
                     const std::vector<HalfSpace> &spaces) {
    KeyholeFigure result{id.index, {}, {}};
    for (const auto &part : parts) {
        Polygon &polygon = result.parts.emplace_back();
        for (const Vec3 &y : clip(part, spaces))
            polygon.push_back(eye.place(y));
        if (area(polygon) < 0) // seen from behind
            std::ranges::reverse(polygon);
        if (polygon.empty())
            result.parts.pop_back();
    }
    for (std::size_t i = 0; i < surface.corners.size(); ++i) {
        Vec3 a = surface.corners[i], b = surface.corners[(i + 1) % surface.corners.size()];
        if (clip(a, b, spaces))
            result.edges.emplace_back(eye.place(a), eye.place(b));
    }
    return result;
}

std::vector<std::vector<Vec3>> parts_in_space(const Surface &surface) {
    std::vector<std::vector<Vec3>> parts;
    for (const Polygon &part : surface.parts)
        for (auto &polygon = parts.emplace_back(); const Vec2 &p : part)
            polygon.push_back(surface.frame.to_space(p));
    return parts;
}

/// What the blockers, and the horizon, leave of the source's uncovered part; in the source's plane.
struct Sight {
    ConvexPieces visible;
    double area = 0; ///< of the uncovered part
};

Sight see(const Vec3 &x, const Vec3 &n, const Surface &source, const Blockers &blockers,
          const std::vector<PairBlocker> &between) {
    Sight sight;
    VisibleScratch scratch;
    Work work;
    scratch.hidden.cast(x, source.frame, blockers, between, work);
    for (const Polygon &part : source.parts) {
        ConvexPieces whole, rest;
        whole.add(part);
        for (const Polygon &cover : source.covers) {
            subtract(whole, half_planes(cover), rest);
            std::swap(whole, rest);
        }
        sight.area += whole.area();
        visible_part(x, n, source.frame, whole, scratch.hidden, scratch);
        for (std::size_t i = 0; i < scratch.pieces.size(); ++i)
            if (area(scratch.pieces[i]) > coincide * coincide)
                sight.visible.add(scratch.pieces[i]);
    }
    return sight;
}

/// The square about all points, with a margin.
void set_frame(KeyholeEmitter &emitter) {
    Vec2 low = Vec2::Constant(1e300), high = -low;
    for (const Polygon &part : emitter.whole.parts)
        for (const Vec2 &p : part) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    const Vec2 centre = (low + high) / 2;
    const double half = 0.68 * (high - low).maxCoeff();
    emitter.low = centre - Vec2::Constant(half);
    emitter.high = centre + Vec2::Constant(half);
}

/// Who looks: a point, its surface's normal, and all that it may see.
struct Onlooker {
    const Scene &scene;
    const Blockers &blockers;
    Vec3 x, n;
};

/// Nothing behind either plane blocks, and nothing outside the box about point and source.
std::vector<PairBlocker> between(const Onlooker &o, const Surface &source) {
    Vec3 low = o.x, high = o.x;
    for (const Vec3 &c : source.corners) {
        low = low.cwiseMin(c);
        high = high.cwiseMax(c);
    }
    const auto behind = [](const Blocker &b, const Vec3 &origin, const Vec3 &normal) {
        return std::ranges::all_of(b.corners, [&](const Vec3 &c) { return (c - origin).dot(normal) <= 1e-12; });
    };
    std::vector<PairBlocker> found;
    for (const int b : o.blockers.near_box(low, high))
        if (!behind(o.blockers[b], o.x, o.n) && !behind(o.blockers[b], source.frame.origin, source.frame.normal))
            found.push_back({b, false});
    return found;
}

/// Mean corner of what of the source is above the horizon; none where nothing is.
std::optional<Vec3> middle(const std::vector<std::vector<Vec3>> &parts, const HalfSpace &horizon) {
    Vec3 sum = Vec3::Zero();
    double n = 0;
    for (const auto &part : parts)
        for (const Vec3 &c : clip(part, {horizon})) {
            sum += c;
            ++n;
        }
    return n > 0 ? std::optional<Vec3>(sum / n) : std::nullopt;
}

Vec3 mean_corner(const Surface &surface) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3 &c : surface.corners)
        sum += c;
    return sum / static_cast<double>(surface.corners.size());
}

/// The blockers within the spaces, far before near. Of closed solids the faces turned away are behind the others.
std::vector<KeyholeFigure> silhouettes(const Onlooker &o, const Eye &eye, const std::vector<PairBlocker> &pairs,
                                       const std::vector<HalfSpace> &spaces) {
    std::vector<SurfaceId> surfaces; // a concave one has several blockers
    for (const PairBlocker &pair : pairs)
        if (const Blocker &b = o.blockers[pair.blocker];
            (b.solid < 0 || b.frame.height(o.x) > 0) && std::ranges::find(surfaces, b.surface) == surfaces.end())
            surfaces.push_back(b.surface);
    std::ranges::stable_sort(surfaces, std::greater<>(),
                             [&](SurfaceId s) { return (mean_corner(o.scene.surface(s)) - o.x).norm(); });
    std::vector<KeyholeFigure> figures;
    for (const SurfaceId s : surfaces) {
        const Surface &surface = o.scene.surface(s);
        if (KeyholeFigure f = figure(eye, s, surface, parts_in_space(surface), spaces); !f.parts.empty())
            figures.push_back(std::move(f));
    }
    return figures;
}

void draw_visible(const Onlooker &o, const Eye &eye, const HalfSpace &before_eye, const Sight &sight, SurfaceId id,
                  KeyholeEmitter &emitter) {
    const PlaneFrame &plane = o.scene.surface(id).frame;
    for (std::size_t i = 0; i < sight.visible.size(); ++i) {
        emitter.irradiance += o.scene.exitance(id) * lambert(o.x, o.n, plane, sight.visible[i]);
        std::vector<Vec3> piece;
        for (const Vec2 &p : sight.visible[i])
            piece.push_back(plane.to_space(p));
        Polygon polygon;
        for (const Vec3 &y : clip(std::move(piece), {before_eye}))
            polygon.push_back(eye.place(y));
        if (!polygon.empty())
            emitter.visible.push_back(std::move(polygon));
    }
    for (const Vec2 &corner : corners_of_union(sight.visible, coincide))
        if (const Vec3 y = plane.to_space(corner); before_eye.height(y) >= 0)
            emitter.corners.push_back({eye.place(y), o.scene.own.to_own(y)});
    emitter.share = sight.area > 0 ? std::min(1.0, sight.visible.area() / sight.area) : 0;
}

/// None when the emitter is below the horizon.
std::optional<KeyholeEmitter> look_at(const Onlooker &o, SurfaceId id) {
    const Surface &source = o.scene.surface(id);
    const HalfSpace horizon{o.x, o.n};
    const std::vector<std::vector<Vec3>> parts = parts_in_space(source);
    const auto target = middle(parts, horizon);
    if (!target)
        return std::nullopt;
    const Eye eye = eye_towards(o.scene, o.x, source.frame, *target);
    const double distance = (*target - o.x).norm();
    // What is seen at more than some 80 degrees from straight ahead has no place in a flat picture.
    const HalfSpace before_eye{o.x + 0.12 * distance * eye.ahead, eye.ahead};
    KeyholeEmitter emitter;
    emitter.whole = figure(eye, id, source, parts, {horizon, before_eye});
    if (emitter.whole.parts.empty())
        return std::nullopt;
    set_frame(emitter);
    const std::vector<PairBlocker> pairs = between(o, source);
    draw_visible(o, eye, before_eye, see(o.x, o.n, source, o.blockers, pairs), id, emitter);
    emitter.blockers = silhouettes(o, eye, pairs,
                                   {{o.x + 1e-4 * distance * eye.ahead, eye.ahead},
                                    {o.x + 1e-9 * o.n, o.n},
                                    {source.frame.origin, source.frame.normal},
                                    eye.side(Vec2::UnitX(), emitter.low.x()),
                                    eye.side(Vec2::UnitY(), emitter.low.y()),
                                    eye.side(-Vec2::UnitX(), -emitter.high.x()),
                                    eye.side(-Vec2::UnitY(), -emitter.high.y())});
    return emitter;
}

} // namespace

KeyholeEye::KeyholeEye(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)), blockers_(*scene_) {}

Keyhole KeyholeEye::look(SurfaceId id, const Vec3 &own) const {
    const Scene &scene = *scene_;
    const Surface &surface = scene.surface(id);
    const Vec2 at = surface.frame.to_plane(scene.own.to_solver(own));
    const Onlooker o{scene, blockers_, surface.frame.to_space(at), surface.frame.normal};
    Keyhole keyhole{id, scene.own.to_own(o.x), {}};
    if (is_covered(surface, at))
        return keyhole;
    for (int s = 0; s < scene.n_surfaces(); ++s)
        if (s != id.index && scene.emits(SurfaceId(s)) && scene.surface(SurfaceId(s)).frame.height(o.x) > 0)
            if (auto emitter = look_at(o, SurfaceId(s)))
                keyhole.emitters.push_back(std::move(*emitter));
    std::ranges::stable_sort(keyhole.emitters, std::greater<>(),
                             [](const KeyholeEmitter &e) { return e.irradiance.sum(); });
    return keyhole;
}

SurfaceId KeyholeEye::surface_at(const Vec3 &own, double slack) const {
    const Vec3 x = scene_->own.to_solver(own);
    SurfaceId best;
    double nearest = slack;
    for (int s = 0; s < scene_->n_surfaces(); ++s) {
        const Surface &surface = scene_->surface(SurfaceId(s));
        const double off = std::abs(surface.frame.height(x));
        const Vec2 at = surface.frame.to_plane(x);
        if (off <= nearest && scene_->reflects(SurfaceId(s)) &&
            std::ranges::any_of(surface.parts, [&](const Polygon &part) { return contains(part, at, slack); })) {
            best = SurfaceId(s);
            nearest = off;
        }
    }
    return best;
}

} // namespace penumbra
