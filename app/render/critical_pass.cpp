#include "render/critical_pass.h"

#include "iteration/critical_surface.h"
#include "render/curve_pass.h"

namespace penumbra {
namespace {

enum Style { curve, touched_edge, touched_corner };

constexpr int n_sights = 33;     // enough for the most curved quadric to look smooth
constexpr int between_lines = 4; // of which every fourth is drawn as a line

/// Triangles and segments in unit space, as sheet.vert and line.vert read them.
struct Shapes {
    glm::dvec3 centre;
    double size;
    std::vector<glm::vec4> sheet{}, sights{}, segments{};

    glm::vec3 unit(const Vec3 &x) const { return glm::vec3((glm::dvec3(x.x(), x.y(), x.z()) - centre) / size); }
    void add_triangle(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
        for (const Vec3 &p : {a, b, c})
            sheet.emplace_back(unit(p), 1.f);
    }
    void add_segment(const Vec3 &from, const Vec3 &to, Style style) { add_to(segments, from, to, style); }
    void add_sight(const std::vector<Vec3> &stops) { add_to(sights, stops.front(), stops.back(), 0); }
    void add_to(std::vector<glm::vec4> &list, const Vec3 &from, const Vec3 &to, int style) const {
        if (from == to)
            return;
        list.emplace_back(unit(from), static_cast<float>(style));
        list.emplace_back(unit(to), 0.f);
    }
    /// A small star.
    void add_corner(const Vec3 &at) {
        const double reach = 0.006 * size;
        for (const Vec3 &axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
            add_segment(at - reach * axis, at + reach * axis, touched_corner);
    }

    void sweep(const std::vector<Vec3> &one, const std::vector<Vec3> &next) {
        for (std::size_t k = 0; k + 1 < one.size(); ++k) {
            add_triangle(one[k], next[k], one[k + 1]);
            add_triangle(next[k], next[k + 1], one[k + 1]);
        }
    }
};

} // namespace

CriticalPass::CriticalPass() : program_({"space.glsl", "sheet.vert"}, {"sheet.frag"}) {}

void CriticalPass::upload(const Snapshot &snapshot, const Spotlight &spotlight) {
    const Bounds box = bounds(snapshot);
    Shapes shapes{box.centre(), std::max(box.size(), 1e-300)};
    if (snapshot.curves && spotlight.curve >= 0 &&
        static_cast<std::size_t>(spotlight.curve) < snapshot.curves->size()) {
        const SnapshotCurve &c = (*snapshot.curves)[static_cast<std::size_t>(spotlight.curve)];
        kind_ = c.kind;
        if (spotlight.surface) {
            const CriticalSurface critical = critical_surface(snapshot, c, n_sights);
            const auto &sights = critical.sights;
            for (std::size_t i = 0; i + 1 < sights.size(); ++i)
                shapes.sweep(sights[i], sights[i + 1]);
            for (std::size_t i = 0; i < sights.size(); i += between_lines)
                shapes.add_sight(sights[i]);
            for (std::size_t i = 1; i + 1 < critical.sheet.size(); ++i)
                shapes.add_triangle(critical.sheet[0], critical.sheet[i], critical.sheet[i + 1]);
            for (const SnapshotEdge &edge : c.touched)
                edge.is_corner() ? shapes.add_corner(edge.a) : shapes.add_segment(edge.a, edge.b, touched_edge);
        }
        for (std::size_t i = 0; i + 1 < c.points.size(); ++i)
            shapes.add_segment(c.points[i], c.points[i + 1], curve);
    }
    sheet_.upload(shapes.sheet);
    sights_.upload(shapes.sights);
    segments_.upload(shapes.segments);
}

void CriticalPass::draw(const LinePass &lines, const Frame &frame) const {
    if (segments_.size() == 0)
        return;
    const glm::vec4 colour = curve_rgba(kind_);
    if (sheet_.size() > 0) {
        program_.use();
        frame.set_space(program_);
        sheet_.bind(1);
        program_.set("vertices", 1);
        program_.set("fill", glm::vec4(glm::vec3(colour), 0.36f));
        glDrawArrays(GL_TRIANGLES, 0, sheet_.size());
    }
    LineStyles thin;
    thin.set(0, glm::vec4(glm::vec3(colour), 0.8f), 1.f);
    lines.draw(frame, sights_, thin, 2e-3f);
    LineStyles styles;
    styles.set(touched_edge, {1, 1, 1, 1}, 3.f);
    styles.set(touched_corner, {1, 1, 1, 1}, 4.f);
    styles.set(curve, colour, 4.f);
    lines.draw(frame, segments_, styles, 2e-3f, {0.03, 0.04, 0.06, 0.85});
}

} // namespace penumbra
