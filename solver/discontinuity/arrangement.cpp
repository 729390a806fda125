#include "discontinuity/arrangement.h"

#include "discontinuity/snap_lines.h"
#include "discontinuity/tolerance.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <map>

namespace penumbra {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Segments = CGAL::Arr_segment_traits_2<Kernel>;
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<Segments, int>; ///< pieces whose segments overlap
using Exact = CGAL::Arrangement_2<Traits>;

constexpr int border_line = 0; ///< the caller's lines follow

Exact exact_arrangement(const SnappedLines &snapped) {
    const auto point = [&](int p) {
        const Vec2 &x = snapped.points[static_cast<std::size_t>(p)];
        return Kernel::Point_2(x.x(), x.y());
    };
    std::vector<Traits::Curve_2> curves;
    for (std::size_t i = 0; i < snapped.pieces.size(); ++i)
        curves.emplace_back(Segments::Curve_2(point(snapped.pieces[i].from), point(snapped.pieces[i].to)),
                            static_cast<int>(i));
    Exact exact;
    CGAL::insert(exact, curves.begin(), curves.end());
    return exact;
}

class Reader {
public:
    Reader(const Exact &exact, const SnappedLines &snapped) : exact_(exact), snapped_(snapped) {}

    Arrangement run() {
        find_outside();
        for (auto f = exact_.faces_begin(); f != exact_.faces_end(); ++f)
            if (!outside_.contains(f)) {
                faces_.emplace(f, static_cast<int>(out_.faces.size()));
                out_.faces.emplace_back();
            }
        for (auto e = exact_.edges_begin(); e != exact_.edges_end(); ++e)
            read_edge(e);
        for (const auto &[face, number] : faces_)
            read_face(face, out_.faces[static_cast<std::size_t>(number)]);
        return std::move(out_);
    }

private:
    std::vector<int> lines_of(Exact::Halfedge_const_handle h) const {
        std::vector<int> lines;
        for (const int piece : h->curve().data()) {
            const auto &of_piece = snapped_.pieces[static_cast<std::size_t>(piece)].lines;
            lines.insert(lines.end(), of_piece.begin(), of_piece.end());
        }
        std::ranges::sort(lines);
        const auto twins = std::ranges::unique(lines);
        lines.erase(twins.begin(), twins.end());
        return lines;
    }
    bool on_border(Exact::Halfedge_const_handle h) const { return lines_of(h).front() == border_line; }

    template <class Visit>
    static void for_each_cycle(Exact::Face_const_handle face, const Visit &visit) {
        for (auto c = face->outer_ccbs_begin(); c != face->outer_ccbs_end(); ++c)
            visit(*c, true);
        for (auto c = face->inner_ccbs_begin(); c != face->inner_ccbs_end(); ++c)
            visit(*c, false);
    }

    /// What can be reached from far away without crossing the border.
    void find_outside() {
        std::vector<Exact::Face_const_handle> open{exact_.unbounded_face()};
        outside_.emplace(open[0], true);
        while (!open.empty()) {
            const Exact::Face_const_handle face = open.back();
            open.pop_back();
            for_each_cycle(face, [&](Exact::Ccb_halfedge_const_circulator start, bool) {
                auto h = start;
                do {
                    const Exact::Face_const_handle next = h->twin()->face();
                    if (!on_border(h) && outside_.emplace(next, true).second)
                        open.push_back(next);
                } while (++h != start);
            });
        }
    }

    int number_of(Exact::Face_const_handle face) const {
        const auto found = faces_.find(face);
        return found == faces_.end() ? -1 : found->second;
    }
    int number_of(Exact::Vertex_const_handle vertex) {
        const auto [at, is_new] = vertices_.emplace(vertex, static_cast<int>(out_.vertices.size()));
        if (is_new)
            out_.vertices.emplace_back(CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y()));
        return at->second;
    }

    void read_edge(Exact::Halfedge_const_handle h) {
        ArrangementEdge edge;
        edge.left = number_of(h->face());
        edge.right = number_of(h->twin()->face());
        if (edge.left < 0 && edge.right < 0)
            return;
        edge.from = number_of(h->source());
        edge.to = number_of(h->target());
        for (const int line : lines_of(h))
            if (line == border_line)
                edge.border = true;
            else
                edge.lines.push_back(line - border_line - 1);
        out_.edges.push_back(std::move(edge));
    }

    void read_face(Exact::Face_const_handle face, ArrangementFace &out) {
        for_each_cycle(face, [&](Exact::Ccb_halfedge_const_circulator start, bool outer) {
            std::vector<int> &cycle = outer ? out.outline : out.holes.emplace_back();
            Polygon polygon;
            auto h = start;
            do {
                cycle.push_back(number_of(h->source()));
                polygon.push_back(out_.vertices[static_cast<std::size_t>(cycle.back())]);
            } while (++h != start);
            out.area += area(polygon); // of a hole it is negative
        });
    }

    const Exact &exact_;
    const SnappedLines &snapped_;
    std::map<Exact::Face_const_handle, bool> outside_;
    std::map<Exact::Face_const_handle, int> faces_;
    std::map<Exact::Vertex_const_handle, int> vertices_;
    Arrangement out_;
};

} // namespace

Arrangement arrange(std::span<const Vec2> outline, std::span<const std::vector<Vec2>> lines, double snap) {
    std::vector<std::vector<Vec2>> all{{outline.begin(), outline.end()}};
    all[border_line].push_back(outline.front());
    all.insert(all.end(), lines.begin(), lines.end());
    const SnappedLines snapped = snap_lines(all, snap);
    const Exact exact = exact_arrangement(snapped);
    return Reader(exact, snapped).run();
}

Arrangement arrange(const Surface &receiver, std::span<const Curve> curves) {
    const double size = 2 * radius(receiver.outline);
    std::vector<std::vector<Vec2>> lines;
    for (const Curve &curve : curves)
        lines.push_back(polyline(curve, 1e-6 * size));
    return arrange(receiver.outline, lines, coincidence);
}

} // namespace penumbra
