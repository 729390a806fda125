#include "render/mesh_sides.h"

#include "render/corner_index.h"

#include <algorithm>
#include <map>

namespace penumbra {
namespace {

constexpr std::array<std::array<double, 2>, 4> corner_parameters{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

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
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const SnapshotPatch &patch = snapshot.patches[static_cast<std::size_t>(patches[k])];
        const auto &corners = index.corners_of(k);
        for (std::size_t side = 0; side < 4; ++side) {
            const int a = corners[side], b = corners[(side + 1) % 4];
            const auto value = [&](double t) {
                const auto &from = corner_parameters[side], &to = corner_parameters[(side + 1) % 4];
                return radiosity_at(snapshot, patch, from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]));
            };
            const auto add_value = [&](int corner, double t) {
                CornerSum &s = sums[static_cast<std::size_t>(corner)];
                s.sum += value(t);
                ++s.n;
            };
            add_value(a, 0);
            if (a == b) // the apex of a triangle
                continue;
            std::vector<Vec2> &border = mesh.borders[static_cast<std::size_t>(patches[k])];
            border.push_back(index.point(a));
            int last = a;
            const double length = (index.point(b) - index.point(a)).norm();
            for (const int c : index.between(a, b)) {
                add_value(c, (index.point(c) - index.point(a)).norm() / length);
                add_piece(last, c, patch.sides[side], patch.fresh);
                border.push_back(index.point(c));
                last = c;
            }
            add_piece(last, b, patch.sides[side], patch.fresh);
        }
    }
    for (const auto &[ends, piece] : pieces)
        mesh.sides.push_back({surface, index.point(ends.first), index.point(ends.second), piece.kind, piece.fresh});
    for (std::size_t k = 0; k < patches.size(); ++k)
        for (std::size_t c = 0; c < 4; ++c) {
            const CornerSum &s = sums[static_cast<std::size_t>(index.corners_of(k)[c])];
            mesh.corner_values[static_cast<std::size_t>(patches[k])][c] = s.sum / s.n;
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
    for (std::size_t s = 0; s < by_surface.size(); ++s)
        add_surface(snapshot, static_cast<int>(s), by_surface[s], mesh);
    return mesh;
}

} // namespace penumbra
