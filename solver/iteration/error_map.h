// Where a solution is wrong, and by how much: its distance from the truth all over its patches.
#pragma once

#include "core/cancel.h"
#include "iteration/truth.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace penumbra {

/// On a lattice of (n + 2)^2 points over each tile of the patch (tiles()): n Gauss points to a parameter, in cells of
/// four, and the tile's border. Border values are those of the inside.
struct PatchError {
    int n = 0;                ///< 0: no lattice; the patch reflects nothing
    std::vector<Vec2> points; ///< in the surface's plane; tile after tile, row after row, u running along a row
    std::vector<Rgb> missed;  ///< B_h - B there [W/m2]; 0 under covers
    double square = 0;        ///< integral over the patch of (B_h - B)^2, the channels together [(W/m2)^2 length^2]
};

/// Immutable once made; it belongs to the one snapshot.
struct ErrorMap {
    std::uint64_t version = 0;       ///< of the snapshot
    std::vector<PatchError> patches; ///< as snapshot.patches
    double reflected = 0;            ///< integral of (B - E)^2 over the reflecting surfaces, the channels together
    double peak = 0;                 ///< largest B - E at a point of a lattice, of any channel [W/m2]
    double truth_error = 0;          ///< Truth::error
    std::optional<EffectChange> change; ///< Truth::change: for "truth" and B read "the changed solution"; `reflected` is of the brighter of the two
    std::uint64_t against = 0;          ///< Truth::version: the same for "the other solution"

    /// ||B_h - B|| / ||B - E||: the root of the sum of the patches' squares, as Snapshot::error.
    double error() const;
    /// A patch's part of it: the squares of all of them add up to the square of error().
    double share(std::size_t patch) const;
};

/// How close a map's points stand.
struct MapDensity {
    int points = 96;        ///< to the side of a square surface, at least
    int constant_cells = 2; ///< to the side of a patch with one value, at least, each of four points
    int cells = 4;          ///< of another patch
};
/// Of an exact truth as above; one that is gathered costs a hundred times as much, and gets fewer.
MapDensity map_density(const Truth &truth);

/// Makes maps of solutions of one scene. Points of a patch that is in several solutions are asked for once.
class ErrorMapper {
public:
    explicit ErrorMapper(const Truth &truth) : ErrorMapper(truth, map_density(truth)) {}
    ErrorMapper(Truth truth, const MapDensity &density) : truth_(std::move(truth)), density_(density) {}

    /// On all threads. `told` hears of every hundredth that is done [percent], on any of them. Throws Cancelled.
    std::shared_ptr<const ErrorMap> map(const Snapshot &snapshot, const Cancel *cancel = nullptr,
                                        const std::function<void(int)> &told = {});
    const Truth &truth() const { return truth_; }

private:
    using Values = std::shared_ptr<const std::vector<Rgb>>;

    Truth truth_;
    MapDensity density_;
    std::map<std::vector<double>, Values> known_; ///< by surface, lattice, and corners
};

} // namespace penumbra
