#include "effects/plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <ranges>

namespace penumbra {

namespace {

constexpr double in_plane = 1e-12;    // heights below this count as in the plane
constexpr double proportional = 1e-12; // relative

auto surfaces_of(const Scene &scene) {
    return std::views::iota(0, scene.n_surfaces()) | std::views::transform([](int s) { return SurfaceId(s); });
}

bool any_in_front(const Surface &s, const PlaneFrame &plane) {
    return std::ranges::any_of(s.corners, [&](const Vec3 &x) { return plane.height(x) > in_plane; });
}

bool any_behind(const Surface &s, const PlaneFrame &plane) {
    return std::ranges::any_of(s.corners, [&](const Vec3 &x) { return plane.height(x) < -in_plane; });
}

bool may_see(const Surface &a, const Surface &b) { return any_in_front(a, b.frame) && any_in_front(b, a.frame); }

/// From the emitters on, what may see what shines already.
std::vector<char> lit_surfaces(const Scene &scene) {
    std::vector<char> lit(scene.surfaces.size(), 0);
    std::vector<SurfaceId> shining;
    for (const SurfaceId s : surfaces_of(scene))
        if (scene.emits(s))
            shining.push_back(s);
    while (!shining.empty()) {
        const SurfaceId from = shining.back();
        shining.pop_back();
        for (const SurfaceId to : surfaces_of(scene))
            if (to != from && !lit[to.at()] && may_see(scene.surface(from), scene.surface(to))) {
                lit[to.at()] = 1;
                if (scene.reflects(to) && !scene.emits(to))
                    shining.push_back(to);
            }
    }
    return lit;
}

std::vector<SurfaceId> bright_surfaces(const Scene &scene, const std::vector<char> &lit) {
    std::vector<SurfaceId> bright;
    for (const SurfaceId s : surfaces_of(scene))
        if (scene.reflects(s) && lit[s.at()])
            bright.push_back(s);
    return bright;
}

bool reflects_again(const Scene &scene, const std::vector<char> &lit) {
    const std::vector<SurfaceId> bright = bright_surfaces(scene, lit);
    for (std::size_t i = 0; i < bright.size(); ++i)
        for (std::size_t j = i + 1; j < bright.size(); ++j)
            if (may_see(scene.surface(bright[i]), scene.surface(bright[j])))
                return true;
    return false;
}

struct Box {
    Vec3 low, high;
};

Box box_of(const Surface &s) {
    Box box{s.corners.front(), s.corners.front()};
    for (const Vec3 &x : s.corners) {
        box.low = box.low.cwiseMin(x);
        box.high = box.high.cwiseMax(x);
    }
    return box;
}

/// No less than any form factor from a point of the one box to what lies in the other.
double form_factor_limit(const Box &a, const Box &b, double area) {
    const double distance2 = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0).squaredNorm();
    return distance2 * std::numbers::pi > area ? area / (distance2 * std::numbers::pi) : 1;
}

/// What a bounce can keep at most of reflected light, in L2. G is symmetric in dA, so that its norm is at most its largest row
/// sum (Schur's test): of form factors to all that shines by reflection, at most 1.
double kept_by_a_bounce(const Scene &scene, const std::vector<char> &lit) {
    const std::vector<SurfaceId> bright = bright_surfaces(scene, lit);
    std::vector<Box> boxes;
    for (const SurfaceId s : bright)
        boxes.push_back(box_of(scene.surface(s)));
    double reflectance = 0, gathered = 0;
    for (std::size_t i = 0; i < bright.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < bright.size(); ++j)
            if (i != j && may_see(scene.surface(bright[i]), scene.surface(bright[j])))
                sum += form_factor_limit(boxes[i], boxes[j], scene.surface(bright[j]).area);
        gathered = std::max(gathered, std::min(1.0, sum));
        if (sum > 0)
            reflectance = std::max(reflectance, scene.reflectance(bright[i]).maxCoeff());
    }
    return reflectance * gathered;
}

/// After how many bounces all that is still to come, q^n / (1 - q) of the first one, is no more than may be missed.
int bounces_that_weigh(double q, double may_miss) {
    constexpr double many = 1e6;
    if (q <= 0)
        return 1;
    return may_miss > 0 ? static_cast<int>(std::clamp(std::ceil(std::log(may_miss * (1 - q)) / std::log(q)), 1.0, many)) : static_cast<int>(many);
}

/// Whether two surfaces have the same corners and face away from each other.
bool back_to_back(const Surface &a, const Surface &b) {
    if (a.corners.size() != b.corners.size() || a.frame.normal.dot(b.frame.normal) > -0.5)
        return false;
    return std::ranges::all_of(a.corners, [&](const Vec3 &x) {
        return std::ranges::any_of(b.corners, [&](const Vec3 &y) { return (x - y).norm() <= in_plane; });
    });
}

std::vector<char> backs(const Scene &scene) {
    std::vector<char> is_back;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        is_back.push_back(scene.surfaces[s].back ||
                          std::any_of(scene.surfaces.begin(), scene.surfaces.begin() + static_cast<std::ptrdiff_t>(s),
                                      [&](const Surface &t) { return back_to_back(scene.surfaces[s], t); }));
    return is_back;
}

std::vector<char> blocking_surfaces(const Scene &scene) {
    std::vector<char> can_block;
    for (const Surface &b : scene.surfaces) {
        const bool front = std::ranges::any_of(scene.surfaces, [&](const Surface &s) { return any_in_front(s, b.frame); });
        const bool behind = std::ranges::any_of(scene.surfaces, [&](const Surface &s) { return any_behind(s, b.frame); });
        can_block.push_back(front && behind);
    }
    return can_block;
}

/// How many times the solution of channel k that of channel c is, if it is a multiple of it.
std::optional<double> proportion(const Scene &scene, int c, int k) {
    double sum_c = 0, sum_k = 0;
    for (const SurfaceId s : surfaces_of(scene)) {
        sum_c += scene.exitance(s)[c];
        sum_k += scene.exitance(s)[k];
    }
    if (sum_c == 0)
        return 0;
    const double factor = sum_c / sum_k;
    const auto alike = [&](SurfaceId s) {
        const Rgb &e = scene.exitance(s), &rho = scene.reflectance(s);
        return rho[c] == rho[k] && std::abs(e[c] - factor * e[k]) <= proportional * e[c];
    };
    return sum_k > 0 && std::ranges::all_of(surfaces_of(scene), alike) ? std::optional(factor) : std::nullopt;
}

Channels independent_channels(const Scene &scene) {
    Channels out;
    for (int c = 1; c < 3; ++c)
        for (int k = 0; k < c && out.of[static_cast<std::size_t>(c)] == c; ++k)
            if (const auto factor = out.of[static_cast<std::size_t>(k)] == k ? proportion(scene, c, k) : std::nullopt) {
                out.of[static_cast<std::size_t>(c)] = k;
                out.factor[static_cast<std::size_t>(c)] = *factor;
            }
    return out;
}

} // namespace

int Channels::n_solved() const {
    int n = 0;
    for (int c = 0; c < 3; ++c)
        n += of[static_cast<std::size_t>(c)] == c;
    return n;
}

bool Plan::anything_blocks() const { return can_block.empty() || std::ranges::find(can_block, 1) != can_block.end(); }

Plan make_plan(const Scene &scene, const EffectSwitches &switches, double may_miss) {
    const auto decides = [&](Effect e) { return switches[e] == Switch::automatic; };
    Plan plan;
    const std::vector<char> lit = lit_surfaces(scene);
    plan.is_back = backs(scene);
    plan.emission = decides(Effect::emission) ? std::ranges::any_of(surfaces_of(scene), [&](SurfaceId s) { return scene.emits(s); })
                                              : switches[Effect::emission] == Switch::on;
    plan.bounces = bounces_that_weigh(kept_by_a_bounce(scene, lit), may_miss);
    plan.interreflection = decides(Effect::interreflection) ? plan.bounces > 1
                                                            : switches[Effect::interreflection] == Switch::on;
    if (decides(Effect::two_sided))
        plan.lit = lit;
    else if (switches[Effect::two_sided] == Switch::off)
        for (const char back : plan.is_back)
            plan.lit.push_back(!back);
    if (decides(Effect::visibility))
        plan.can_block = blocking_surfaces(scene);
    else if (switches[Effect::visibility] == Switch::off)
        plan.can_block.assign(scene.surfaces.size(), 0);
    if (decides(Effect::colour))
        plan.channels = independent_channels(scene);
    else if (switches[Effect::colour] == Switch::off)
        plan.channels = {{0, 0, 0}, {1, 1, 1}};
    return plan;
}

Scene without_colour(Scene scene) {
    for (Material &m : scene.materials) {
        m.reflectance.setConstant(m.reflectance.mean());
        m.exitance.setConstant(m.exitance.mean());
    }
    return scene;
}

bool has_one_bounce(const Scene &scene) { return !reflects_again(scene, lit_surfaces(scene)); }

} // namespace penumbra
