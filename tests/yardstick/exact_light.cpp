#include "yardstick/exact_light.h"

#include "basis/element_basis.h"
#include "core/parallel.h"
#include "geometry/convex_pieces.h"
#include "measure/direct.h"

#include <cmath>

namespace penumbra::yardstick {

namespace {

constexpr double in_plane = 1e-9; // of the unit scene

/// Whether the segment passes through the interior of the convex polygon.
bool enters(const Polygon &convex, Vec2 a, Vec2 b) {
    for (const HalfPlane &h : half_planes(convex)) {
        const double at_a = h.value(a), at_b = h.value(b);
        if (at_a <= 0 && at_b <= 0)
            return false;
        if (at_a < 0)
            a += at_a / (at_a - at_b) * (b - a);
        else if (at_b < 0)
            b += at_b / (at_b - at_a) * (a - b);
    }
    return (b - a).norm() > 0;
}

} // namespace

ExactLight::ExactLight(const Scene &scene, SurfaceId surface) : scene_(scene), surface_(surface), blockers_(scene) {
    const PlaneFrame &plane = scene.surface(surface).frame;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const std::vector<Vec3> &corners = scene.surface(SurfaceId(s)).corners;
        for (std::size_t i = 0; s != surface.index && i < corners.size(); ++i) {
            const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if (std::abs(plane.height(a)) < in_plane && std::abs(plane.height(b)) < in_plane)
                contacts_.emplace_back(plane.to_plane(a), plane.to_plane(b));
        }
    }
}

std::vector<Sample> ExactLight::samples(const Polygon &convex, int n) const {
    std::vector<Polygon> pieces{convex};
    Polygon inside, outside;
    for (const auto &[a, b] : contacts_) {
        std::vector<Polygon> next;
        for (const Polygon &piece : pieces) {
            if (!enters(piece, a, b)) {
                next.push_back(piece);
                continue;
            }
            split(piece, {a.y() - b.y(), b.x() - a.x(), cross(a, b)}, inside, outside);
            for (const Polygon *part : {&inside, &outside})
                if (part->size() > 2)
                    next.push_back(*part);
        }
        pieces = std::move(next);
    }
    std::vector<Sample> out;
    for (const Polygon &piece : pieces)
        for (const Polygon &part : quads_and_triangles(piece))
            for (const QuadraturePoint &q : ElementBasis(1, bilinear_quad(part)).quadrature(n))
                out.push_back({q.position, q.area,
                               direct_radiosity(scene_, blockers_, surface_, q.position) - scene_.exitance(surface_)});
    return out;
}

double relative_error(const ExactLight &exact, const Forest &forest, const Coefficients &radiosity,
                      const Rgb &exitance) {
    constexpr double most_side = 1.0 / 64; // of the root: larger leaves are looked at in parts
    struct Task {
        ElementId leaf;
        Polygon part;
    };
    std::vector<Task> tasks;
    for (const ElementId root : forest.roots[exact.surface().at()])
        for_each_leaf(forest, root, [&](ElementId leaf) {
            const ElementBasis &basis = forest[leaf].basis;
            const int n = std::max(
                1, static_cast<int>(std::ceil(std::sqrt(basis.area() / forest[root].basis.area()) / most_side)));
            const auto at = [&](int i, int j) { return basis.quad().at(double(i) / n, double(j) / n); };
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    tasks.push_back(
                        {leaf, BilinearQuad{{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}}.outline()});
        });
    std::vector<std::pair<double, double>> squares(tasks.size());
    parallel_for(tasks.size(), [&](std::size_t i) {
        const Element &e = forest[tasks[i].leaf];
        const auto b = radiosity.middleRows(e.first, e.basis.n_functions());
        for (const Sample &s : exact.samples(tasks[i].part, 4)) {
            const Rgb ours = (e.basis.evaluate(s.position).transpose() * b).transpose().array() - exitance;
            squares[i].first += s.area * (ours - s.value).square().sum();
            squares[i].second += s.area * s.value.square().sum();
        }
    });
    double error = 0, whole = 0;
    for (const auto &[e, w] : squares) {
        error += e;
        whole += w;
    }
    return std::sqrt(error / whole);
}

} // namespace penumbra::yardstick
