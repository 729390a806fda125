#include "iteration/error_map.h"

#include "basis/gauss.h"
#include "core/parallel.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace penumbra {

namespace {

/// A point on the border is drawn there and asked for inside, by this part of a parameter: on the far side of a jump
/// there is another patch.
constexpr double inset = 1e-6;

/// Gauss points of a cell: between them an error of the degree that an element misses is integrated exactly.
constexpr int cell_points = 4;

/// Rows of a lattice of n points a parameter: the border, and Gauss's in n / cell_points cells, with their weights.
struct Stops {
    std::vector<double> at, weight;
};

Stops stops(int n, double border) {
    const GaussRule &rule = gauss_rule(cell_points);
    const int n_cells = n / cell_points;
    Stops all{{border}, {0}};
    for (int cell = 0; cell < n_cells; ++cell)
        for (std::size_t i = 0; i < cell_points; ++i) {
            all.at.push_back((cell + rule.points[i]) / n_cells);
            all.weight.push_back(rule.weights[i] / n_cells);
        }
    all.at.push_back(1 - border);
    all.weight.push_back(0);
    return all;
}

bool reflects(const Snapshot &snapshot, const SnapshotPatch &patch) {
    return snapshot.surfaces[static_cast<std::size_t>(patch.surface)].reflectance.maxCoeff() > 0;
}

int lattice(const Snapshot &snapshot, const SnapshotPatch &patch, std::size_t n_tiles, const MapDensity &density) {
    const double share = area(patch.corners) / area(snapshot.surfaces[static_cast<std::size_t>(patch.surface)].outline);
    const double n = std::min(1.0, std::sqrt(share / static_cast<double>(n_tiles))) * density.points / cell_points;
    const int least = patch.order == 1 ? density.constant_cells : density.cells;
    return cell_points * std::max(least, static_cast<int>(std::ceil(n)));
}

std::vector<double> key_of(const SnapshotPatch &patch, int n) {
    std::vector<double> key{static_cast<double>(patch.surface), static_cast<double>(n)};
    for (const auto &corners : {std::span<const Vec2>(patch.quad), std::span<const Vec2>(patch.corners)})
        for (const Vec2 &p : corners)
            key.insert(key.end(), {p.x(), p.y()});
    return key;
}

} // namespace

MapDensity map_density(const Truth &truth) { return truth.error > 0 ? MapDensity{24, 1, 1} : MapDensity{}; }

double ErrorMap::error() const {
    double sum = 0;
    for (const PatchError &p : patches)
        sum += p.square;
    return reflected > 0 ? std::sqrt(sum / reflected) : 0;
}

double ErrorMap::share(std::size_t patch) const {
    return reflected > 0 ? std::sqrt(patches[patch].square / reflected) : 0;
}

std::shared_ptr<const ErrorMap> ErrorMapper::map(const Snapshot &snapshot, const Cancel *cancel,
                                                 const std::function<void(int)> &told) {
    const std::size_t n_patches = snapshot.patches.size();
    auto map = std::make_shared<ErrorMap>();
    map->version = snapshot.version;
    map->truth_error = truth_.error;
    map->change = truth_.change;
    map->against = truth_.version;
    map->patches.resize(n_patches);
    std::vector<Values> values(n_patches);
    std::vector<double> reflected(n_patches), peak(n_patches);
    std::vector<double> own_reflected(n_patches); // of the solution that is judged
    std::atomic<std::size_t> done{0};
    parallel_for(n_patches, [&](std::size_t i) {
        const SnapshotPatch &patch = snapshot.patches[i];
        if (!reflects(snapshot, patch))
            return;
        const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(patch.surface)];
        const std::vector<BilinearQuad> quads = tiles(patch);
        PatchError &out = map->patches[i];
        out.n = lattice(snapshot, patch, quads.size(), density_);
        const auto found = known_.find(key_of(patch, out.n));
        if (found != known_.end())
            values[i] = found->second;
        std::vector<Rgb> fresh;
        const Stops drawn = stops(out.n, 0), asked = stops(out.n, inset);
        const std::size_t side = asked.at.size();
        const bool whole = quads.size() == 1 && !is_box(patch);
        for (const BilinearQuad &quad : quads)
            for (std::size_t row = 0; row < side; ++row) {
                if (cancel)
                    cancel->check();
                for (std::size_t column = 0; column < side; ++column) {
                    const double u = asked.at[column], v = asked.at[row];
                    const Vec2 p = quad.at(u, v);
                    out.points.push_back(quad.at(drawn.at[column], drawn.at[row]));
                    const bool covered = is_covered(surface, p);
                    if (!values[i])
                        fresh.push_back(covered ? Rgb(Rgb::Zero()) : truth_.radiosity_at(patch.surface, p));
                    const Rgb &truth = values[i] ? (*values[i])[out.missed.size()] : fresh.back();
                    const Rgb ours =
                        whole ? penumbra::radiosity_at(snapshot, patch, u, v) : radiosity(snapshot, patch, p);
                    out.missed.push_back(covered ? Rgb(Rgb::Zero()) : Rgb(ours - truth));
                    const double weight = asked.weight[column] * asked.weight[row] * quad.jacobian(u, v);
                    if (covered || weight <= 0)
                        continue;
                    const Rgb bounced = truth - surface.exitance;
                    out.square += weight * out.missed.back().square().sum();
                    reflected[i] += weight * bounced.square().sum();
                    own_reflected[i] += weight * (ours - surface.exitance).square().sum();
                    peak[i] = std::max(peak[i], bounced.maxCoeff());
                    if (truth_.is_a_solution())
                        peak[i] = std::max(peak[i], (ours - surface.exitance).maxCoeff());
                }
            }
        if (!values[i])
            values[i] = std::make_shared<const std::vector<Rgb>>(std::move(fresh));
        const std::size_t n = ++done;
        if (told && 100 * n / n_patches != 100 * (n - 1) / n_patches)
            told(static_cast<int>(100 * n / n_patches));
    });
    double own = 0;
    for (std::size_t i = 0; i < n_patches; ++i) {
        if (!values[i])
            continue;
        own += own_reflected[i];
        map->reflected += reflected[i];
        map->peak = std::max(map->peak, peak[i]);
        known_.try_emplace(key_of(snapshot.patches[i], map->patches[i].n), values[i]);
    }
    if (truth_.is_a_solution())
        map->reflected = std::max(map->reflected, own);
    return map;
}

} // namespace penumbra
