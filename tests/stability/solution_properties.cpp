#include "stability/solution_properties.h"

#include "core/parallel.h"
#include "reference/rays.h"
#include "reference/solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace penumbra {

namespace {

auto radiosity_of(const Element &e, const State &state) {
    return state.radiosity.middleRows(e.first, e.basis.n_functions());
}

Measurement finite(const State &state) {
    return {"values that are not finite", static_cast<double>((!state.radiosity.array().isFinite()).count()), 0};
}

Measurement not_below_black(const Scene &scene, const Options &options, const State &state) {
    double least = 0, most = 0;
    for (const Element &e : state.forest.elements) {
        if (!e.leaf())
            continue;
        for (const BilinearQuad &tile : e.basis.tiles())
            for (int i = 0; i < 5; ++i)
                for (int j = 0; j < 5; ++j) {
                    const Vec2 p = tile.at((i + 0.5) / 5, (j + 0.5) / 5);
                    if (reference::covered(scene.surface(e.surface), p))
                        continue;
                    const Rgb b = (e.basis.evaluate(p).transpose() * radiosity_of(e, state)).transpose().array();
                    least = std::min(least, b.minCoeff());
                    most = std::max(most, b.maxCoeff());
                }
    }
    const auto share = [&](double of) { return least < 0 ? -least / of : 0; };
    return is_constant(options.strategy)
               ? Measurement{"below black, of the largest", share(most), 1e-6}
               : Measurement{"below black, of the peak", share(state.peak), options.threshold};
}

bool has_reciprocity(const Scene &scene, const Element &e) {
    if (!scene.surface(e.surface).covers.empty())
        return false;
    const BilinearQuad *quad = e.basis.quad();
    return !quad || (quad->corners[0] + quad->corners[2] - quad->corners[1] - quad->corners[3]).norm() <
                        1e-9 * radius(e.basis.outline());
}

/// A_p K_00 with what may be wrong with it.
struct Exchange {
    double area_factor = 0, slack = 0;

    Exchange &operator+=(const Exchange &o) {
        area_factor += o.area_factor;
        slack += o.slack;
        return *this;
    }
};

/// How far two exchanges are apart, over what they may be.
double apart(const Exchange &a, const Exchange &b) {
    return std::abs(a.area_factor - b.area_factor) / std::max(a.slack + b.slack, 1e-300);
}

std::vector<Measurement> reciprocity(const Scene &scene, const Options &options, const State &state) {
    const double accuracy = 0.1 * options.threshold; // what refine asks of links
    std::map<std::pair<int, int>, Exchange> links, totals;
    std::map<std::pair<int, int>, bool> incomplete;
    for (const auto &of_element : state.interactions)
        for (const auto &i : of_element) {
            const Element &p = state.forest[i->receiver];
            const std::pair pair(p.surface.index, i->source.index);
            if (i->weak || !has_reciprocity(scene, p) || !scene.surface(i->source).covers.empty()) {
                incomplete[pair] = true;
                continue;
            }
            for (const Link &link : i->links) {
                const double area = p.basis.area();
                const Exchange e{area * link.kernel(0, 0), area * (accuracy * link.kernel(0, 0) +
                                                                   0.25 * link.misfit.col(0).cwiseAbs().maxCoeff())};
                totals[pair] += e;
                if (has_reciprocity(scene, state.forest[link.source]))
                    links[{i->receiver.index, link.source.index}] = e;
            }
        }
    double worst_link = 0, worst_total = 0;
    for (const auto &[pair, there] : links)
        if (const auto back = links.find({pair.second, pair.first}); back != links.end())
            worst_link = std::max(worst_link, apart(there, back->second));
    for (const auto &[pair, there] : totals)
        if (const auto back = totals.find({pair.second, pair.first});
            back != totals.end() && !incomplete[pair] && !incomplete[{pair.second, pair.first}])
            worst_total = std::max(worst_total, apart(there, back->second));
    return {{"links without reciprocity, of the slack", worst_link, 1},
            {"surfaces without reciprocity, of the slack", worst_total, 1}};
}

struct Flux {
    Rgb emitted = Rgb::Zero(), absorbed = Rgb::Zero(), lost = Rgb::Zero();
};

/// Halton's sequence in bases 2, 3, 5 and 7, moved by a random vector modulo 1 (Cranley & Patterson 1976).
class MovedHalton {
public:
    explicit MovedHalton(std::mt19937 &random) {
        for (double &m : moved_)
            m = random() / 4294967296.0;
    }
    std::array<double, 4> next() {
        ++index_;
        std::array<double, 4> out;
        constexpr std::array<int, 4> bases{2, 3, 5, 7};
        for (std::size_t d = 0; d < 4; ++d) {
            double place = 1, sum = moved_[d];
            for (int i = index_; i > 0; i /= bases[d])
                sum += (i % bases[d]) * (place /= bases[d]);
            out[d] = sum - std::floor(sum);
        }
        return out;
    }

private:
    std::array<double, 4> moved_;
    int index_ = 0;
};

/// One batch: rays from every leaf, by its power.
Flux follow(const Scene &scene, const State &state, double rays, std::uint32_t batch) {
    std::mt19937 random(77 + batch);
    double power = 0;
    for (const Element &e : state.forest.elements)
        if (e.leaf())
            power += e.basis.area() * state.radiosity.row(e.first).cwiseAbs().maxCoeff();
    Flux flux;
    for (const Element &e : state.forest.elements) {
        if (!e.leaf())
            continue;
        const Surface &surface = scene.surface(e.surface);
        const Rgb rho = scene.reflectance(e.surface), own = scene.exitance(e.surface);
        const auto b = radiosity_of(e, state);
        const double share = e.basis.area() * state.radiosity.row(e.first).cwiseAbs().maxCoeff() / power;
        const int n = std::max(8, static_cast<int>(share * rays / static_cast<double>(e.basis.n_tiles())));
        for (std::size_t tile = 0; tile < e.basis.n_tiles(); ++tile) {
            MovedHalton sequence(random);
            for (int i = 0; i < n; ++i) {
                const auto [s, t, a, c] = sequence.next();
                const QuadraturePoint q = e.basis.at_parameters(tile, s, t);
                if (reference::covered(surface, q.position))
                    continue;
                const double area = q.area / n;
                const Rgb value = (e.basis.evaluate(q).transpose() * b).transpose().array();
                flux.emitted += area * own;
                if (rho.minCoeff() > 0)
                    flux.absorbed += area * (1 - rho) * (value - own) / rho;
                const auto hit = reference::trace(scene, surface.frame.to_space(q.position),
                                                  reference::cosine_direction(surface.frame, a, c), 1e-9, 1e9);
                if (!hit || !hit->front || !scene.reflects(SurfaceId(hit->surface)))
                    flux.lost += area * value;
            }
        }
    }
    return flux;
}

/// A value of each channel and its standard error.
struct Estimate {
    Rgb mean = Rgb::Zero(), error = Rgb::Zero();
};

Estimate imbalance(const Scene &scene, const State &state, double rays) {
    constexpr std::size_t n = 16;
    std::array<Rgb, n> off;
    parallel_for(n, [&](std::size_t k) {
        const Flux f = follow(scene, state, rays, static_cast<std::uint32_t>(k));
        off[k] = (f.emitted - f.absorbed - f.lost) / f.emitted;
    });
    Estimate out;
    Rgb square = Rgb::Zero();
    for (const Rgb &o : off)
        out.mean += o / n;
    for (const Rgb &o : off)
        square += (o - out.mean).square() / (n * (n - 1.0));
    out.error = square.sqrt();
    return out;
}

} // namespace

std::vector<Measurement> balance(const Scene &scene, const State &state) {
    constexpr double largest_error = 0.001;
    Estimate found;
    for (double rays = 16000; rays < 1e6; rays *= 4) {
        found = imbalance(scene, state, rays);
        if (found.error.maxCoeff() < largest_error)
            break;
    }
    return {{"imbalance of energy, of what is emitted", found.mean.abs().maxCoeff(), 0.005},
            {"standard error of the imbalance", found.error.maxCoeff(), largest_error}};
}

std::vector<Measurement> properties(const Scene &scene, const Options &options, const State &state) {
    std::vector<Measurement> out{finite(state),
                                 not_below_black(scene, options, state),
                                 {"fixed point missed", state.counters.converged ? 0.0 : 1.0, 0}};
    const auto more = reciprocity(scene, options, state);
    out.insert(out.end(), more.begin(), more.end());
    return out;
}

Measurement agreement(const Scene &scene, const State &parametric, const State &planar) {
    const double reflected = reference::root_mean_square_reflected(scene, parametric);
    return {"difference of the two bases, of the reflected",
            reflected > 0 ? reference::root_mean_square_difference(scene, parametric, planar) / reflected : 0,
            parametric.counters.error_limit + planar.counters.error_limit};
}

} // namespace penumbra
