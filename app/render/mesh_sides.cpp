#include "render/mesh_sides.h"

#include "render/corner_index.h"

#include <algorithm>
#include <map>

namespace penumbra {
namespace {

struct CornerSum {
    Rgb sum = Rgb::Zero();
    int n = 0;
};

struct Piece {
    SideKind kind;
    bool fresh;
};

/// Adds one surface's sides and corner values.
void add_surface(const Snapshot &snapshot, int surface, const std::vector<int> &patches, MeshSides &mesh) {
    const CornerIndex index(snapshot, patches);
    std::vector<CornerSum> sums(static_cast<std::size_t>(index.size()));
    std::map<std::pair<int, int>, Piece> pieces;
    const auto add_piece = [&](int a, int b, SideKind kind, bool fresh) {
        const auto [piece, is_new] = pieces.try_emplace(std::minmax(a, b), Piece{kind, fresh});
        if (!is_new) {
            piece->second.kind = std::max(piece->second.kind, kind);
            piece->second.fresh |= fresh;
        }
    };
    std::vector<std::vector<int>> borders(patches.size());
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const SnapshotPatch &patch = snapshot.patches[static_cast<std::size_t>(patches[k])];
        const std::vector<int> &corners = index.corners_of(k);
        const auto add_value = [&](int corner, const Vec2 &at) {
            CornerSum &s = sums[static_cast<std::size_t>(corner)];
            s.sum += radiosity(snapshot, patch, at);
            ++s.n;
            borders[k].push_back(corner);
        };
        for (std::size_t side = 0; side < corners.size(); ++side) {
            const std::size_t next = (side + 1) % corners.size();
            const int a = corners[side], b = corners[next];
            if (a == b)
                continue;
            add_value(a, patch.corners[side]);
            int last = a;
            const double length = (index.point(b) - index.point(a)).norm();
            for (const int c : index.between(a, b)) {
                const double t = (index.point(c) - index.point(a)).norm() / length;
                add_value(c, patch.corners[side] + t * (patch.corners[next] - patch.corners[side]));
                add_piece(last, c, patch.sides[side], patch.fresh);
                last = c;
            }
            add_piece(last, b, patch.sides[side], patch.fresh);
        }
    }
    for (const auto &[ends, piece] : pieces)
        mesh.sides.push_back({surface, index.point(ends.first), index.point(ends.second), piece.kind, piece.fresh});
    const auto mean = [&](int corner) -> Rgb {
        const CornerSum &s = sums[static_cast<std::size_t>(corner)];
        return s.sum / s.n;
    };
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const auto patch = static_cast<std::size_t>(patches[k]);
        for (const int corner : index.corners_of(k))
            mesh.corner_values[patch].push_back(mean(corner));
        for (const int corner : borders[k]) {
            mesh.borders[patch].push_back(index.point(corner));
            mesh.border_values[patch].push_back(mean(corner));
        }
    }
}

} // namespace

MeshSides mesh_sides(const Snapshot &snapshot) {
    std::vector<std::vector<int>> by_surface(snapshot.surfaces.size());
    for (std::size_t i = 0; i < snapshot.patches.size(); ++i)
        by_surface[static_cast<std::size_t>(snapshot.patches[i].surface)].push_back(static_cast<int>(i));
    MeshSides mesh;
    mesh.borders.resize(snapshot.patches.size());
    mesh.corner_values.resize(snapshot.patches.size());
    mesh.border_values.resize(snapshot.patches.size());
    for (std::size_t s = 0; s < by_surface.size(); ++s)
        add_surface(snapshot, static_cast<int>(s), by_surface[s], mesh);
    return mesh;
}

} // namespace penumbra
