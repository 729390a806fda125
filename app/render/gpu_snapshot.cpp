#include "render/gpu_snapshot.h"

#include "render/look.h"
#include "render/mesh_sides.h"
#include "render/styles.h"
#include "render/surface_role.h"

#include <algorithm>

namespace penumbra {
namespace {

glm::vec3 to_vec3(const Rgb &c) { return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])}; }
glm::vec2 to_vec2(const Vec2 &p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

/// Into unit space.
struct UnitSpace {
    glm::dvec3 centre;
    double size;

    glm::vec3 operator()(const Vec3 &x) const {
        return glm::vec3((glm::dvec3(x.x(), x.y(), x.z()) - centre) / size);
    }
};

std::vector<glm::vec4> surface_texels(const Snapshot &snapshot, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    const auto direction = [](const Vec3 &d) { return glm::vec3(d.x(), d.y(), d.z()); };
    for (const SnapshotSurface &s : snapshot.surfaces) {
        texels.emplace_back(unit(s.origin), static_cast<float>(rank(s)));
        texels.emplace_back(direction(s.u), static_cast<float>(role(s)));
        texels.emplace_back(direction(s.v), s.reflectance.maxCoeff() > 0 ? 1.f : 0.f);
        texels.emplace_back(direction(s.normal), 0.f);
    }
    return texels;
}

/// Mean over the area, by 3x3 Gauss points on quads and triangles: exact, the integrand being of degree 5 at most in each
/// parameter.
Rgb mean(const Snapshot &snapshot, const SnapshotPatch &patch) {
    static const double points[] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
    static constexpr double weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    Rgb sum = Rgb::Zero();
    double area = 0;
    for (const BilinearQuad &quad : tiles(patch))
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double w = weights[i] * weights[j] * quad.jacobian(points[i], points[j]);
                sum += w * radiosity(snapshot, patch, quad.at(points[i], points[j]));
                area += w;
            }
    return area > 0 ? Rgb(sum / area) : radiosity(snapshot, patch, patch.corners[0]);
}

/// Of a patch's local coordinates: its size.
double unit_of(const SnapshotPatch &patch) {
    double unit = 1e-300;
    for (const Vec2 &c : patch.quad)
        unit = std::max(unit, (c - patch.quad[0]).norm());
    return unit;
}

/// Values at the corners of a patch that is its own quad, between which they are interpolated in its parameters.
std::array<Rgb, 4> quad_values(const SnapshotPatch &patch, const std::vector<Rgb> &corner_values) {
    std::array<Rgb, 4> values;
    values.fill(Rgb::Zero());
    for (std::size_t k = 0; k < 4; ++k)
        if (const auto found = std::ranges::find(patch.corners, patch.quad[k]); found != patch.corners.end())
            values[k] = corner_values[static_cast<std::size_t>(found - patch.corners.begin())];
    return values;
}

std::vector<glm::vec4> patch_texels(const Snapshot &snapshot, double size, const MeshSides &mesh) {
    std::vector<glm::vec4> texels;
    texels.reserve(8 * snapshot.patches.size());
    for (std::size_t i = 0; i < snapshot.patches.size(); ++i) {
        const SnapshotPatch &p = snapshot.patches[i];
        const double unit = unit_of(p);
        const auto local = [&](std::size_t k) { return to_vec2((p.quad[k] - p.quad[0]) / unit); };
        texels.emplace_back(to_vec2(p.quad[0] / size), static_cast<float>(unit / size), static_cast<float>(p.surface));
        texels.emplace_back(local(1), local(2));
        texels.emplace_back(local(3), static_cast<float>(p.order), static_cast<float>(p.first));
        texels.emplace_back(to_vec3(mean(snapshot, p)), is_box(p) ? 1.f : 0.f);
        for (const Rgb &value : quad_values(p, mesh.corner_values[i]))
            texels.emplace_back(to_vec3(value), 0.f);
    }
    return texels;
}

/// Fans from the patches' centres to their borders: also where corners of others lie on a side no triangle is without
/// area, whose depth would be anything. With values for shading between corners; at the centre, the corners' mean.
std::vector<glm::vec4> vertex_texels(const Snapshot &snapshot, double size, const MeshSides &mesh) {
    std::vector<glm::vec4> texels;
    for (std::size_t i = 0; i < snapshot.patches.size(); ++i) {
        const SnapshotPatch &p = snapshot.patches[i];
        const double unit = unit_of(p), n_corners = static_cast<double>(p.corners.size());
        Vec2 centre = Vec2::Zero();
        Rgb middle = Rgb::Zero();
        for (std::size_t k = 0; k < p.corners.size(); ++k) {
            centre += p.corners[k] / n_corners;
            middle += mesh.corner_values[i][k] / n_corners;
        }
        const auto add = [&](const Vec2 &x, const Rgb &value) {
            texels.emplace_back(to_vec2(x / size), to_vec2((x - p.quad[0]) / unit));
            texels.emplace_back(static_cast<float>(i), to_vec3(value)); // exact up to 2^24
        };
        const std::vector<Vec2> &border = mesh.borders[i];
        for (std::size_t k = 0; k < border.size(); ++k) {
            const std::size_t next = (k + 1) % border.size();
            add(centre, middle);
            add(border[k], mesh.border_values[i][k]);
            add(border[next], mesh.border_values[i][next]);
        }
    }
    return texels;
}

void add_segment(std::vector<glm::vec4> &texels, const glm::vec3 &from, const glm::vec3 &to, int style, int surface,
                 float start = 0) {
    if (from == to)
        return;
    texels.emplace_back(from, static_cast<float>(style + 64 * (surface + 1)));
    texels.emplace_back(to, start);
}

std::vector<glm::vec4> mesh_segments(const Snapshot &snapshot, const std::vector<MeshSide> &sides, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    for (const MeshSide &side : sides) {
        const SnapshotSurface &s = snapshot.surfaces[static_cast<std::size_t>(side.surface)];
        if (role(s) == SurfaceRole::reflector)
            add_segment(texels, unit(to_space(s, side.from)), unit(to_space(s, side.to)),
                        styles::mesh_side(side.kind, side.fresh), side.surface);
    }
    return texels;
}

/// The sides of the element, and what links it.
std::vector<glm::vec4> newest_linking_segments(const Snapshot &snapshot, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    const int k = snapshot.n_shown_linkings - 1;
    const std::vector<Vec3> &receiver = (*snapshot.linkings)[static_cast<std::size_t>(k)].receiver;
    for (std::size_t c = 0; c < receiver.size(); ++c)
        add_segment(texels, unit(receiver[c]), unit(receiver[(c + 1) % receiver.size()]), styles::newest_side, -1);
    for (const SnapshotLink &link : snapshot.links)
        if (link.linking == k)
            add_segment(texels, unit(link.receiver), unit(link.source), styles::newest_side, -1);
    return texels;
}

/// The sides of its pieces, and the curve that it follows; or the pair that was linked last.
std::vector<glm::vec4> newest_event_segments(const Snapshot &snapshot, const std::vector<MeshSide> &sides, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    if (snapshot.n_shown_linkings > 0)
        return newest_linking_segments(snapshot, unit);
    if (snapshot.n_shown_events <= 0)
        return texels;
    for (const MeshSide &side : sides) {
        const SnapshotSurface &s = snapshot.surfaces[static_cast<std::size_t>(side.surface)];
        if (side.fresh)
            add_segment(texels, unit(to_space(s, side.from)), unit(to_space(s, side.to)), styles::newest_side, side.surface);
    }
    const SnapshotEvent &event = (*snapshot.events)[static_cast<std::size_t>(snapshot.n_shown_events - 1)];
    if (event.curve < 0)
        return texels;
    const SnapshotCurve &curve = (*snapshot.curves)[static_cast<std::size_t>(event.curve)];
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
        add_segment(texels, unit(curve.points[k]), unit(curve.points[k + 1]), styles::newest_curve(curve.kind), curve.receiver);
    return texels;
}

std::vector<glm::vec4> outline_segments(const Snapshot &snapshot, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    for (const SnapshotSurface &s : snapshot.surfaces)
        for (std::size_t k = 0; k < s.outline.size(); ++k)
            add_segment(texels, unit(to_space(s, s.outline[k])), unit(to_space(s, s.outline[(k + 1) % s.outline.size()])),
                        styles::outline(role(s)), -1);
    return texels;
}

std::vector<glm::vec4> curve_segments(const Snapshot &snapshot, const CurveFilter &filter, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    if (snapshot.curves)
        for (const SnapshotCurve &curve : *snapshot.curves) {
            if (!filter.shows(curve))
                continue;
            float start = 0;
            for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
                const glm::vec3 from = unit(curve.points[k]), to = unit(curve.points[k + 1]);
                add_segment(texels, from, to, styles::curve(curve.kind, curve.order), curve.receiver, start);
                start += glm::distance(from, to);
            }
        }
    return texels;
}

std::vector<glm::vec4> link_segments(const Snapshot &snapshot, const UnitSpace &unit) {
    std::vector<glm::vec4> texels;
    for (const SnapshotLink &link : snapshot.links)
        add_segment(texels, unit(link.receiver), unit(link.source), styles::link(link.kind), -1);
    return texels;
}

} // namespace

void GpuSnapshot::upload_curves(const Snapshot &snapshot, const CurveFilter &filter) {
    curves.upload(curve_segments(snapshot, filter, {centre, size}));
}

void GpuSnapshot::upload(const Snapshot &snapshot) {
    bounds = penumbra::bounds(snapshot);
    centre = bounds.centre();
    size = std::max(bounds.size(), 1e-300);
    const Snapshot *one = &snapshot;
    range = common_range({&one, 1});
    const UnitSpace unit{centre, size};
    const MeshSides mesh = mesh_sides(snapshot);

    surfaces.upload(surface_texels(snapshot, unit));
    patches.upload(patch_texels(snapshot, size, mesh));
    std::vector<glm::vec4> texels = vertex_texels(snapshot, size, mesh);
    vertices.upload(texels);
    n_vertices = vertices.size() / 2;
    texels.clear();
    for (const Rgb &c : snapshot.coefficients)
        texels.emplace_back(to_vec3(c), 0.f);
    coefficients.upload(texels);

    mesh_lines.upload(mesh_segments(snapshot, mesh.sides, unit));
    newest_event.upload(newest_event_segments(snapshot, mesh.sides, unit));
    outlines.upload(outline_segments(snapshot, unit));
    links.upload(link_segments(snapshot, unit));

    // Triangles of what is seen through, from the patches that tile it, and of covers.
    texels.clear();
    covers.clear();
    glass.clear();
    const std::vector<Back> back = backs(snapshot);
    std::vector<std::vector<int>> patches_of(snapshot.surfaces.size());
    for (std::size_t i = 0; i < snapshot.patches.size(); ++i)
        patches_of[static_cast<std::size_t>(snapshot.patches[i].surface)].push_back(static_cast<int>(i));
    const auto add_polygon = [&](std::span<const Vec2> polygon, int surface, int style) {
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
            for (const std::size_t corner : {std::size_t{0}, k, k + 1})
                texels.emplace_back(to_vec2(polygon[corner] / size), static_cast<float>(surface), static_cast<float>(style));
    };
    for (std::size_t i = 0; i < snapshot.surfaces.size(); ++i) {
        const SnapshotSurface &s = snapshot.surfaces[i];
        const int id = static_cast<int>(i);
        glm::vec3 middle{0};
        for (const Vec2 &p : s.outline)
            middle += unit(to_space(s, p)) / static_cast<float>(s.outline.size());
        TintGroup cover{static_cast<int>(texels.size()), 0, id, styles::cover, middle};
        for (const auto &polygon : s.covers)
            add_polygon(polygon, id, styles::cover);
        cover.count = static_cast<int>(texels.size()) - cover.first;
        if (cover.count > 0)
            covers.push_back(cover);
        if (back[i] == Back::hidden && role(s) != SurfaceRole::blocker)
            continue;
        TintGroup group{static_cast<int>(texels.size()), 0, id, styles::glass(role(s)), middle};
        for (const int k : patches_of[i])
            add_polygon(snapshot.patches[static_cast<std::size_t>(k)].corners, id, group.style);
        group.count = static_cast<int>(texels.size()) - group.first;
        if (group.count > 0)
            glass.push_back(group);
    }
    tints.upload(texels);

    surface_planes.clear();
    for (const SnapshotSurface &s : snapshot.surfaces) {
        const glm::vec3 normal(s.normal.x(), s.normal.y(), s.normal.z());
        surface_planes.emplace_back(normal, -glm::dot(normal, unit(s.origin)));
    }
}

} // namespace penumbra
