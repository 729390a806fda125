#include "synthetic.h"

#include "geometry/plane_frame.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <random>

namespace penumbra::synthetic {
namespace {

using Quad = std::array<Vec2, 4>;
using Field = std::function<Rgb(const Vec2 &)>;

std::uint64_t next_version() {
    static std::atomic<std::uint64_t> version{1000000};
    return ++version;
}

std::array<double, 4> legendre(double x) {
    const double t = 2 * x - 1;
    return {1, std::sqrt(3.0) * t, std::sqrt(5.0) * (3 * t * t - 1) / 2, std::sqrt(7.0) * (5 * t * t * t - 3 * t) / 2};
}

int add_surface(Snapshot &s, const std::string &name, const std::vector<Vec3> &corners, const Rgb &reflectance,
                const Rgb &exitance = Rgb::Zero()) {
    const PlaneFrame f = plane_frame(corners);
    SnapshotSurface surface{f.origin, f.u, f.v, f.normal, {}, {}, reflectance, exitance, name};
    for (const Vec3 &x : corners)
        surface.outline.push_back(f.to_plane(x));
    s.surfaces.push_back(surface);
    return static_cast<int>(s.surfaces.size()) - 1;
}

SnapshotPatch &add_patch(Snapshot &s, int surface, const Quad &corners, int order, const std::vector<Rgb> &coefficients) {
    SnapshotPatch patch;
    patch.surface = surface;
    patch.order = order;
    patch.first = static_cast<std::int32_t>(s.coefficients.size());
    patch.quad = corners;
    patch.corners = BilinearQuad{corners}.outline();
    patch.sides.assign(patch.corners.size(), SideKind::uniform);
    s.coefficients.insert(s.coefficients.end(), coefficients.begin(), coefficients.end());
    s.patches.push_back(patch);
    return s.patches.back();
}

/// Projects a field of the plane onto the patch's basis (8x8 midpoints: near enough for a picture).
SnapshotPatch &add_projected(Snapshot &s, int surface, const Quad &c, int order, const Field &field) {
    std::vector<Rgb> coefficients(static_cast<std::size_t>(order * order), Rgb::Zero());
    constexpr int n = 8;
    for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
            const double u = (a + 0.5) / n, v = (b + 0.5) / n;
            const Vec2 p = (1 - u) * (1 - v) * c[0] + u * (1 - v) * c[1] + u * v * c[2] + (1 - u) * v * c[3];
            const auto lu = legendre(u), lv = legendre(v);
            const Rgb value = field(p) / (n * n);
            for (int i = 0; i < order; ++i)
                for (int j = 0; j < order; ++j)
                    coefficients[static_cast<std::size_t>(i * order + j)] +=
                        value * lu[static_cast<std::size_t>(i)] * lv[static_cast<std::size_t>(j)];
        }
    return add_patch(s, surface, c, order, coefficients);
}

Quad rectangle(double x0, double y0, double x1, double y1) { return {Vec2(x0, y0), {x1, y0}, {x1, y1}, {x0, y1}}; }

/// The whole of a rectangular surface as one patch, its sides the outline.
void add_whole(Snapshot &s, int surface, int order, const Field &field) {
    const auto &outline = s.surfaces[static_cast<std::size_t>(surface)].outline;
    SnapshotPatch &patch = add_projected(s, surface, {outline[0], outline[1], outline[2], outline[3]}, order, field);
    std::ranges::fill(patch.sides, SideKind::outline);
}

void finish(Snapshot &s, const std::string &scene, double peak) {
    s.version = next_version();
    s.scene = scene;
    s.peak = peak;
    s.counters.patches = static_cast<int>(s.patches.size());
    s.counters.coefficients = static_cast<std::int64_t>(s.coefficients.size());
}

} // namespace

std::shared_ptr<const Snapshot> patch_zoo() {
    auto s = std::make_shared<Snapshot>();
    const int floor = add_surface(*s, "zoo", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Rgb::Constant(0.5));
    const Vec2 a(0.36, 0.35), b(0.64, 0.37), c(0.5, 0.63);
    const std::vector<Quad> quads = {
        rectangle(0.02, 0.02, 0.32, 0.32),
        rectangle(0.35, 0.02, 0.98, 0.12),
        {Vec2(0.70, 0.20), {0.98, 0.20}, {0.90, 0.45}, {0.74, 0.45}},
        {Vec2(0.02, 0.36), {0.30, 0.40}, {0.33, 0.66}, {0.06, 0.58}},
        {Vec2(0.35, 0.20), {0.66, 0.21}, {0.66, 0.235}, {0.35, 0.23}},
        {a, b, c, c},
        {Vec2(0.02, 0.70), {0.02, 0.70}, {0.32, 0.75}, {0.10, 0.97}},
        {Vec2(0.36, 0.70), {0.64, 0.72}, {0.64, 0.72}, {0.45, 0.97}},
        {Vec2(0.70, 0.55), {0.97, 0.60}, {0.80, 0.95}, {0.70, 0.55}},
    };
    constexpr int orders[] = {4, 1, 3, 4, 2, 4, 2, 3, 4};
    std::mt19937 random(7); // the same numbers on every machine, as the standard fixes this generator
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (std::size_t k = 0; k < quads.size(); ++k) {
        const int order = orders[k];
        std::vector<Rgb> coefficients;
        for (int i = 0; i < order * order; ++i)
            coefficients.push_back(i == 0 ? Rgb(1, 0.9, 0.8) : Rgb(0.1 * (uniform() - 0.5), 0.1 * (uniform() - 0.5), 0.1 * (uniform() - 0.5)));
        Quad local = quads[k];
        const SnapshotSurface &f = s->surfaces[0];
        for (Vec2 &p : local)
            p = Vec2((Vec3(p.x(), p.y(), 0) - f.origin).dot(f.u), (Vec3(p.x(), p.y(), 0) - f.origin).dot(f.v));
        add_patch(*s, floor, local, order, coefficients);
    }
    finish(*s, "patch zoo", 1.5);
    return s;
}

std::shared_ptr<const Snapshot> lamp_and_blocker() {
    auto s = std::make_shared<Snapshot>();
    const int floor = add_surface(*s, "floor", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, Rgb::Constant(0.6));
    const int lamp = add_surface(*s, "lamp", {{-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}, {-0.5, -0.5, 2}}, Rgb::Zero(),
                                 Rgb::Constant(100));
    const int blocker = add_surface(*s, "blocker", {{0.2, -0.4, 0.7}, {0.9, -0.4, 0.7}, {0.9, 0.5, 0.7}, {0.2, 0.5, 0.7}},
                                    Rgb::Zero());
    const auto lit = [](const Vec2 &p) -> Rgb { // origin at corner (-1,-1)
        const double x = p.x() - 1, y = p.y() - 1, r2 = x * x + y * y;
        const double shade = 1 / (1 + std::exp((x - 0.1 * y - 0.05) * 18)) * 0.85 + 0.15;
        return Rgb(1, 0.97, 0.9) * (13 / ((1 + 0.3 * r2) * (1 + 0.3 * r2)) * (x > 0.85 ? 1 : shade));
    };
    // Left half: cut along a slanted line. Right half: a quadtree with hanging corners.
    const Vec2 low(0.9, 0), high(1.1, 2);
    auto &left = add_projected(*s, floor, {Vec2(0, 0), {0.8, 0}, {0.95, 2}, {0, 2}}, 4, lit);
    left.sides = {SideKind::outline, SideKind::cut, SideKind::outline, SideKind::outline};
    auto &middle = add_projected(*s, floor, {Vec2(0.8, 0), low, high, {0.95, 2}}, 4, lit);
    middle.sides = {SideKind::outline, SideKind::cut, SideKind::outline, SideKind::cut};
    auto &rest = add_projected(*s, floor, {low, Vec2(1.25, 0), {1.25, 2}, high}, 4, lit);
    rest.sides = {SideKind::outline, SideKind::uniform, SideKind::outline, SideKind::cut};
    const std::function<void(double, double, double, double, int)> split = [&](double x0, double y0, double x1, double y1,
                                                                              int depth) {
        const double edge = std::abs((x0 + x1) / 2 - 1.85);
        if (depth < 5 && edge < (x1 - x0) * 0.8) {
            const double x = (x0 + x1) / 2, y = (y0 + y1) / 2;
            split(x0, y0, x, y, depth + 1);
            split(x, y0, x1, y, depth + 1);
            split(x0, y, x, y1, depth + 1);
            split(x, y, x1, y1, depth + 1);
            return;
        }
        auto &patch = add_projected(*s, floor, rectangle(x0, y0, x1, y1), 1, lit);
        patch.depth = static_cast<float>(depth);
        patch.fresh = depth == 5;
        patch.sides = {y0 <= 0 ? SideKind::outline : SideKind::uniform, x1 >= 2 ? SideKind::outline : SideKind::uniform,
                       y1 >= 2 ? SideKind::outline : SideKind::uniform, SideKind::uniform};
    };
    for (int k = 0; k < 3; ++k)
        split(1.25, k * 2.0 / 3, 2, (k + 1) * 2.0 / 3, 1);
    add_whole(*s, lamp, 1, [](const Vec2 &) { return Rgb::Constant(100); });
    add_whole(*s, blocker, 1, [](const Vec2 &) { return Rgb::Zero(); });

    auto curves = std::make_shared<std::vector<SnapshotCurve>>();
    const auto add_curve = [&](int kind, int order, std::vector<Vec3> points) {
        curves->push_back({kind, order, lamp, floor, {blocker}, std::move(points)});
    };
    add_curve(0, 2, {{-0.1, -1, 0}, {0.1, 1, 0}});
    add_curve(1, 2, {{-0.2, -1, 0}, {-0.05, 1, 0}});
    std::vector<Vec3> arc;
    for (int i = 0; i <= 40; ++i)
        arc.emplace_back(-0.9 + 0.6 * std::cos(i * 0.03), 0.9 * std::sin(i * 0.03), 0);
    add_curve(2, 2, arc);
    add_curve(3, 1, {{0.45, -1, 0}, {0.45, 1, 0}});
    add_curve(4, 0, {{0.6, -0.6, 0}, {0.95, -0.2, 0}});
    s->curves = curves;
    for (int i = 0; i < 6; ++i)
        s->links.push_back({Vec3(-0.8 + 0.3 * i, -0.6 + 0.2 * i, 0), Vec3(0, 0, 2), i % 3});
    finish(*s, "lamp and blocker", 13);
    s->counters.iteration = 3;
    s->counters.seconds = 0.312;
    s->phase = Phase::pushed_pulled;
    s->error = 0.0123;
    return s;
}

std::shared_ptr<const Snapshot> two_events() {
    auto s = std::make_shared<Snapshot>(*lamp_and_blocker());
    const int floor = 0, lamp = 1, lower = 2;
    const Vec3 p(-0.05, -0.15, 1.35), q(0.2308, -0.2923, 1.1), aside(-0.4, -0.3, 0.05);
    const int upper = add_surface(*s, "upper", {q, p, p + aside, q + aside}, Rgb::Zero());
    add_whole(*s, upper, 1, [](const Vec2 &) { return Rgb::Zero(); });
    const auto on_floor = [](const Vec3 &x, const Vec3 &through) -> Vec3 {
        return x + x.z() / (x.z() - through.z()) * (through - x);
    };
    auto curves = std::make_shared<std::vector<SnapshotCurve>>();
    const Vec3 corner(0.5, -0.5, 2), a(0.2, -0.4, 0.7), b(0.2, 0.44, 0.7);
    curves->push_back({0, 2, lamp, floor, {lower}, {on_floor(corner, a), on_floor(corner, b)},
                       {{corner, corner, lamp}, {a, b, lower}}});
    const Vec3 end(-0.5, -0.5, 2);
    SnapshotCurve conic{2, 2, lamp, floor, {lower, upper}, {}, {{end, corner, lamp}, {a, b, lower}, {p, q, upper}}};
    for (int i = 0; i <= 32; ++i) {
        const Vec3 x = end + (0.2 + 0.6 * i / 32) * (corner - end);
        conic.points.push_back(on_floor(x, x + (a - x).cross(b - x).cross((p - x).cross(q - x))));
    }
    curves->push_back(conic);
    s->curves = curves;
    finish(*s, "two events", 13);
    return s;
}

std::shared_ptr<const Snapshot> closed_room() {
    auto s = std::make_shared<Snapshot>();
    const Rgb white = Rgb::Constant(0.7), red(0.6, 0.06, 0.05), green(0.1, 0.45, 0.09);
    const auto glow = [](const Rgb &colour) {
        return [colour](const Vec2 &p) -> Rgb {
            const double r2 = (p - Vec2(0.5, 0.5)).squaredNorm();
            return colour * (6 / (1 + 2 * r2));
        };
    };
    struct Wall {
        const char *name;
        std::vector<Vec3> corners;
        Rgb colour;
    };
    const Wall walls[] = {
        {"floor", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, white},
        {"ceiling", {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, white},
        {"left", {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, red},
        {"right", {{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}}, green},
        {"back", {{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}, white},
        {"front", {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, white},
        {"screen", {{0.3, 0.5, 0}, {0.7, 0.6, 0}, {0.7, 0.6, 0.5}, {0.3, 0.5, 0.5}}, Rgb(0.2, 0.3, 0.7)},
        {"screen, back", {{0.3, 0.5, 0.5}, {0.7, 0.6, 0.5}, {0.7, 0.6, 0}, {0.3, 0.5, 0}}, Rgb(0.2, 0.3, 0.7)},
    };
    for (const Wall &w : walls)
        add_whole(*s, add_surface(*s, w.name, w.corners, w.colour), 4, glow(w.colour));
    const int lamp = add_surface(*s, "lamp", {{0.35, 0.35, 1}, {0.35, 0.65, 1}, {0.65, 0.65, 1}, {0.65, 0.35, 1}},
                                 Rgb::Constant(0.1), Rgb(60, 55, 45));
    add_whole(*s, lamp, 1, [](const Vec2 &) { return Rgb(60, 55, 45); });
    SnapshotSurface &ceiling = s->surfaces[1];
    std::vector<Vec2> cover;
    for (const Vec2 &p : s->surfaces[static_cast<std::size_t>(lamp)].outline) {
        const Vec3 x = s->surfaces[static_cast<std::size_t>(lamp)].origin + p.x() * s->surfaces[static_cast<std::size_t>(lamp)].u +
                       p.y() * s->surfaces[static_cast<std::size_t>(lamp)].v;
        cover.emplace_back((x - ceiling.origin).dot(ceiling.u), (x - ceiling.origin).dot(ceiling.v));
    }
    ceiling.covers.push_back(cover);
    finish(*s, "closed room", 6);
    return s;
}

} // namespace penumbra::synthetic
