#include "scene/mend.h"

#include "core/error.h"
#include "geometry/ears.h"
#include "geometry/simple.h"
#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

void Notes::add(const std::string &kind, std::string text) {
    constexpr std::size_t whole = 3;
    Kind &k = kinds_[kind];
    ++k.n;
    if (k.first.size() < whole)
        k.first.push_back(std::move(text));
}

void Notes::append_to(std::vector<std::string> &notes) const {
    for (const auto &[kind, k] : kinds_) {
        notes.insert(notes.end(), k.first.begin(), k.first.end());
        if (const int more = k.n - static_cast<int>(k.first.size()); more > 0)
            notes.push_back(fmt::format("and {} more: {}", more, kind));
    }
}

namespace {

using Loop = std::vector<Vec3>;

/// Repeated corners are dropped, the last beside the first too.
Loop without_repeats(const Loop &loop) {
    Loop out;
    for (const Vec3 &x : loop)
        if (out.empty() || (x - out.back()).norm() > same_within)
            out.push_back(x);
    while (out.size() > 1 && (out.front() - out.back()).norm() <= same_within)
        out.pop_back();
    return out;
}

/// Corners on the straight line between their neighbours carry no shape, but rounding would make them reflex.
Loop without_straight_corners(Loop loop) {
    for (std::size_t i = 0; i < loop.size() && loop.size() > 3;) {
        const Vec3 &before = loop[(i + loop.size() - 1) % loop.size()], &after = loop[(i + 1) % loop.size()];
        const Vec3 along = after - before;
        if ((loop[i] - before).cross(along).norm() <= same_within * along.norm() && along.norm() > same_within)
            loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
    return loop;
}

double size_of(const Loop &loop) {
    Vec3 low = loop[0], high = loop[0];
    for (const Vec3 &x : loop) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return (high - low).norm();
}

/// Whether all corners lie on one line.
bool has_no_area(const Loop &loop) {
    if (loop.size() < 3)
        return true;
    const Vec3 far = *std::ranges::max_element(loop, {}, [&](const Vec3 &x) { return (x - loop[0]).squaredNorm(); });
    const Vec3 along = (far - loop[0]).normalized();
    return std::ranges::all_of(loop, [&](const Vec3 &x) { return (x - loop[0]).cross(along).norm() <= same_within; });
}

/// Frame of the mean plane: Newell's normal through the mean corner.
PlaneFrame mean_plane(const Loop &loop) {
    PlaneFrame frame = plane_frame(loop);
    frame.origin = Vec3::Zero();
    for (const Vec3 &x : loop)
        frame.origin += x / static_cast<double>(loop.size());
    return frame;
}

std::vector<Loop> triangles(const Loop &loop, const Polygon &outline) {
    std::vector<Loop> out;
    for (const auto &[a, b, c] : cut_ears(outline)) {
        const auto at = [&](int i) { return loop[static_cast<std::size_t>(i)]; };
        if (Loop triangle{at(a), at(b), at(c)}; !has_no_area(triangle))
            out.push_back(std::move(triangle));
    }
    return out;
}

} // namespace

std::vector<Loop> mend(const RawFace &face, Notes &notes) {
    Loop loop = without_repeats(face.corners);
    if (loop.size() < face.corners.size())
        notes.add("repeated corners dropped",
                  fmt::format("{}: {} repeated corners dropped", who(face), face.corners.size() - loop.size()));
    if (has_no_area(loop)) {
        notes.add("faces without area dropped", who(face) + " has no area: dropped");
        return {};
    }
    const double size = size_of(loop);
    const auto crossing = [&] {
        throw BadInput(who(face) + " crosses or touches itself; split it into simple polygons");
    };
    if (newell(loop).norm() <= same_within * size)
        crossing(); // as much area to the left as to the right
    const PlaneFrame plane = mean_plane(loop);
    Polygon outline;
    double bend = 0;
    for (const Vec3 &x : loop) {
        outline.push_back(plane.to_plane(x));
        bend = std::max(bend, std::abs(plane.height(x)) / size);
    }
    if (!is_simple(outline))
        crossing();
    if (bend > flat_within) {
        auto pieces = triangles(loop, outline);
        notes.add("bent faces cut into triangles", fmt::format("{} is bent by {:.2g} of its size: cut into {} triangles",
                                                               who(face), bend, pieces.size()));
        return pieces;
    }
    if (bend > 1e-3 * flat_within)
        notes.add("bent faces flattened", fmt::format("{} is bent by {:.2g} of its size: flattened", who(face), bend));
    if (bend > same_within) // else the corners stay those that neighbours share, to the last bit
        for (std::size_t i = 0; i < loop.size(); ++i)
            loop[i] = plane.to_space(outline[i]);
    return {without_straight_corners(std::move(loop))};
}

} // namespace penumbra
